// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/status.hpp>

#include <cstdint>

namespace arcspan {

/// Options of draw_mesh(), chosen at run time.
struct DrawOptions {
  bool two_sided = false;  ///< draws back faces too, lit with the opposite normals
};

/// The result of draw_mesh().
struct DrawResult {
  Status status = Status::kOk;
  /// Triangles of the mesh that have a part in the common bounds of the viewport and the sink. In a picture
  /// drawn in bands, every band counts those that reach it.
  std::uint32_t triangles = 0;
  /// Triangles that needed clipping and were not drawn, because DrawFeatures::clips is off.
  std::uint32_t left_out = 0;
};

/// Features of draw_mesh(), chosen at compile time. Switching one off saves code (docs/memory.md has the
/// bytes).
struct DrawFeatures {
  /// Draws triangles across a clip plane. Off: they are not drawn, but counted as left_out.
  bool clips = true;
  /// Culls by the face planes of a mesh that has them. Off: backs are culled after their vertices are
  /// transformed, which gives the same pixels.
  bool planes = true;
  /// Draws small triangles (prepare/small_triangle.hpp) without edges and planes, where the method can. Off:
  /// they are drawn as large ones, whose pixels may differ within the method's accuracy.
  bool small_triangles = true;
};

}  // namespace arcspan
