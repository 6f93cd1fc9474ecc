// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/model.hpp>

#include <optional>
#include <string>

namespace arcspan::tools {

/// A mesh made from a formula: `kind:AROUNDxALONG`.
struct GeneratedMesh {
  enum class Kind { kSphere, kTorus };
  Kind kind = Kind::kSphere;
  /// Segments around the axis (y), at least 3.
  std::int32_t around = 0;
  /// Sphere: bands from pole to pole, at least 2. Torus: segments around the tube, at least 3.
  std::int32_t along = 0;
};

/// `sphere:32x16` or `torus:48x24`; nothing if the name does not start like one. Throws Failure for one whose
/// numbers are missing, too small, or give more than kMaxVertices vertices.
[[nodiscard]] std::optional<GeneratedMesh> parse_generated_mesh(const std::string& name);

/// The unit sphere, or the torus of radius 1 with a tube of radius 0.4, each with exact normals.
[[nodiscard]] MeshData generate(const GeneratedMesh& wanted);

/// The triangles of generate() with texture points. A picture is wrapped once around the axis, its middle
/// column at +z and its columns to the right; on a sphere from pole to pole, on a torus once around the tube.
[[nodiscard]] RawModel generate_with_texture_points(const GeneratedMesh& wanted);

}  // namespace arcspan::tools
