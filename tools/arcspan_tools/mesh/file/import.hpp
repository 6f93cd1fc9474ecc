// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/load.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace arcspan::tools {

/// Where a triangle comes from: the numbers of its face and of its corners (see TaggedObj).
struct TriangleSource {
  std::uint32_t face = 0;
  std::array<std::uint32_t, 3> vertices{};
};

/// The triangles of a mesh file.
struct ImportedMesh {
  std::vector<std::array<RawMesh::Corner, 3>> triangles;
  std::vector<TriangleSource> sources;  ///< of each triangle, or empty if the file had no tags
  std::string looks{};                  ///< of a scene: see import_mesh()
};

/// Whether a format is one that the library reads with nodes, materials and textures.
[[nodiscard]] constexpr bool is_scene(MeshFormat format) {
  return format == MeshFormat::kCollada || format == MeshFormat::k3ds;
}

/// Reads screened mesh bytes (see validate.hpp) with the loader library. Polygons are triangulated; points
/// and lines are ignored. The only file of this project that knows the library.
///
/// A scene is read as it is, with its nodes' transforms and with texture points. The face of a triangle's
/// source is then an index into a JSON array in `looks`, whose elements have names, material, diffuse,
/// specular, emission, shininess, texture and two_sided.
[[nodiscard]] ImportedMesh import_mesh(std::string_view screened, MeshFormat format,
                                       const std::string& subject);

}  // namespace arcspan::tools
