// SPDX-License-Identifier: MIT
#pragma once

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

/// Returns a mip level. `log_area` is the binary logarithm of the texels of level 0 that a pixel covers,
/// `log_step` that of the texels from a pixel to the next one in its row; both have 8 fraction bits. Across
/// the row a pixel covers area / step texels. The level is the logarithm of the longer side, rounded and
/// limited to the levels that there are: by the shorter one a floor would show moire towards the horizon.
[[nodiscard]] constexpr unsigned mip_level(const TextureSize& size, std::int32_t log_area,
                                           std::int32_t log_step) {
  const std::int32_t across = log_area - log_step;
  const std::int32_t level = ((log_step > across ? log_step : across) + 128) >> 8;
  if (level <= 0) return 0;
  return level < size.levels ? static_cast<unsigned>(level) : size.levels - 1u;
}

/// The `log_area` of mip_level() of a pixel where the raw value of 1/w is q. The area falls with the cube of
/// q; `log_area` is its logarithm for a raw value of 1.
[[nodiscard]] constexpr std::int32_t area_at(std::int32_t log_area, std::int32_t q) {
  return log_area - 3 * low_log2(static_cast<std::uint32_t>(q));
}

/// mip_level() where the step is not known: the least that it may be.
[[nodiscard]] constexpr unsigned least_mip_level(const TextureSize& size, std::int32_t log_area) {
  return mip_level(size, log_area, log_area >> 1);
}

/// log2 of the texels of level 0 that u and v change by per pixel, the larger of both, 8 fraction bits.
/// Shifted to the left by `u_shift` and `v_shift`, which are at most 16, `du` and `dv` are fractions of a
/// repetition in 32 bits.
[[nodiscard]] constexpr std::int32_t log_step(const TextureSize& size, std::int32_t du, std::int32_t dv,
                                              int u_shift, int v_shift) {
  const auto texels = [](std::int32_t d, int left) {  // 8 fraction bits
    const auto magnitude = static_cast<std::uint32_t>(d < 0 ? -(d + 1) : d);
    return left < 0 ? magnitude >> -left : magnitude << left;
  };
  const std::uint32_t u = texels(du, u_shift + size.width_bits - 24);
  const std::uint32_t v = texels(dv, v_shift + size.height_bits - 24);
  return low_log2(u > v ? u : v) - 8 * 256;
}

/// Twice the area of the corners in texels of a texture, 8 fraction bits.
[[nodiscard]] constexpr std::uint64_t texel_area(const TextureCorners& c, const TextureSize& size) {
  const auto part = [](std::int32_t a, std::int32_t b) { return std::int64_t{b} - a; };
  const std::int64_t area = part(c.at[0].u, c.at[1].u) * part(c.at[0].v, c.at[2].v) -
                            part(c.at[0].u, c.at[2].u) * part(c.at[0].v, c.at[1].v);
  const auto magnitude = static_cast<std::uint64_t>(area < 0 ? -area : area);
  // 32 fraction bits of repetitions, 58 bits at most; the size has 6 to 20.
  return magnitude >> (24 - size.width_bits - size.height_bits);
}

/// log2 of the mean of the texels of level 0 that the pixels of a triangle cover, 8 fraction bits.
[[nodiscard]] ARCSPAN_OUTLINE constexpr std::int32_t log_area_of(const RasterPosition& top,
                                                                 const RasterPosition& middle,
                                                                 const RasterPosition& bottom,
                                                                 const TextureSize& size,
                                                                 const TextureCorners& corners) {
  const std::int32_t area = doubled_area(top, middle, bottom);
  const std::uint64_t texels = texel_area(corners, size);
  const int up = texels >> 32 != 0 ? 24 : 0;
  return low_log2(static_cast<std::uint32_t>(texels >> up)) + 256 * up -
         low_log2(static_cast<std::uint32_t>(area < 0 ? -area : area));
}

/// Returns the mip level of a triangle or a piece whose u and v change by `du` and `dv` per pixel. `level`
/// has its spare_bits.
template <class Steps>
[[nodiscard]] constexpr unsigned level_for(const TextureSize& size, std::int32_t log_area, std::int32_t du,
                                           std::int32_t dv, const TextureLevel& level) {
  const int spare = Steps::kHasBorders ? level.spare_bits : 0;
  return mip_level(size, log_area, log_step(size, du, dv, spare, spare));
}

}  // namespace detail

}  // namespace arcspan
