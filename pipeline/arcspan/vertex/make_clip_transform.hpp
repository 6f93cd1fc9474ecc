// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/checked.hpp>
#include <arcspan/vertex/clip_transform.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>

namespace arcspan {

namespace detail {

/// The largest distance of a 16-bit position from the object's origin: 32768 * sqrt(3), rounded up.
inline constexpr std::int64_t kObjectRadius = 56756;
/// log2 of kGuardBand as a PixelLength.
inline constexpr int kGuardLengthBits = kGuardBits + PixelLength::kFraction;

[[nodiscard]] constexpr std::int64_t magnitude64(std::int64_t v) { return v < 0 ? -v : v; }

/// The ranges that ClipTransform::make() states.
[[nodiscard]] constexpr bool acceptable(const Placement& placement, const Projection& projection,
                                        const Viewport& viewport) {
  static_assert(kMostPictureSide == 2 * kGuardBand);
  constexpr std::int64_t kMaxTranslation = std::int64_t{1} << 22;
  for (const ObjectLength t : placement.translation) {
    if (magnitude64(t.raw()) > kMaxTranslation << ObjectLength::kFraction) return false;
  }
  return is_picture_size(viewport) && projection.focal.raw() > 0 && projection.near_plane.raw() > 0 &&
         projection.far_plane > projection.near_plane;
}

/// The scale of clip space as a power of two: the largest with which all coordinates stay below 2^29.
[[nodiscard]] constexpr int scale_bits(const WidePlacement& placement) {
  const std::int64_t radius =
      placement.unit_bits < 0 ? kObjectRadius << -placement.unit_bits : kObjectRadius >> placement.unit_bits;
  const auto farthest = [radius](std::int64_t t) {
    return radius + (magnitude64(t) >> ObjectLength::kFraction) + 1;
  };
  const std::int64_t x = farthest(placement.translation[0]);
  const std::int64_t y = farthest(placement.translation[1]);
  const std::int64_t widest =
      (((x > y ? x : y) * placement.focal) >> (kGuardLengthBits - placement.focal_bits)) + 1;
  const std::int64_t w = farthest(placement.translation[2]);
  const std::int64_t largest = widest > w ? widest : w;
  return 29 - static_cast<int>(std::bit_width(static_cast<std::uint64_t>(largest)));
}

/// value * factor * 2^shift, rounded down; |value| < 2^32, 0 < factor < 2^31.
[[nodiscard]] ARCSPAN_OUTLINE constexpr std::int32_t rescaled(std::int64_t value, std::int64_t factor,
                                                              int shift) {
  const std::int64_t product = value * factor;
  return static_cast<std::int32_t>(shift >= 0 ? product << shift : product >> (shift < -63 ? 63 : -shift));
}

/// The camera's position in object space: -R^T t. Unit bits must not be above 0.
[[nodiscard]] constexpr ObjectPoint eye_of(const WidePlacement& placement) {
  const auto coordinate = [&](std::size_t j) {
    std::int64_t sum = 0;  // below 3 * 2^60
    for (std::size_t i = 0; i < 3; ++i) {
      sum -= std::int64_t{placement.rotation.m[i][j].raw()} * placement.translation[i];
    }
    return static_cast<std::int32_t>(
        sum >> (RotationEntry::kFraction + ObjectLength::kFraction - placement.unit_bits));
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

}  // namespace detail

constexpr Status ClipTransform::make(const Placement& placement, const Projection& projection,
                                     const Viewport& viewport, ClipTransform& transform) {
  if (!detail::acceptable(placement, projection, viewport)) return Status::kInvalidArgument;
  ARCSPAN_CHECK(detail::is_orthonormal(placement.rotation),
                "ClipTransform::make: the rotation is not orthonormal");
  WidePlacement wide{placement.rotation, {}, projection.near_plane.raw(), projection.focal.raw()};
  wide.far_plane = projection.far_plane.raw();
  for (std::size_t i = 0; i < 3; ++i) wide.translation[i] = placement.translation[i].raw();
  transform.set_placement(wide);
  constexpr std::uint64_t kMaxDepthRange = (std::uint64_t{1} << 28) - 1;  // shifted left by at least 3
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
  transform.depth_shift_ = static_cast<short>(shift - 3);
  transform.viewport_ = viewport;
  // The middle of a picture of odd size is the centre of its middle pixel, half a pixel from the raster
  // origin.
  const auto rounding = [](std::int32_t size) {
    return ((size & 1) * 16 + 1) * (std::int32_t{1} << (28 - kGuardBits - Subpixel::kFraction));
  };
  transform.rounding_[0] = rounding(viewport.width);
  transform.rounding_[1] = rounding(viewport.height);
  return Status::kOk;
}

constexpr void ClipTransform::set_placement(const WidePlacement& placement) {
  const int bits = detail::scale_bits(placement);
  w_bits_ = static_cast<signed char>(bits - placement.unit_bits);
  // Rows x and y contain the factor focal / kGuardBand. Rows y and w are negative, because y points down on
  // the screen and the camera looks along -z.
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t sign = i == 0 ? 1 : -1;
    const std::int64_t factor = i < 2 ? placement.focal : std::int64_t{1} << detail::kGuardLengthBits;
    const int factor_bits = i < 2 ? placement.focal_bits : 0;
    for (std::size_t j = 0; j < 3; ++j) {
      const std::int32_t entry =
          detail::rescaled(sign * placement.rotation.m[i][j].raw(), factor,
                           w_bits_ + factor_bits + 14 - RotationEntry::kFraction - detail::kGuardLengthBits);
      matrix_[i][j] = detail::MatrixEntry(entry);
    }
    offset_[i] = detail::rescaled(sign * placement.translation[i], factor,
                                  bits + factor_bits - ObjectLength::kFraction - detail::kGuardLengthBits);
  }
  // A near plane beyond the range of w hides everything. It saturates, so as not to wrap to the front.
  const auto w_of = [bits](std::int64_t plane) {
    constexpr std::int64_t kFarthest = (std::int64_t{1} << 30) - 1;
    const std::int64_t w =
        (plane << detail::kGuardLengthBits) >> (ObjectLength::kFraction + detail::kGuardLengthBits - bits);
    return static_cast<std::int32_t>(w < 1 ? 1 : w > kFarthest ? kFarthest : w);
  };
  w_range_ = {w_of(placement.near_plane), w_of(placement.far_plane) + 1};
  eye_ = placement.unit_bits <= 0 ? detail::eye_of(placement) : ObjectPoint{std::int32_t{1} << 23, 0, 0};
  focal_ = PixelLength::from_raw(placement.focal);
  focal_bits_ = static_cast<signed char>(placement.focal_bits);
}

namespace detail {

/// An upper bound of length * factor * 2^shift that allows for the rounding of a matrix and of the rotation
/// in it; length <= 56756, factor < 2^31.
[[nodiscard]] constexpr std::int32_t clip_length(std::uint32_t length, std::int64_t factor, int shift) {
  const std::int32_t nominal = rescaled(length, factor, shift);
  return nominal + (nominal >> 12) + 16;
}

}  // namespace detail

constexpr std::int32_t ClipTransform::length_ahead(std::uint32_t length) const {
  return detail::clip_length(length, std::int64_t{1} << detail::kGuardLengthBits,
                             w_bits_ - detail::kGuardLengthBits);
}

constexpr std::int32_t ClipTransform::scaled_across(std::uint32_t length) const {
  return detail::rescaled(length, focal_.raw(), w_bits_ + focal_bits_ - detail::kGuardLengthBits);
}

constexpr std::int32_t ClipTransform::length_across(std::uint32_t length) const {
  return detail::clip_length(length, focal_.raw(), w_bits_ + focal_bits_ - detail::kGuardLengthBits);
}

}  // namespace arcspan
