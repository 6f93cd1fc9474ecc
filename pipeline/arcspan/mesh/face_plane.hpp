// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// The plane of a triangle in 4 bytes, for culling back faces in object space (MeshView::attach).
///
/// Let n be the unit normal of the front, a any vertex in object units, and h the triangle's least altitude.
/// Then (x, y, z) is h * n * 2^normal_bits and `offset` is h * (n·a) * 2^(normal_bits - offset_bits), each
/// rounded to nearest; all are 0 if the triangle has no area. The factor h decides how far from edge-on a
/// triangle must be seen so that its picture keeps its side when vertices snap to the raster.
struct FacePlane {
  std::int8_t x = 0;
  std::int8_t y = 0;
  std::int8_t z = 0;
  std::int8_t offset = 0;

  friend constexpr bool operator==(const FacePlane&, const FacePlane&) = default;
};

/// The scale of all planes of a mesh, and the mesh's radius.
struct PlaneScale {
  static constexpr int kMostNormalBits = 8;
  static constexpr int kLeastNormalBits = -12;
  static constexpr int kMostOffsetBits = 17;

  std::int8_t normal_bits = 0;   ///< kLeastNormalBits ... kMostNormalBits
  std::uint8_t offset_bits = 0;  ///< 0 ... kMostOffsetBits
  std::uint16_t radius = 0;      ///< no vertex is farther from the object's origin, in object units

  friend constexpr bool operator==(const PlaneScale&, const PlaneScale&) = default;

  /// True if the bits are in range.
  [[nodiscard]] constexpr bool valid() const {
    return normal_bits >= kLeastNormalBits && normal_bits <= kMostNormalBits &&
           offset_bits <= kMostOffsetBits;
  }
};

}  // namespace arcspan
