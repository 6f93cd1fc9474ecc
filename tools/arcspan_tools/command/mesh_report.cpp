// SPDX-License-Identifier: MIT
#include <arcspan_tools/command/mesh_report.hpp>
#include <arcspan_tools/support/printable.hpp>
#include <arcspan_tools/support/text.hpp>
#include <nlohmann/json.hpp>

namespace arcspan::tools {
namespace {

std::string triple(const ObjectPosition& p) { return formatted("(%d, %d, %d)", p.x, p.y, p.z); }

std::size_t triangles(const MeshReport& r) { return r.compiled.mesh.indices.size() / 3; }

nlohmann::ordered_json corner(const ObjectPosition& p) { return {p.x, p.y, p.z}; }

}  // namespace

std::string to_text(const MeshReport& r) {
  const FixedMesh& mesh = r.compiled.mesh;
  std::string text = printable(r.model) + formatted(": %zu vertices, %zu triangles, %zu bytes",
                                                    r.model_vertices, r.model_triangles, r.model_bytes);
  if (r.dropped_faces > 0) text += formatted(", %zu faces without area left out", r.dropped_faces);
  text += "\n" + printable(r.output) +
          formatted(": %zu vertices, %zu triangles, %zu bytes, %d-bit indices%s\n", mesh.positions.size(),
                    triangles(r), r.bytes, fits_indices8(mesh.positions.size()) ? 8 : 16,
                    mesh.planes.empty() ? "" : ", planes");
  text += std::string("simplification: ") + to_string(r.compiled.how);
  if (r.compiled.how != Simplification::kNone) {
    text += formatted(", surface moved by about %.3g (%.2f %% of the extent)", r.compiled.error,
                      100 * r.compiled.error / r.model_extent);
  }
  text += "\nbounds: " + triple(r.figures.bounds.low) + " ... " + triple(r.figures.bounds.high) +
          formatted(", one step is %.6g of the model's units\n", mesh.unit);
  text += formatted("vertex cache of 16: %.2f misses per triangle, %.2f before\n", r.compiled.cache_misses,
                    r.compiled.cache_misses_before);
  text += formatted("widest normal angle of a triangle: %.1f degrees; %zu of %zu triangles above 60\n",
                    r.figures.widest_angle_degrees, r.figures.wide_triangles, triangles(r));
  return text;
}

std::string to_json(const MeshReport& r) {
  const FixedMesh& mesh = r.compiled.mesh;
  const nlohmann::ordered_json json = {
      {"model",
       {{"name", r.model},
        {"vertices", r.model_vertices},
        {"triangles", r.model_triangles},
        {"bytes", r.model_bytes},
        {"dropped_faces", r.dropped_faces}}},
      {"mesh",
       {{"file", r.output},
        {"vertices", mesh.positions.size()},
        {"triangles", triangles(r)},
        {"bytes", r.bytes},
        {"index_bits", fits_indices8(mesh.positions.size()) ? 8 : 16},
        {"planes", !mesh.planes.empty()},
        {"low", corner(r.figures.bounds.low)},
        {"high", corner(r.figures.bounds.high)},
        {"unit", mesh.unit},
        {"centre", {mesh.centre.x, mesh.centre.y, mesh.centre.z}}}},
      {"simplification", {{"method", to_string(r.compiled.how)}, {"error", r.compiled.error}}},
      {"cache_misses_per_triangle",
       {{"before", r.compiled.cache_misses_before}, {"after", r.compiled.cache_misses}}},
      {"widest_normal_angle_degrees", r.figures.widest_angle_degrees},
      {"triangles_above_60_degrees", r.figures.wide_triangles},
  };
  // Names of files may be any bytes.
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string warning(const MeshReport& r) {
  if (r.figures.wide_triangles == 0) return {};
  return formatted(
      "%zu of %zu triangles have normals more than 60 degrees apart, which makes them slower to draw and "
      "look "
      "bent (keep more triangles, or more edges sharp by --crease 60 or a smaller angle)",
      r.figures.wide_triangles, triangles(r));
}

}  // namespace arcspan::tools
