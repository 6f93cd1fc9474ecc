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
  std::uint32_t left_out =
      0;  ///< triangles that needed clipping and were not drawn, as DrawFeatures::clips is off
};

/// Features of draw_mesh(), chosen at compile time. Switching one off saves code (docs/memory.md has the
/// bytes).
struct DrawFeatures {
  bool clips =
      true;  ///< draws triangles across the near plane or the guard band; else counts them as left_out
  bool two_sided = true;  ///< DrawOptions::two_sided works; else it returns kUnsupported
  bool caches = true;     ///< uses a vertex cache if one is given
  bool planes = true;     ///< culls by the face planes of a mesh that has them
  /// draws triangles of up to 12x12 pixels, and those of up to 31x31 that are dark or consist of arcs,
  /// without edges and planes, where the method can (DrawsSmallTriangles). It changes pixels within the
  /// method's accuracy.
  bool small_triangles = true;
  bool whole_rows = true;  ///< second row loop for triangles within the scissor's columns; no effect at -Os
};

}  // namespace arcspan
