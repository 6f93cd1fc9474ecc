// SPDX-License-Identifier: MIT
#include <arcspan/vertex/clip_transform.hpp>

#include <bit>

namespace arcspan {

namespace {

/// No 16-bit position is farther from the object's origin: 32768 * sqrt(3), rounded up.
constexpr std::int64_t kObjectRadius = 56756;
constexpr std::int64_t kMaxTranslation = std::int64_t{1} << 22;
constexpr std::uint64_t kMaxDepthRange = std::uint64_t{1} << 27;  // shifted left by at least 3
constexpr std::int32_t kMaxPicture = 2 * kGuardBand;
constexpr int kGuardBits = 10 + PixelLength::kFraction;  // focal / kGuardBand in PixelLength

std::int64_t magnitude(std::int64_t v) { return v < 0 ? -v : v; }

bool acceptable(const Placement& placement, const Projection& projection, const Viewport& viewport) {
  for (const ObjectLength t : placement.translation) {
    if (magnitude(t.raw()) > kMaxTranslation << ObjectLength::kFraction) return false;
  }
  return viewport.width >= 1 && viewport.height >= 1 && viewport.width <= kMaxPicture &&
         viewport.height <= kMaxPicture && projection.focal.raw() > 0 && projection.near_plane.raw() > 0 &&
         projection.far_plane > projection.near_plane;
}

/// How far coordinates of clip space may be scaled up, as a power of two: the largest stays below 2^29.
int scale_bits(const Placement& placement, const Projection& projection) {
  const auto reach = [](ObjectLength t) {
    return kObjectRadius + (magnitude(t.raw()) >> ObjectLength::kFraction) + 1;
  };
  const std::int64_t x = reach(placement.translation[0]);
  const std::int64_t y = reach(placement.translation[1]);
  const std::int64_t widest = ((x > y ? x : y) * projection.focal.raw() >> kGuardBits) + 1;
  const std::int64_t w = reach(placement.translation[2]);
  const std::int64_t largest = widest > w ? widest : w;
  return 29 - static_cast<int>(std::bit_width(static_cast<std::uint64_t>(largest)));
}

/// value * factor * 2^shift, rounded towards minus infinity; |value| < 2^32, 0 < factor < 2^31.
[[gnu::noinline]] std::int32_t rescaled(std::int64_t value, std::int64_t factor, int shift) {
  const std::int64_t product = value * factor;
  return static_cast<std::int32_t>(shift >= 0 ? product << shift : product >> -shift);
}

}  // namespace

Status ClipTransform::make(const Placement& placement, const Projection& projection, const Viewport& viewport,
                           ClipTransform& transform) {
  if (!acceptable(placement, projection, viewport)) return Status::kInvalidArgument;
  const int bits = scale_bits(placement, projection);
  // Rows x and y carry focal / kGuardBand, y and w a minus sign: screen y goes down, the camera looks along
  // -z.
  const std::int64_t factors[3] = {projection.focal.raw(), projection.focal.raw(),
                                   std::int64_t{1} << kGuardBits};
  for (int i = 0; i < 3; ++i) {
    const std::int64_t sign = i == 0 ? 1 : -1;
    for (int j = 0; j < 3; ++j) {
      const std::int32_t entry = rescaled(sign * placement.rotation.m[i][j].raw(), factors[i],
                                          bits + 14 - RotationEntry::kFraction - kGuardBits);
      transform.matrix_[i][j] = {entry >> 14, entry & 0x3FFF};
    }
    transform.offset_[i] = rescaled(sign * placement.translation[i].raw(), factors[i],
                                    bits - ObjectLength::kFraction - kGuardBits);
  }
  // A near plane behind all that the numbers reach hides everything; it must not wrap around to the front.
  constexpr std::int64_t kFarthest = (std::int64_t{1} << 30) - 1;
  const std::int64_t near_w = (std::int64_t{projection.near_plane.raw()} << kGuardBits) >>
                              (ObjectLength::kFraction + kGuardBits - bits);
  transform.near_w_ = static_cast<std::int32_t>(near_w < 1 ? 1 : near_w > kFarthest ? kFarthest : near_w);
  // depth = margin + range * far / (far - near) * (1 - near / w).
  const std::int64_t range = 65535 - 2 * kDepthMargin;
  // Unsigned: one routine of the run-time library less.
  const auto beyond_near = static_cast<std::uint32_t>(projection.far_plane.raw()) -
                           static_cast<std::uint32_t>(projection.near_plane.raw());
  const std::uint64_t depth_range =
      static_cast<std::uint64_t>(range * projection.far_plane.raw()) / beyond_near;
  // depth_range * (1 - near / w) is (depth_range << shift) * beyond >> 32 >> (shift - 3).
  const auto range32 =
      static_cast<std::uint32_t>(depth_range < kMaxDepthRange ? depth_range : kMaxDepthRange);
  const int shift = std::countl_zero(range32) - 1;
  transform.depth_range_ = static_cast<std::int32_t>(range32 << shift);
  transform.depth_shift_ = shift - 3;
  transform.viewport_ = viewport;
  return Status::kOk;
}

}  // namespace arcspan
