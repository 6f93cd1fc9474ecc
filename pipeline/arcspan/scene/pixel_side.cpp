// SPDX-License-Identifier: MIT
#include <arcspan/scene/pixel_side.hpp>
#include <arcspan/vertex/clip_transform.hpp>

#include <bit>

namespace arcspan::detail {

PixelSide make_pixel_side(const SceneSlot& slot, PictureAxis axis, std::int32_t pixel, bool edges) {
  const ClipTransform& transform = slot.transform;
  const auto row = static_cast<std::size_t>(axis);
  const Viewport& viewport = transform.viewport();
  const std::int32_t size = axis == PictureAxis::kColumns ? viewport.width : viewport.height;
  // The pixel's centre is `offset` half pixels from the middle of the picture, where 2 kGuardBand c = offset
  // w.
  const std::int64_t offset = 2 * pixel + 1 - size;
  const auto of_plane = [&](std::int64_t c, std::int64_t w) { return 2 * kGuardBand * c - offset * w; };
  std::int64_t factors[3];  // below 2^41; 14 fraction bits more than clip space
  std::uint64_t sum = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    factors[j] = of_plane(transform.entry(row, j), transform.entry(2, j));
    sum += magnitude(factors[j]);
  }
  // Clip coordinates and those of clipped vertices are rounded by less than this; see is_beyond().
  constexpr std::int64_t kRounding = 32;
  const std::int64_t farthest = std::int64_t{slot.sphere.middle.w} + slot.sphere.radius_ahead;
  const std::int64_t across = (farthest >> 2) + (edges ? 2 * farthest : 0);
  const std::int64_t rounding = kRounding * (2 * kGuardBand + (offset < 0 ? -offset : offset));
  const std::int64_t tolerance = (across + rounding) * (std::int32_t{1} << 14);
  const auto excess = [](std::uint64_t v, int bits) {
    const int width = static_cast<int>(std::bit_width(v));
    return width > bits ? width - bits : 0;
  };
  const int for_factors = excess(sum, 14);
  const int for_tolerance = excess(static_cast<std::uint64_t>(tolerance), 27);
  const int shift = for_factors > for_tolerance ? for_factors : for_tolerance;
  // Each factor is rounded down by less than 1, times a coordinate of up to 2^15.
  constexpr std::int32_t kOfFactors = 3 * (std::int32_t{1} << 15);
  const std::int32_t reach = static_cast<std::int32_t>(tolerance >> shift) + kOfFactors + 2;
  const std::int64_t origin =
      of_plane(transform.offset(row), transform.offset(2)) * (std::int32_t{1} << 14) >> shift;
  const std::int32_t at = limited(origin, std::int32_t{1} << 30);
  const auto factor = [&](std::size_t j) { return static_cast<std::int32_t>(factors[j] >> shift); };
  return {factor(0), factor(1), factor(2), at + reach, 2 * reach};
}

}  // namespace arcspan::detail
