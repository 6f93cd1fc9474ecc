// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/numbers/formats.hpp>
#include <arcspan/status.hpp>
#include <arcspan/vertex/rotation.hpp>

#include <cstdint>

namespace arcspan {

/// Half the width of the guard band in pixels: projected vertices lie within +-1024 of the viewport's middle.
inline constexpr std::int32_t kGuardBand = 1024;

/// Where the object stands before the camera: view = rotation * object + translation. Right-handed, the
/// camera looks along -z, y is up. `rotation` must be orthonormal (rows within 2^-20 of unit length are); a
/// uniform scale belongs into the units of the object.
struct Placement {
  Rotation rotation;
  ObjectLength translation[3];
};

/// A pinhole camera. `focal` is the distance of the picture plane in pixels: (height / 2) / tan(fov / 2).
/// 0 < near < far, in object units; nearer parts are clipped, farther ones share the last depth.
struct Projection {
  PixelLength focal;
  ObjectLength near_plane;
  ObjectLength far_plane;
};

/// The picture's size in pixels, each 1...2048 (the guard band).
struct Viewport {
  std::int32_t width = 0;
  std::int32_t height = 0;
};

/// A vertex before the division: inside the guard band -w <= x <= w and -w <= y <= w, y downwards; in front
/// of the near plane w >= ClipTransform::near_w(). All of one scale, |value| < 2^30.
struct ClipPosition {
  std::int32_t x;
  std::int32_t y;
  std::int32_t w;
};

/// Object space to clip space, and the depth of a clip-space vertex. Made once per object and frame.
class ClipTransform {
 public:
  constexpr ClipTransform() = default;

  /// kInvalidArgument if the viewport, the focal length (0 excluded) or the planes are out of range, or if
  /// the object is so far off (more than 2^22 units) that the numbers would not hold it.
  static Status make(const Placement& placement, const Projection& projection, const Viewport& viewport,
                     ClipTransform& transform);

  [[nodiscard]] ClipPosition operator()(ObjectPosition p) const { return {row(0, p), row(1, p), row(2, p)}; }

  [[nodiscard]] std::int32_t near_w() const { return near_w_; }
  [[nodiscard]] const Viewport& viewport() const { return viewport_; }

  /// Depth of a vertex at near_w() / w = `near_over_w` (29 fraction bits): 16 bits, nearer is smaller, linear
  /// on the screen. Stays kDepthMargin away from both ends, so that stepping it cannot wrap.
  [[nodiscard]] std::uint16_t depth(std::int32_t near_over_w) const {
    const std::int32_t beyond = (std::int32_t{1} << 29) - near_over_w;
    if (beyond <= 0) return static_cast<std::uint16_t>(kDepthMargin);
    const std::int32_t depth = kDepthMargin + (multiply_high(depth_range_, beyond) >> depth_shift_);
    return static_cast<std::uint16_t>(depth > 65535 - kDepthMargin ? 65535 - kDepthMargin : depth);
  }

  static constexpr std::int32_t kDepthMargin = 256;

 private:
  /// An entry of the matrix in two parts, 15 bits with the sign and 14: products with 16-bit positions, and
  /// sums of three, fit 32 bits. |entry| < 2^28.
  struct Entry {
    std::int32_t high;
    std::int32_t low;
  };

  [[nodiscard]] std::int32_t row(int i, ObjectPosition p) const {
    const Entry* const m = matrix_[i];
    const std::int32_t high =
        wrap_add(wrap_add(wrap_mul(m[0].high, p.x), wrap_mul(m[1].high, p.y)), wrap_mul(m[2].high, p.z));
    const std::int32_t low = m[0].low * p.x + m[1].low * p.y + m[2].low * p.z;
    return wrap_add(wrap_add(high, offset_[i]), low >> 14);
  }

  Entry matrix_[3][3] = {};
  std::int32_t offset_[3] = {};
  std::int32_t near_w_ = 1;
  std::int32_t depth_range_ = 0;  ///< times 2^-(depth_shift_ - 3)
  std::int32_t depth_shift_ = 0;
  Viewport viewport_{};
};

}  // namespace arcspan
