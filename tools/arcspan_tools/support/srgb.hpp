// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/support/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace arcspan::tools {

/// A channel of linear light as a display value by the transfer function of sRGB (IEC 61966-2-1); both 0...1,
/// what is outside is clamped.
[[nodiscard]] inline double to_srgb(double linear) {
  const double v = std::clamp(linear, 0.0, 1.0);
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

[[nodiscard]] inline Vec3 to_srgb(Vec3 linear) {
  return {to_srgb(linear.x), to_srgb(linear.y), to_srgb(linear.z)};
}

}  // namespace arcspan::tools
