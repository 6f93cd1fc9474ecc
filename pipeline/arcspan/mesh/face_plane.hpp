// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace arcspan {

/// The plane of a triangle in 4 bytes, for culling in object space (MeshView::attach). With n the unit normal
/// of the front, a a vertex in object units and h the triangle's least altitude, (x, y, z) is
/// h * n * 2^normal_bits and `offset` h * (n·a) * 2^(normal_bits - offset_bits), each rounded to nearest; all
/// 0 if the triangle has no area. The altitude tells how far from edge-on the triangle must be seen for its
/// picture to keep its side when vertices snap to the raster.
struct FacePlane {
  std::int8_t x = 0;
  std::int8_t y = 0;
  std::int8_t z = 0;
  std::int8_t offset = 0;

  friend constexpr bool operator==(const FacePlane&, const FacePlane&) = default;
};

/// What the planes of one mesh have in common.
struct PlaneScale {
  static constexpr int kMostNormalBits = 8;
  static constexpr int kLeastNormalBits = -12;
  static constexpr int kMostOffsetBits = 17;

  std::int8_t normal_bits = 0;   ///< kLeastNormalBits ... kMostNormalBits
  std::uint8_t offset_bits = 0;  ///< 0 ... kMostOffsetBits
  std::uint16_t reach = 0;       ///< no vertex is farther from the object's origin, in object units

  friend constexpr bool operator==(const PlaneScale&, const PlaneScale&) = default;
};

}  // namespace arcspan
