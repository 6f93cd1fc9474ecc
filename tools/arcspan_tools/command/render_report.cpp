// SPDX-License-Identifier: MIT
#include <arcspan_tools/command/render_report.hpp>
#include <arcspan_tools/support/printable.hpp>
#include <arcspan_tools/support/text.hpp>
#include <nlohmann/json.hpp>

namespace arcspan::tools {

std::string crease_text(const std::optional<double>& degrees) {
  return degrees ? formatted(", no normals: edges above %g degrees are sharp (--crease)", *degrees) : "";
}

nlohmann::ordered_json crease_json(const std::optional<double>& degrees) {
  return degrees ? nlohmann::ordered_json(*degrees) : nlohmann::ordered_json();
}

std::string to_text(const RenderReport& r) {
  const RenderStats& s = r.stats;
  std::string text = printable(r.mesh_name) + ": " + std::to_string(r.vertices) + " vertices, " +
                     std::to_string(r.mesh_triangles) + " triangles";
  if (r.parts > 1) text += ", " + std::to_string(r.parts) + " parts";
  if (r.dropped_faces > 0) text += ", " + std::to_string(r.dropped_faces) + " faces without area left out";
  text += crease_text(r.crease_degrees) + "\n" + printable(r.output) + ": " + std::to_string(r.width) + "x" +
          std::to_string(r.height) + ", " + r.shading + " shading, " + r.format + "\n";
  text += formatted("drawn: %u triangles, %llu spans, %llu pixels\n", s.triangles,
                    static_cast<unsigned long long>(s.spans), static_cast<unsigned long long>(s.pixels));
  text += formatted("time: %.1f ms to load, %.2f ms to draw\n", r.load_milliseconds, s.draw_milliseconds);
  if (!r.outlines.empty())
    text += formatted("%s: %zu outline edges, %.2f ms\n", r.outlines.c_str(), s.outline_edges,
                      s.smooth_milliseconds);
  text += formatted("pipeline memory: %zu bytes (mesh %zu, frame %zu, depth %zu, vertex cache %zu",
                    r.memory_bytes(), r.mesh_bytes, s.frame_bytes, s.depth_bytes, s.cache_bytes);
  if (!r.outlines.empty()) text += formatted(", outlines %zu", s.outline_bytes);
  return text + ")\n";
}

std::string to_json(const RenderReport& r) {
  const RenderStats& s = r.stats;
  nlohmann::ordered_json json = {
      {"mesh",
       {{"name", r.mesh_name},
        {"vertices", r.vertices},
        {"triangles", r.mesh_triangles},
        {"parts", r.parts},
        {"dropped_faces", r.dropped_faces},
        {"crease_degrees", crease_json(r.crease_degrees)}}},
      {"picture",
       {{"file", r.output},
        {"width", r.width},
        {"height", r.height},
        {"shading", r.shading},
        {"format", r.format},
        {"bands", s.bands}}},
      {"drawn", {{"triangles", s.triangles}, {"spans", s.spans}, {"pixels", s.pixels}}},
      {"milliseconds", {{"load", r.load_milliseconds}, {"draw", s.draw_milliseconds}}},
      {"bytes",
       {{"total", r.memory_bytes()},
        {"mesh", r.mesh_bytes},
        {"frame", s.frame_bytes},
        {"depth", s.depth_bytes},
        {"vertex_cache", s.cache_bytes}}},
  };
  if (!r.outlines.empty()) {
    json["drawn"]["outline_edges"] = s.outline_edges;
    json["milliseconds"]["smooth"] = s.smooth_milliseconds;
    json["bytes"]["outlines"] = s.outline_bytes;
  }
  // Names of files may be any bytes.
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace arcspan::tools
