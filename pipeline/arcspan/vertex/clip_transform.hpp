// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/rotation.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// Half the width of the guard band in pixels: projected vertices are at most this far from the viewport's
/// middle in x and in y.
inline constexpr std::int32_t kGuardBand = 1024;

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
  ObjectLength far_plane;   ///< farther parts share the last depth
};

/// The picture's size in pixels, each 1...2048 (the guard band).
struct Viewport {
  std::int32_t width = 0;
  std::int32_t height = 0;
};

/// A vertex in clip space, before the division by w; y points down. It is inside the guard band if |x| <= w
/// and |y| <= w, and in front of the near plane if w >= ClipTransform::near_w(). The three have the same
/// scale (ClipTransform::w_bits()) and are below 2^30 in magnitude.
struct ClipPosition {
  std::int32_t x;
  std::int32_t y;
  std::int32_t w;
};

/// A point in object units that may lie outside the range of vertices: |coordinate| < 2^24.
struct ObjectPoint {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t z = 0;
};

/// The transform from object space to clip space, and the depth of a clip-space vertex. Made once per object
/// and frame.
class ClipTransform {
 public:
  constexpr ClipTransform() = default;

  /// Returns kInvalidArgument, and does not change `transform`, if the viewport's size is not 1...2048, the
  /// focal length not above 0, the planes not 0 < near < far, or a translation above 2^22 units in magnitude.
  static constexpr Status make(const Placement& placement, const Projection& projection,
                               const Viewport& viewport, ClipTransform& transform);

  /// make() as a constant, which can lie in flash. Arguments that make() rejects do not compile.
  [[nodiscard]] static consteval ClipTransform of(const Placement& placement, const Projection& projection,
                                                  const Viewport& viewport) {
    ClipTransform transform;
    if (!ok(make(placement, projection, viewport, transform))) detail::constant_refused();
    return transform;
  }

  /// The clip-space position of a vertex.
  [[nodiscard]] constexpr ClipPosition operator()(ObjectPosition p) const {
    return {row(0, p), row(1, p), row(2, p)};
  }

  /// w of the near plane, at least 1.
  [[nodiscard]] constexpr std::int32_t near_w() const { return near_w_; }
  /// The camera's position in object space.
  [[nodiscard]] constexpr const ObjectPoint& eye() const { return eye_; }
  [[nodiscard]] constexpr PixelLength focal() const { return focal_; }
  /// The scale of clip space, -4...13: w of a point is its distance before the camera in object units times
  /// 2^w_bits().
  [[nodiscard]] constexpr int w_bits() const { return w_bits_; }
  /// The squared length of the matrix' row for x, y or w (i = 0, 1, 2), below 3 * 2^56. Entries have 14
  /// fraction bits more than clip space.
  [[nodiscard]] constexpr std::int64_t row_square(int i) const {
    std::int64_t sum = 0;
    for (const Entry& e : matrix_[i]) {
      const std::int64_t entry = std::int64_t{e.high} * (1 << 14) + e.low;
      sum += entry * entry;
    }
    return sum;
  }
  [[nodiscard]] constexpr const Viewport& viewport() const { return viewport_; }

  /// The depth of a vertex: 16 bits, nearer is smaller, linear on the screen. `near_over_w` is near_w() / w
  /// with 29 fraction bits. The result is clamped to kDepthMargin ... 65535 - kDepthMargin, so that steps
  /// along rows and edges cannot wrap.
  [[nodiscard]] constexpr std::uint16_t depth(std::int32_t near_over_w) const {
    const std::int32_t beyond = (std::int32_t{1} << 29) - near_over_w;
    if (beyond <= 0) return static_cast<std::uint16_t>(kDepthMargin);
    const std::int32_t depth = kDepthMargin + (multiply_high(depth_range_, beyond) >> depth_shift_);
    return static_cast<std::uint16_t>(depth > 65535 - kDepthMargin ? 65535 - kDepthMargin : depth);
  }

  static constexpr std::int32_t kDepthMargin = 256;

 private:
  /// An entry of the matrix, high * 2^14 + low, |entry| < 2^28: `high` has 15 bits with the sign and `low`
  /// 14, so that sums of three products with 16-bit positions fit 32 bits.
  struct Entry {
    std::int32_t high;
    std::int32_t low;
  };

  [[nodiscard]] constexpr std::int32_t row(int i, ObjectPosition p) const {
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
  ObjectPoint eye_{};
  PixelLength focal_{};
  int w_bits_ = 0;
};

namespace detail {

/// The largest distance of a 16-bit position from the object's origin: 32768 * sqrt(3), rounded up.
inline constexpr std::int64_t kObjectRadius = 56756;
inline constexpr int kGuardBits = 10 + PixelLength::kFraction;  // division of a PixelLength by kGuardBand

[[nodiscard]] constexpr std::int64_t magnitude64(std::int64_t v) { return v < 0 ? -v : v; }

/// The ranges that ClipTransform::make() states.
[[nodiscard]] constexpr bool acceptable(const Placement& placement, const Projection& projection,
                                        const Viewport& viewport) {
  constexpr std::int64_t kMaxTranslation = std::int64_t{1} << 22;
  constexpr std::int32_t kMaxPicture = 2 * kGuardBand;
  for (const ObjectLength t : placement.translation) {
    if (magnitude64(t.raw()) > kMaxTranslation << ObjectLength::kFraction) return false;
  }
  return viewport.width >= 1 && viewport.height >= 1 && viewport.width <= kMaxPicture &&
         viewport.height <= kMaxPicture && projection.focal.raw() > 0 && projection.near_plane.raw() > 0 &&
         projection.far_plane > projection.near_plane;
}

/// The scale of clip space as a power of two: the largest with which all coordinates stay below 2^29.
[[nodiscard]] constexpr int scale_bits(const Placement& placement, const Projection& projection) {
  const auto farthest = [](ObjectLength t) {
    return kObjectRadius + (magnitude64(t.raw()) >> ObjectLength::kFraction) + 1;
  };
  const std::int64_t x = farthest(placement.translation[0]);
  const std::int64_t y = farthest(placement.translation[1]);
  const std::int64_t widest = (((x > y ? x : y) * projection.focal.raw()) >> kGuardBits) + 1;
  const std::int64_t w = farthest(placement.translation[2]);
  const std::int64_t largest = widest > w ? widest : w;
  return 29 - static_cast<int>(std::bit_width(static_cast<std::uint64_t>(largest)));
}

/// value * factor * 2^shift, rounded down; |value| < 2^32, 0 < factor < 2^31.
[[nodiscard]] ARCSPAN_OUTLINE constexpr std::int32_t rescaled(std::int64_t value, std::int64_t factor,
                                                              int shift) {
  const std::int64_t product = value * factor;
  return static_cast<std::int32_t>(shift >= 0 ? product << shift : product >> -shift);
}

/// The camera's position in object space: -R^T t.
[[nodiscard]] constexpr ObjectPoint eye_of(const Placement& placement) {
  const auto coordinate = [&](std::size_t j) {
    std::int64_t sum = 0;  // below 3 * 2^60
    for (std::size_t i = 0; i < 3; ++i) {
      sum -= std::int64_t{placement.rotation.m[i][j].raw()} * placement.translation[i].raw();
    }
    return static_cast<std::int32_t>(sum >> (RotationEntry::kFraction + ObjectLength::kFraction));
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

}  // namespace detail

constexpr Status ClipTransform::make(const Placement& placement, const Projection& projection,
                                     const Viewport& viewport, ClipTransform& transform) {
  if (!detail::acceptable(placement, projection, viewport)) return Status::kInvalidArgument;
  const int bits = detail::scale_bits(placement, projection);
  // Rows x and y contain the factor focal / kGuardBand. Rows y and w are negative, because y points down on
  // the screen and the camera looks along -z.
  const std::int64_t factors[3] = {projection.focal.raw(), projection.focal.raw(),
                                   std::int64_t{1} << detail::kGuardBits};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t sign = i == 0 ? 1 : -1;
    for (std::size_t j = 0; j < 3; ++j) {
      const std::int32_t entry = detail::rescaled(sign * placement.rotation.m[i][j].raw(), factors[i],
                                                  bits + 14 - RotationEntry::kFraction - detail::kGuardBits);
      transform.matrix_[i][j] = {entry >> 14, entry & 0x3FFF};
    }
    transform.offset_[i] = detail::rescaled(sign * placement.translation[i].raw(), factors[i],
                                            bits - ObjectLength::kFraction - detail::kGuardBits);
  }
  // A near plane beyond the range of w hides everything. It saturates, so as not to wrap to the front.
  constexpr std::int64_t kFarthest = (std::int64_t{1} << 30) - 1;
  const std::int64_t near_w = (std::int64_t{projection.near_plane.raw()} << detail::kGuardBits) >>
                              (ObjectLength::kFraction + detail::kGuardBits - bits);
  transform.near_w_ = static_cast<std::int32_t>(near_w < 1 ? 1 : near_w > kFarthest ? kFarthest : near_w);
  constexpr std::uint64_t kMaxDepthRange = std::uint64_t{1} << 27;  // shifted left by at least 3
  // depth = margin + range * far / (far - near) * (1 - near / w).
  const std::int64_t range = 65535 - 2 * kDepthMargin;
  // Unsigned like the library's other divisions, which saves a routine of the compiler's run-time library.
  const auto beyond_near = static_cast<std::uint32_t>(projection.far_plane.raw()) -
                           static_cast<std::uint32_t>(projection.near_plane.raw());
  const std::uint64_t depth_range =
      static_cast<std::uint64_t>(range * projection.far_plane.raw()) / beyond_near;
  // With beyond = 1 - near / w in 29 fraction bits, as in depth():
  // depth_range * beyond = ((depth_range << shift) * beyond >> 32) >> (shift - 3).
  const auto range32 =
      static_cast<std::uint32_t>(depth_range < kMaxDepthRange ? depth_range : kMaxDepthRange);
  const int shift = std::countl_zero(range32) - 1;
  transform.depth_range_ = static_cast<std::int32_t>(range32 << shift);
  transform.depth_shift_ = shift - 3;
  transform.viewport_ = viewport;
  transform.eye_ = detail::eye_of(placement);
  transform.focal_ = projection.focal;
  transform.w_bits_ = bits;
  return Status::kOk;
}

}  // namespace arcspan
