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
  constexpr void prepare(std::int32_t to_middle, std::int32_t to_bottom) {
    to_middle_ = to_middle;
    to_bottom_ = to_bottom;
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
  /// change() in repetitions with kWideBits fraction bits, which saturates instead of wrapping.
  [[nodiscard]] constexpr std::int32_t wide_change(std::int32_t b, std::int32_t c) const {
    return limited((std::int64_t{to_middle_} * b + std::int64_t{to_bottom_} * c) >> (32 - kWideBits),
                   INT32_MAX);
  }
  static constexpr int kWideBits = 18;

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
    const MappedPoint& at = top.shade.point;
    const MappedPoint to_middle = middle.shade.point - at;
    const MappedPoint to_bottom = bottom.shade.point - at;
    const std::uint32_t range_u = most_range(to_middle.u, to_bottom.u);
    const std::uint32_t range_v = most_range(to_middle.v, to_bottom.v);
    const detail::Extent w(top.near_over_w.value, middle.near_over_w.value, bottom.near_over_w.value);
    if constexpr (Steps::kHasBorders)
      spare_bits = detail::spare_bits_of(at, middle.shade.point, bottom.shade.point);
    // A ratio of 5/4 moves texels by less than two pixels of 32.
    if (w.range() > static_cast<std::uint32_t>(w.least) >> 2) return false;
    const std::int32_t db = triangle.d_middle();
    const std::int32_t dc = triangle.d_bottom();
    u.prepare(to_middle.u, to_bottom.u);
    v.prepare(to_middle.v, to_bottom.v);
    const std::int32_t du = u.change(db, dc, *this);
    const std::int32_t dv = v.change(db, dc, *this);
    unsigned level = 0;
    if (size.levels != 1) {
      const std::int32_t area = doubled_area(top.position, middle.position, bottom.position);
      if ((range_u | range_v) >> 15 != 0) {
        level =
            wide_level(size, detail::log_area_of<std::int64_t>(area, size, to_middle, to_bottom), triangle);
      } else {
        const std::int32_t log_area = detail::log_area_of<std::int32_t>(area, size, to_middle, to_bottom);
        level = detail::level_for(size, log_area, du, dv, detail::step_bits<Steps>(*this));
      }
    }
    set(size, level);
    if (!detail::is_nearly_linear(*this, range_u, range_v, w)) return false;
    const std::uint32_t half = detail::half_texel_of<Filter, Steps>(*this);
    u.set_top(detail::word_of<Steps>(at.u, *this) - (half >> width_bits));
    v.set_top(detail::word_of<Steps>(at.v, *this) - (half >> height_bits));
    step = Steps::step(Steps::rounded(du, height_bits), dv, height_bits);
    return true;
  }
  /// The texels of a row that begins at the coordinates b and c, 16 fraction bits.
  [[nodiscard]] ARCSPAN_INLINE constexpr LinearTexture<Steps, false> row(std::int32_t b,
                                                                         std::int32_t c) const {
    return {*this, {u.at(b, c, *this), v.at(b, c, *this)}, step};
  }

 private:
  /// The range of 0, a and b, or 1 less, to twice as much: is_nearly_linear() has room for that 1, and few
  /// triangles of this size come near its limit.
  [[nodiscard]] static constexpr std::uint32_t most_range(std::int32_t a, std::int32_t b) {
    const std::uint32_t size_a = detail::low_magnitude(a);
    const std::uint32_t size_b = detail::low_magnitude(b);
    return 2 * (size_a > size_b ? size_a : size_b);
  }
  /// level_for() by steps that do not wrap, for u or v that may range over half a repetition.
  [[nodiscard]] ARCSPAN_OUTLINE constexpr unsigned wide_level(const TextureSize& size, std::int32_t log_area,
                                                              const SmallTriangle& triangle) const {
    return detail::level_for(size, log_area, u.wide_change(triangle.d_middle(), triangle.d_bottom()),
                             v.wide_change(triangle.d_middle(), triangle.d_bottom()),
                             SmallCoordinate<Steps>::kWideBits);
  }
};

}  // namespace arcspan
