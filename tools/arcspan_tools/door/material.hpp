// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour.hpp>
#include <arcspan/shading/illumination.hpp>

#include <arcspan_tools/support/vec3.hpp>

namespace arcspan::tools {

/// A surface in doubles: pixel = colour * (ambient + diffuse * max(0, N·L)) + specular * highlight. All
/// 0...1.
struct Surface {
  Vec3 colour{0.86, 0.52, 0.30};
  double ambient = 0.14;
  double diffuse = 0.78;
  double specular = 0.45;
  std::int32_t shininess = 40;
};

/// The pipeline's form of `surface`; the highlight is white. Values outside 0...1 are clamped.
[[nodiscard]] Material to_fixed(const Surface& surface);

/// A colour of three channels 0...1 in 8 bits.
[[nodiscard]] Rgb8 to_rgb8(Vec3 colour);

}  // namespace arcspan::tools
