// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/compile/simplify.hpp>
#include <arcspan_tools/mesh/plain/crease.hpp>
#include <arcspan_tools/mesh/plain/positions.hpp>
#include <arcspan_tools/mesh/plain/subset.hpp>
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace arcspan::tools {
namespace {

/// As the library takes them: single precision, around the origin, so that meshes far from it lose nothing.
/// The vertices of all parts one after the other, so that a vertex belongs to one part.
struct LibraryMesh {
  std::vector<float> positions;
  std::vector<unsigned> indices;
  std::vector<std::size_t> first_vertices;  ///< of each part
  double scale = 1;  ///< of the library's errors, which are relative to the largest extent

  [[nodiscard]] std::size_t vertices() const { return positions.size() / 3; }
};

/// The vertices of parts that have these positions; no indices.
LibraryMesh to_library(const std::vector<std::vector<Vec3>>& parts) {
  Vec3 low = parts[0][0];
  Vec3 high = parts[0][0];
  for (const std::vector<Vec3>& points : parts) {
    for (const Vec3& p : points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  LibraryMesh out;
  out.scale = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  for (const std::vector<Vec3>& points : parts) {
    out.first_vertices.push_back(out.vertices());
    for (const Vec3& p : points) {
      const Vec3 unit = (p - low) * (1 / out.scale);
      for (const double c : {unit.x, unit.y, unit.z}) out.positions.push_back(static_cast<float>(c));
    }
  }
  return out;
}

/// The indices that the library leaves of `from`; adds to `error` what it moves, relative to the extent.
std::vector<unsigned> run_library(const LibraryMesh& mesh, const std::vector<unsigned>& from,
                                  Simplification how, std::size_t triangles, double& error) {
  constexpr float kAnyError = 1;
  constexpr std::size_t kStride = 3 * sizeof(float);
  std::vector<unsigned> to(from.size());
  float moved = 0;
  const std::size_t left =
      how == Simplification::kByCells
          ? meshopt_simplifySloppy(to.data(), from.data(), from.size(), mesh.positions.data(),
                                   mesh.vertices(), kStride, 3 * triangles, kAnyError, &moved)
          : meshopt_simplify(to.data(), from.data(), from.size(), mesh.positions.data(), mesh.vertices(),
                             kStride, 3 * triangles, kAnyError, 0, &moved);
  to.resize(left);
  error = std::max(error, static_cast<double>(moved));
  return to;
}

using TriangleList = std::vector<std::array<std::uint32_t, 3>>;

/// The triangles of each part, whose indices count from its own first vertex.
std::vector<TriangleList> by_part(const LibraryMesh& mesh, const std::vector<unsigned>& indices) {
  std::vector<TriangleList> parts(mesh.first_vertices.size());
  const auto& first = mesh.first_vertices;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const auto part =
        static_cast<std::size_t>(std::upper_bound(first.begin(), first.end(), indices[i]) - first.begin()) -
        1;
    const auto own = [&](std::size_t k) { return static_cast<std::uint32_t>(indices[i + k] - first[part]); };
    parts[part].push_back({own(0), own(1), own(2)});
  }
  return parts;
}

/// The parts of `model` that still have triangles, reduced to them.
Model reduced(const Model& model, const LibraryMesh& library, const std::vector<unsigned>& indices) {
  Model out;
  out.dropped_faces = model.dropped_faces;
  out.rig = model.rig;
  out.reach = model.reach;
  const std::vector<TriangleList> parts = by_part(library, indices);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].empty()) continue;
    out.parts.push_back({model.parts[i].look, subset(model.parts[i].mesh, parts[i])});
  }
  return out;
}

bool has_area(const MeshData& mesh) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&mesh](const auto& t) {
    const Vec3& a = mesh.positions[t[0]];
    return length(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a)) > 0;
  });
}

/// The library's form of a model; its indices are those of the triangles.
LibraryMesh to_library(const Model& model) {
  std::vector<std::vector<Vec3>> positions;
  for (const ModelPart& part : model.parts) positions.push_back(part.mesh.positions);
  LibraryMesh library = to_library(positions);
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    for (const auto& t : model.parts[i].mesh.triangles) {
      for (const std::uint32_t vertex : t) {
        library.indices.push_back(static_cast<unsigned>(library.first_vertices[i]) + vertex);
      }
    }
  }
  return library;
}

Simplified with_normals(const Model& model, std::size_t triangles) {
  const LibraryMesh library = to_library(model);
  double error = 0;
  const std::vector<unsigned> left =
      run_library(library, library.indices, Simplification::kWithNormals, triangles, error);
  return {reduced(model, library, left), error * library.scale};
}

/// `mesh` with one vertex for each position; the normals are none.
MeshData joined_by_position(const MeshData& mesh) {
  Positions positions = positions_of(mesh.positions);
  MeshData joined = mesh;
  joined.normals.assign(positions.points.size(), Vec3{});
  joined.positions = std::move(positions.points);
  for (auto& t : joined.triangles) {
    for (std::uint32_t& vertex : t) vertex = positions.ids[vertex];
  }
  return joined;
}

/// `mesh` with one vertex for each position, texture point and colour; the normals are none.
MeshData joined_by_surface(const MeshData& mesh) {
  using RgbKey = std::tuple<std::uint8_t, std::uint8_t, std::uint8_t>;
  std::map<std::tuple<double, double, double, double, double, RgbKey>, std::uint32_t> known;
  MeshData joined;
  joined.dropped_faces = mesh.dropped_faces;
  joined.triangles = mesh.triangles;
  for (auto& t : joined.triangles) {
    for (std::uint32_t& vertex : t) {
      const Vec3& p = mesh.positions[vertex];
      const Uv point = mesh.texture_points.empty() ? Uv{} : mesh.texture_points[vertex];
      const Rgb8 c = mesh.colours.empty() ? Rgb8{} : mesh.colours[vertex];
      const auto next = static_cast<std::uint32_t>(joined.positions.size());
      const auto [at, is_new] =
          known.try_emplace({p.x, p.y, p.z, point.u, point.v, RgbKey{c.r, c.g, c.b}}, next);
      if (is_new) {
        joined.positions.push_back(p);
        joined.normals.emplace_back();
        if (!mesh.texture_points.empty()) joined.texture_points.push_back(point);
        if (!mesh.colours.empty()) joined.colours.push_back(c);
      }
      vertex = at->second;
    }
  }
  return joined;
}

/// `model` with as few vertices as its positions, texture points and colours need; the normals are none.
Model without_normals(const Model& model) {
  Model joined = model;
  for (ModelPart& part : joined.parts) {
    const bool bare = part.mesh.texture_points.empty() && part.mesh.colours.empty();
    part.mesh = bare ? joined_by_position(part.mesh) : joined_by_surface(part.mesh);
  }
  return joined;
}

/// Clusters parts one by one, because clusters know nothing of parts. Each gets its share of the triangles.
std::vector<unsigned> clustered(const LibraryMesh& library, std::size_t triangles, double& error) {
  std::vector<unsigned> left;
  for (std::size_t begin = 0; begin < library.indices.size();) {
    const auto& first = library.first_vertices;
    const auto next = std::upper_bound(first.begin(), first.end(), library.indices[begin]);
    std::size_t end = begin;
    while (end < library.indices.size() && (next == first.end() || library.indices[end] < *next)) ++end;
    const std::vector<unsigned> own(library.indices.begin() + static_cast<std::ptrdiff_t>(begin),
                                    library.indices.begin() + static_cast<std::ptrdiff_t>(end));
    const std::size_t share = std::max<std::size_t>(triangles * own.size() / library.indices.size(), 1);
    const std::vector<unsigned> few = run_library(library, own, Simplification::kByCells, share, error);
    left.insert(left.end(), few.begin(), few.end());
    begin = end;
  }
  return left;
}

Simplified by_position(const Model& model, Simplification how, std::size_t triangles, double crease_degrees,
                       const std::string& subject) {
  const Model joined = without_normals(model);
  const LibraryMesh library = to_library(joined);
  double error = 0;
  const std::vector<unsigned> left = how == Simplification::kByCells
                                         ? clustered(library, triangles, error)
                                         : run_library(library, library.indices, how, triangles, error);
  const Model few = reduced(joined, library, left);
  if (std::none_of(few.parts.begin(), few.parts.end(), [](const ModelPart& p) { return has_area(p.mesh); })) {
    return {};
  }
  return {with_crease(few, crease_degrees, subject), error * library.scale};
}

}  // namespace

const char* to_string(Simplification how) {
  switch (how) {
    case Simplification::kNone:
      return "none";
    case Simplification::kWithNormals:
      return "edge collapse, normals kept";
    case Simplification::kByPosition:
      return "edge collapse, normals made anew";
    case Simplification::kByCells:
      break;
  }
  return "clustering, normals made anew";
}

Simplified simplify(const Model& model, Simplification how, std::size_t triangles, double crease_degrees,
                    const std::string& subject) {
  switch (how) {
    case Simplification::kNone:
      return {model, 0};
    case Simplification::kWithNormals:
      return with_normals(model, triangles);
    case Simplification::kByPosition:
    case Simplification::kByCells:
      break;
  }
  return by_position(model, how, triangles, crease_degrees, subject);
}

}  // namespace arcspan::tools
