// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/mesh_data.hpp>

namespace arcspan::tools {

/// The box in which to_fixed() gives a model this unit and centre.
[[nodiscard]] inline Box box_of_units(Vec3 centre, double unit) {
  constexpr double kHalf = 32767;
  const Vec3 half = Vec3{1, 1, 1} * (kHalf * unit);
  return {centre - half, centre + half};
}

}  // namespace arcspan::tools
