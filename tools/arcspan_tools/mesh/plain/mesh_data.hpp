// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour.hpp>

#include <arcspan_tools/support/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// Most vertices of a mesh of the pipeline, whose indices have 16 bits. Larger ones become several.
inline constexpr std::size_t kMaxVertices = 65'536;
/// Most triangles of a model.
inline constexpr std::size_t kMaxTriangles = 1'048'576;

/// The largest number in a mesh file, for which products of three still fit a double.
inline constexpr double kMostCoordinate = 1e30;

/// A vertex that no rig moves (see rig.hpp).
inline constexpr std::uint32_t kNoSource = 0xFFFFFFFF;

/// How far the texture points of a mesh may be apart in each direction, in widths or heights of the texture:
/// the pipeline's have 16 bits, of which 4 are fraction bits at least.
inline constexpr double kMostTextures = 4000;

/// A point of a texture in its widths and heights. `u` runs to the right and `v` down from the top left
/// corner.
struct Uv {
  double u = 0;
  double v = 0;

  friend constexpr bool operator==(const Uv&, const Uv&) = default;
};

/// A box along the axes.
struct Box {
  Vec3 low;
  Vec3 high;
};

/// A triangle mesh in doubles: position i, normal i (unit length) and texture point i belong together;
/// triangles are counter-clockwise seen from the front.
struct MeshData {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;
  std::vector<Uv> texture_points{};  ///< empty, or one for each vertex
  std::vector<Rgb8> colours{};       ///< empty, or one for each vertex
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// Faces of the file that have no area, left out of `triangles`.
  std::size_t dropped_faces = 0;
  /// Empty, or for each vertex an index into the vertices of the model's rig, or kNoSource.
  std::vector<std::uint32_t> sources{};
};

/// Triangles whose corners carry their own copies of positions and normals, as loaders give them.
struct RawMesh {
  struct Corner {
    Vec3 position;
    /// Zero where the file gives no normal.
    Vec3 normal;
    std::optional<Uv> texture_point{};
    std::optional<Rgb8> colour{};      ///< all corners of a part have one, or none
    std::uint32_t source = kNoSource;  ///< an index into the vertices of the model's rig
  };
  /// The smoothing group of triangles whose corners without a normal get that of their own triangle.
  static constexpr std::uint32_t kFlat = 0;
  static constexpr std::uint32_t kSmooth = 1;

  std::vector<std::array<Corner, 3>> triangles;
  /// Empty, or the smoothing group of each triangle: kFlat, or any other number; kSmooth if empty.
  std::vector<std::uint32_t> smoothing{};
};

/// Joins corners of equal position and normal into vertices, without texture points. Corners without a normal
/// get the area-weighted average over all triangles of their smoothing group that share the position.
/// Triangles without area are dropped and counted. `subject` names the mesh in the Failure that is thrown if
/// a limit is passed or nothing is left.
[[nodiscard]] MeshData weld(const RawMesh& raw, const std::string& subject);

}  // namespace arcspan::tools
