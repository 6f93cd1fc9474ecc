// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/prepare/small_triangle.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/textured/texture_row.hpp>
#include <arcspan/shading/textured/texture_triangle.hpp>
#include <arcspan/target.hpp>
#include <arcspan/texture/texture.hpp>

#include <cstdint>

namespace arcspan {

/// u or v of a small triangle in barycentric coordinates: at + b (middle - at) + c (bottom - at). Products
/// with coordinates of 16 fraction bits are fractions of a repetition in 32 bits, and wrap as those do; with
/// BorderSteps they are of 2^spare_bits repetitions.
template <class Steps>
class SmallCoordinate {
 public:
  constexpr void prepare(std::int32_t top, std::int32_t middle, std::int32_t bottom) {
    to_middle_ = wrap_sub(middle, top);
    to_bottom_ = wrap_sub(bottom, top);
  }
  constexpr void set_top(std::uint32_t word) { at_ = word; }
  /// The value at b and c.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t at(std::int32_t b, std::int32_t c,
                                                          const TextureLevel& level) const {
    return at_ + static_cast<std::uint32_t>(change(b, c, level));
  }
  /// The change where b and c change by these.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t change(
      std::int32_t b, std::int32_t c, [[maybe_unused]] const TextureLevel& level) const {
    if constexpr (Steps::kHasBorders) {
      const std::int64_t sum = std::int64_t{to_middle_} * b + std::int64_t{to_bottom_} * c;
      return static_cast<std::int32_t>(sum >> level.spare_bits);
    } else {
      return wrap_add(wrap_mul(to_middle_, b), wrap_mul(to_bottom_, c));
    }
  }
  /// change() in repetitions with 18 fraction bits, which saturates instead of wrapping.
  [[nodiscard]] constexpr std::int32_t wide_change(std::int32_t b, std::int32_t c) const {
    return limited((std::int64_t{to_middle_} * b + std::int64_t{to_bottom_} * c) >> kDropped, INT32_MAX);
  }
  static constexpr int kDropped = 14;  ///< fraction bits that change() has and wide_change() has not

 private:
  std::uint32_t at_;        ///< at the top vertex
  std::int32_t to_middle_;  ///< in repetitions, 16 fraction bits
  std::int32_t to_bottom_;
};

/// How a texture lies on a small triangle.
template <class Steps>
struct SmallTexture : TextureLevel {
  SmallCoordinate<Steps> u;
  SmallCoordinate<Steps> v;
  std::uint64_t step;  ///< per pixel

  /// Prepares the texture of a triangle between three RasterVertex. Returns false if u and v are too far from
  /// linear on the screen.
  template <TextureFilter Filter, class Raster>
  [[nodiscard]] constexpr bool prepare(const Raster& top, const Raster& middle, const Raster& bottom,
                                       const TextureSize& size, const SmallTriangle& triangle) {
    const TextureCorners corners{{top.shade.point, middle.shade.point, bottom.shade.point},
                                 {top.near_over_w.value, middle.near_over_w.value, bottom.near_over_w.value}};
    const detail::Extent range_u(corners.at[0].u, corners.at[1].u, corners.at[2].u);
    const detail::Extent range_v(corners.at[0].v, corners.at[1].v, corners.at[2].v);
    const detail::Extent w(corners.near_over_w[0], corners.near_over_w[1], corners.near_over_w[2]);
    if constexpr (Steps::kHasBorders) spare_bits = detail::spare_bits_of(range_u, range_v);
    set(size, 0);
    std::int32_t log_area = 0;
    if (size.levels != 1) {
      log_area = detail::log_area_of(top.position, middle.position, bottom.position, size, corners);
      set(size, detail::least_mip_level(size, log_area));
    }
    // A ratio of 3/2 moves texels by less than two pixels of 15.
    if (w.range() > static_cast<std::uint32_t>(w.least) >> 1) return false;
    if (!detail::is_nearly_linear(*this, range_u.range(), range_v.range(), w)) return false;
    u.prepare(corners.at[0].u, corners.at[1].u, corners.at[2].u);
    v.prepare(corners.at[0].v, corners.at[1].v, corners.at[2].v);
    const std::int32_t du = u.change(triangle.d_middle, triangle.d_bottom, *this);
    const std::int32_t dv = v.change(triangle.d_middle, triangle.d_bottom, *this);
    if (size.levels != 1) {
      const bool may_wrap = !Steps::kHasBorders && (range_u.range() | range_v.range()) >> 15 != 0;
      set(size, may_wrap ? wide_level(size, log_area, triangle)
                         : detail::level_for<Steps>(size, log_area, du, dv, *this));
    }
    const std::uint32_t half = detail::half_texel_of<Filter, Steps>(*this);
    u.set_top(detail::word_of<Steps>(corners.at[0].u, *this) - (half >> width_bits));
    v.set_top(detail::word_of<Steps>(corners.at[0].v, *this) - (half >> height_bits));
    step = Steps::step(Steps::rounded(du, height_bits), dv, height_bits);
    return true;
  }
  /// The texels of a row that begins at the coordinates b and c, 16 fraction bits.
  [[nodiscard]] ARCSPAN_INLINE constexpr LinearTexture<Steps, false> row(std::int32_t b,
                                                                         std::int32_t c) const {
    return {*this, {u.at(b, c, *this), v.at(b, c, *this)}, step};
  }

 private:
  /// level_for() by steps that do not wrap, for u or v that range over half a repetition or more.
  [[nodiscard]] ARCSPAN_OUTLINE constexpr unsigned wide_level(const TextureSize& size, std::int32_t log_area,
                                                              const SmallTriangle& triangle) const {
    constexpr int kDropped = SmallCoordinate<Steps>::kDropped;
    const std::int32_t du = u.wide_change(triangle.d_middle, triangle.d_bottom);
    const std::int32_t dv = v.wide_change(triangle.d_middle, triangle.d_bottom);
    return detail::mip_level(size, log_area, detail::log_step(size, du, dv, kDropped, kDropped));
  }
};

}  // namespace arcspan
