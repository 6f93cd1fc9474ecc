// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/vertex/rotation.hpp>

#include <cstdint>

namespace arcspan {

/// The object's place before the camera: view = rotation * object + translation. View space is right-handed,
/// the camera looks along -z, and y is up. `rotation` must be orthonormal (its rows within 2^-20 of unit
/// length). A uniform scale belongs into the object's unit.
struct Placement {
  Rotation rotation;
  ObjectLength translation[3];
};

/// A pinhole camera, 0 < near_plane < far_plane.
struct Projection {
  PixelLength focal;        ///< distance of the picture plane: (height / 2) / tan(vertical field of view / 2)
  ObjectLength near_plane;  ///< nearer parts are clipped
  ObjectLength far_plane;   ///< farther parts are clipped
};

/// The picture's size in pixels, each 1...2048 (the guard band).
struct Viewport {
  std::int32_t width = 0;
  std::int32_t height = 0;

  friend constexpr bool operator==(const Viewport&, const Viewport&) = default;
};

/// A placement and a camera in wide formats, for ClipTransform::set_placement(). Lengths have 8 fraction bits
/// and are in units of 2^unit_bits object units, so that an object may be farther away than Placement allows,
/// and a near one is placed more precisely.
struct WidePlacement {
  Rotation rotation;            ///< as in Placement
  std::int64_t translation[3];  ///< at most 2^30 in magnitude
  std::int64_t near_plane = 1;  ///< 1...2^31 - 1
  std::int32_t focal = 1;       ///< above 0; times 2^focal_bits it is a PixelLength's raw()
  int focal_bits = 0;           ///< -30...21
  int unit_bits = 0;            ///< kLeastUnitBits...kMostUnitBits; above 0 no back faces are found by planes
  std::int64_t far_plane = kNoFarPlane;  ///< near_plane + 1...kNoFarPlane, which is farther than any vertex
  static constexpr int kLeastUnitBits = -8;
  static constexpr int kMostUnitBits = 24;
  static constexpr std::int64_t kNoFarPlane = std::int64_t{1} << 35;
};

}  // namespace arcspan
