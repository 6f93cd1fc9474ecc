// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/support/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace arcspan::tools {

/// The triangles that a polygon of three corners or more is made of, as indices of its corners: always two
/// fewer than it has corners, in its direction of rotation. A concave polygon is clipped ear by ear, as seen
/// along its normal. One that crosses itself or is not plane gets triangles, too, but they may overlap. The
/// time grows with the square of the number of corners at most.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangulated(std::span<const Vec3> polygon);

}  // namespace arcspan::tools
