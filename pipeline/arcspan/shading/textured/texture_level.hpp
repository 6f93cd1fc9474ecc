// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/textured/piece_length.hpp>
#include <arcspan/target.hpp>
#include <arcspan/texture/texture.hpp>

#include <cstdint>

namespace arcspan {

/// A texture point as triangles interpolate it: widths and heights of the texture, 16 fraction bits, below
/// 2^27 in magnitude.
struct MappedPoint {
  std::int32_t u;
  std::int32_t v;

  [[nodiscard]] friend constexpr MappedPoint operator-(const MappedPoint& a, const MappedPoint& b) {
    return {wrap_sub(a.u, b.u), wrap_sub(a.v, b.v)};
  }
};

/// The vertices of a triangle for its texture, in the order top, middle, bottom.
struct TextureCorners {
  MappedPoint at[3];
  std::int32_t near_over_w[3];
};

/// The mip level that a triangle, or a piece of a row in perspective, shows.
struct TextureLevel {
  std::uint32_t first;      ///< first texel of the level
  std::uint32_t mask;       ///< of a texel's index in the level
  std::uint8_t width_bits;  ///< size of the level
  std::uint8_t height_bits;
  std::uint8_t number;    ///< 0 is the picture itself
  std::uint8_t rotation;  ///< (32 - width_bits) mod 32: brings row and column together in a JoinedPoint
  // Of BorderSteps, otherwise unset:
  std::uint8_t spare_bits;  ///< 2 or more
  TextureWrap u_wrap;
  TextureWrap v_wrap;

  constexpr void set_wraps(const TextureSampler& sampler) {
    u_wrap = sampler.u;
    v_wrap = sampler.v;
  }
  constexpr void set(const TextureSize& size, unsigned level) {
    number = static_cast<std::uint8_t>(level);
    width_bits = static_cast<std::uint8_t>(size.width_bits - static_cast<int>(level));
    height_bits = static_cast<std::uint8_t>(size.height_bits - static_cast<int>(level));
    first = size.texels(level);
    rotation = static_cast<std::uint8_t>((32 - width_bits) & 31);
    mask = (std::uint32_t{1} << (width_bits + height_bits)) - 1;
  }
};

namespace detail {

/// The mip level whose texels are nearest to a side of a pixel in size, of the levels that there are.
/// `log_side` is the binary logarithm of its texels of level 0, 8 fraction bits.
[[nodiscard]] ARCSPAN_INLINE constexpr unsigned level_of_side(const TextureSize& size,
                                                              std::int32_t log_side) {
  const std::int32_t level = (log_side + 128) >> 8;
  if (level <= 0) return 0;
  return level < size.levels ? static_cast<unsigned>(level) : size.levels - 1u;
}

/// Returns a mip level. `log_area` is the binary logarithm of the texels of level 0 that a pixel covers,
/// `log_step` that of the texels from a pixel to the next one in its row; both have 8 fraction bits. Across
/// the row a pixel covers area / step texels. The level is that of the longer side: by the shorter one a
/// floor would show moire towards the horizon.
[[nodiscard]] constexpr unsigned mip_level(const TextureSize& size, std::int32_t log_area,
                                           std::int32_t log_step) {
  const std::int32_t across = log_area - log_step;
  return level_of_side(size, log_step > across ? log_step : across);
}

/// mip_level() where the step is not known: the least that it may be.
[[nodiscard]] constexpr unsigned least_mip_level(const TextureSize& size, std::int32_t log_area) {
  return mip_level(size, log_area, log_area >> 1);
}

/// |d|; of a negative d 1 less, which takes an instruction less than magnitude().
[[nodiscard]] constexpr std::uint32_t low_magnitude(std::int32_t d) {
  return static_cast<std::uint32_t>(d ^ (d >> 31));
}

/// log2 of the length in texels of level 0 of a step by u and v, each of which is below 2^31. All have 8
/// fraction bits.
[[nodiscard]] constexpr std::int32_t log_step(std::uint32_t u, std::uint32_t v) {
  const std::uint32_t mean = (u + v) >> 1;
  // The greatest of u, v and the diagonal is within 1/16 of the length.
  const std::uint32_t diagonal = mean + (mean >> 1);
  const std::uint32_t longer = u > v ? u : v;
  return low_log2(longer > diagonal ? longer : diagonal) - 8 * 256;
}

/// log2 of the mean of the texels of level 0 that the pixels of a triangle cover, 8 fraction bits.
/// `screen_area` is its doubled_area(); `to_middle` and `to_bottom` lead from a vertex to the others. `Wide`
/// is an integer of 64 bits, or of 32 where these are below half a repetition.
template <class Wide>
[[nodiscard]] constexpr std::int32_t log_area_of(std::int32_t screen_area, const TextureSize& size,
                                                 const MappedPoint& to_middle, const MappedPoint& to_bottom) {
  const Wide area = Wide{to_middle.u} * to_bottom.v - Wide{to_bottom.u} * to_middle.v;
  // 32 fraction bits of repetitions, 58 bits at most; the size has 6 to 20.
  const auto texels = magnitude(area) >> (24 - size.width_bits - size.height_bits);
  const int up = texels > UINT32_MAX ? 24 : 0;
  return low_log2(static_cast<std::uint32_t>(texels >> up)) + 256 * up - low_log2(magnitude(screen_area));
}

/// The fraction bits of a step in 32 bits: all but the spare bits.
template <class Steps>
[[nodiscard]] constexpr int step_bits([[maybe_unused]] const TextureLevel& level) {
  return 32 - (Steps::kHasBorders ? level.spare_bits : 0);
}

/// Returns the mip level of a triangle whose u and v change by `du` and `dv` per pixel, repetitions with
/// `bits` fraction bits, 18 or more, so that no shift is negative.
[[nodiscard]] constexpr unsigned level_for(const TextureSize& size, std::int32_t log_area, std::int32_t du,
                                           std::int32_t dv, int bits) {
  const int drop = bits - 8;
  return mip_level(size, log_area,
                   log_step(low_magnitude(du) >> (drop - size.width_bits),
                            low_magnitude(dv) >> (drop - size.height_bits)));
}

}  // namespace detail

}  // namespace arcspan
