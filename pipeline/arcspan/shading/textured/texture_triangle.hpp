// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/prepare/linear.hpp>
#include <arcspan/prepare/precise_plane.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/grey_gouraud.hpp>
#include <arcspan/shading/textured/joined_point.hpp>
#include <arcspan/shading/textured/perspective_sides.hpp>
#include <arcspan/shading/textured/piece_length.hpp>
#include <arcspan/shading/textured/texture_grid.hpp>
#include <arcspan/shading/textured/texture_level.hpp>
#include <arcspan/target.hpp>
#include <arcspan/texture/texture.hpp>

#include <bit>
#include <concepts>
#include <cstdint>

namespace arcspan {

/// A texture point as fractions of a repetition in 32 bits.
struct TextureWords {
  std::uint32_t u;
  std::uint32_t v;
};

/// How a texture lies on a triangle: the part of the command that the texture adds.
///
/// In the plane of the screen u and v are linear only where all vertices are equally far away. Otherwise u/w,
/// v/w and 1/w are linear, and u and v are their quotients (Blinn, "Hyperbolic Interpolation", 1992).
///
/// Fractions of a repetition in 32 bits wrap. With BorderSteps they are fractions of 2^spare_bits
/// repetitions, signed, so that they do not, and the shifts are signed.
struct TextureTriangle : TextureLevel {
  TextureGrid grid;  ///< set if `piece` is 0; otherwise u, v and q are
  /// (u - u_origin)/w and (v - v_origin)/w, each in a unit of its own: one to two times its range in the
  /// triangle, at least 1/16 of a repetition.
  LinearPlane u;
  LinearPlane v;
  LinearPlane q;           ///< 1/w, relative to the nearest vertex
  std::uint32_t u_origin;  ///< least u, the fraction of a repetition in 32 bits
  std::uint32_t v_origin;  ///< least v
  std::int32_t least_q;    ///< least 1/w of the vertices
  std::int32_t piece_q;    ///< 1/w for which `piece` is made
  std::int32_t pixel_q;    ///< PieceLength::pixel_q
  std::uint8_t u_shift;    ///< from a relative u with 28 fraction bits to the fraction of a repetition
  std::uint8_t v_shift;    ///< the same for v
  std::uint8_t piece;      ///< pixels of a piece where 1/w is piece_q; 0 if u and v are linear themselves
  bool middle_left;
  TextureSize size;
  std::int32_t log_area;     ///< log_area_of(), with mip levels only
  PerspectiveSides sides;    ///< with mip levels in perspective only
  std::uint32_t half_texel;  ///< half_texel_of()

  /// Half a texel of the level, with TextureFilter::kBilinear; otherwise 0.
  [[nodiscard]] constexpr std::uint32_t half_texel_u() const { return half_texel >> width_bits; }
  [[nodiscard]] constexpr std::uint32_t half_texel_v() const { return half_texel >> height_bits; }
  /// `Mapping` is PerspectiveTexture if `piece` is not 0.
  template <class Mapping>
  constexpr void next_row() {
    if constexpr (!Mapping::kInPerspective) {
      grid.next_row<typename Mapping::Steps>();
    } else {
      u.next_row();
      v.next_row();
      q.next_row();
    }
  }
  template <class Mapping>
  constexpr void enter_lower() {
    if constexpr (Mapping::kInPerspective) {
      u.enter_lower(middle_left);
      v.enter_lower(middle_left);
      q.enter_lower(middle_left);
    }
  }
  template <class Steps>
  constexpr void move_columns(std::int32_t pixels) {
    if (piece == 0) grid.move_columns<Steps>(pixels);
  }
};

namespace detail {

/// Shifts to the left (to the right if negative) by which the ranges of u and v fit 16 bits. Each has its
/// own, because a common one would leave few bits to the smaller range.
struct TextureShifts {
  int u;
  int v;

  constexpr TextureShifts(std::uint32_t range_u, std::uint32_t range_v)
      : u(shift_of(range_u)), v(shift_of(range_v)) {}

 private:
  [[nodiscard]] static constexpr int shift_of(std::uint32_t range) {
    return leading_zeros(range | 0xFFFu) - 16;
  }
};

/// A relative u or v as a fraction of a repetition. With BorderSteps the shift may be negative.
template <class Steps>
[[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t to_word(std::int32_t relative, int word_shift) {
  if constexpr (Steps::kHasBorders) {
    const int bits = static_cast<std::int8_t>(word_shift);
    if (bits < 0) return relative >> -bits;
  }
  return wrap_shl(relative, word_shift);
}

/// The u_shift or v_shift of relative values that are shifted by `shift`.
template <class Steps>
[[nodiscard]] constexpr std::uint8_t word_shift_of(int shift, const TextureTriangle& t) {
  return static_cast<std::uint8_t>(Steps::kHasBorders ? 4 - shift - t.spare_bits : 4 - shift);
}

/// The least and the largest of three values.
struct Extent {
  std::int32_t least;
  std::int32_t most;

  constexpr Extent(std::int32_t a, std::int32_t b, std::int32_t c)
      : least(a < b ? (a < c ? a : c) : (b < c ? b : c)), most(a > b ? (a > c ? a : c) : (b > c ? b : c)) {}
  [[nodiscard]] constexpr std::uint32_t range() const {
    return static_cast<std::uint32_t>(wrap_sub(most, least));
  }
};

/// 1/w of a vertex is at least this, as Linear: so far away that a ratio of distances of 65536 is left.
inline constexpr std::int32_t kLeastQ = 1 << 12;

/// Computes the change per column of u or v, or of a level of light. `corners` are its relative values at the
/// vertices, 16 bits; `word_shift` makes fractions of a repetition in 32 bits of Linear. Returns false if it
/// is a quarter of a repetition or more.
template <class Steps, class Frame>
[[nodiscard]] constexpr bool find_step(const Frame& frame, const std::int32_t (&corners)[3], int word_shift,
                                       std::int32_t& step) {
  const Linear across = gradient_across<Linear>(frame, corners[0], corners[1], corners[2]);
  const int bits = Steps::kHasBorders ? static_cast<std::int8_t>(word_shift) : word_shift;
  if (bits > 0 && across.raw() >> (30 - bits) != across.raw() >> 31) return false;
  step = to_word<Steps>(across.raw(), word_shift);
  return true;
}

/// Returns u or v of a triangle on the grid, with its find_step(). `origin` is what `corners` are relative
/// to.
template <class Steps, class Frame>
[[nodiscard]] constexpr GridCoordinate grid_coordinate(const Frame& frame, const std::int32_t (&corners)[3],
                                                       std::uint32_t origin, int word_shift,
                                                       std::int32_t step, unsigned rounded_bits) {
  BasicLinearEdge<Linear> along;
  make_linear_edge(frame.long_edge, corners[0], corners[2], along);
  const auto grid_word = [word_shift](Linear value) { return to_word<Steps>(value.raw(), word_shift); };
  return {origin + static_cast<std::uint32_t>(grid_word(along.at)), grid_word(along.step),
          Steps::rounded(step, rounded_bits), frame.long_walk};
}

/// log2 of the most steps along columns and rows whose summed rounding errors stay within 1/32 of a texel.
/// Each step rounds u by half of 2^(height_bits - 32), beside a level v by half of 2^-14 texels, and with
/// BorderSteps both by 2^(spare_bits - 32).
template <class Steps>
[[nodiscard]] constexpr unsigned most_step_bits(const TextureTriangle& t, bool has_level) {
  if constexpr (Steps::kHasBorders) {
    return 27u - t.spare_bits - (t.width_bits > t.height_bits ? t.width_bits : t.height_bits);
  }
  const unsigned bits = 28u - t.width_bits - t.height_bits;
  return has_level && bits > 10 ? 10 : bits;
}

/// Returns the relative u or v of a corner of a triangle whose u and v are linear, `along` shifted by
/// `shift`.
[[nodiscard]] constexpr std::int32_t shifted(std::int32_t along, int shift) {
  return shift >= 0 ? along << shift : along >> -shift;
}

/// Prepares a triangle whose u and v are linear, with relative values that are shifted by `shifts`. Returns
/// false if the grid is too coarse for it, and for slivers.
template <class Steps, class Levels, class Frame>
[[nodiscard]] constexpr bool prepare_linearly(const Frame& frame, const TextureCorners& corners, Levels given,
                                              const MappedPoint& least, const TextureShifts& shifts,
                                              TextureTriangle& t) {
  const CornerLevels* const levels = given;  // a constant, if `Levels` is nullptr_t
  const std::uint32_t steps =
      (frame.width >> 16) + 2 * (static_cast<std::uint32_t>(frame.long_edge.dy) >> 4) + 1;
  if (frame.width < 0x10000u || steps >> most_step_bits<Steps>(t, levels != nullptr) != 0) return false;
  t.u_shift = word_shift_of<Steps>(shifts.u, t);
  t.v_shift = word_shift_of<Steps>(shifts.v, t);
  t.piece = 0;
  std::int32_t u[3];
  std::int32_t v[3];
  for (int i = 0; i < 3; ++i) {
    u[i] = shifted(wrap_sub(corners.at[i].u, least.u), shifts.u);
    v[i] = shifted(wrap_sub(corners.at[i].v, least.v), shifts.v);
  }
  std::int32_t du;
  std::int32_t dv;
  if (!find_step<Steps>(frame, u, t.u_shift, du) || !find_step<Steps>(frame, v, t.v_shift, dv)) return false;
  constexpr int kLevelShift = 3;  // from 12 fraction bits of 256ths of 8-bit steps to 25 of 64ths
  std::int32_t level_step = 0;
  if (levels != nullptr && !find_step<Steps>(frame, levels->at, kLevelShift, level_step)) return false;
  if (t.size.levels != 1) t.set(t.size, level_for(t.size, t.log_area, du, dv, step_bits<Steps>(t)));
  const unsigned rounded_bits = levels != nullptr ? JoinedLevel::kBits - t.height_bits : 0;
  GridCoordinate at_v =
      grid_coordinate<Steps>(frame, v, t.v_origin - t.half_texel_v(), t.v_shift, dv, rounded_bits);
  if (levels != nullptr) {
    at_v.at =
        static_cast<std::uint32_t>(JoinedPoint::rounded(static_cast<std::int32_t>(at_v.at), rounded_bits));
    at_v.step_down = JoinedPoint::rounded(at_v.step_down, rounded_bits);
  }
  t.grid.make<Steps>(
      grid_coordinate<Steps>(frame, u, t.u_origin - t.half_texel_u(), t.u_shift, du, t.height_bits), at_v,
      t.height_bits);
  if (levels != nullptr)
    t.grid.add_level(grid_coordinate<Steps>(frame, levels->at,
                                            JoinedLevel::kHalf << JoinedLevel::kRoundedBits, kLevelShift,
                                            level_step, JoinedLevel::kRoundedBits));
  return true;
}

/// Prepares a triangle whose u and v are not linear.
template <class Steps, class Frame>
constexpr void prepare_in_perspective(const Frame& frame, const TextureCorners& corners,
                                      const MappedPoint& least, const TextureShifts& shifts, const Extent& w,
                                      TextureTriangle& t) {
  t.u_shift = word_shift_of<Steps>(shifts.u, t);
  t.v_shift = word_shift_of<Steps>(shifts.v, t);
  // All values as Linear, of which all 28 bits are used.
  const int up = leading_zeros(static_cast<std::uint32_t>(w.most) | 1u) - 4;
  std::int32_t q[3];
  std::int32_t f_u[3];
  std::int32_t f_v[3];
  for (int i = 0; i < 3; ++i) {
    const std::int32_t at = corners.near_over_w[i];
    const std::int32_t scaled = up >= 0 ? wrap_shl(at, up) : at >> -up;
    q[i] = scaled < kLeastQ ? kLeastQ : scaled;
    f_u[i] = wrap_shl(wrap_sub(corners.at[i].u, least.u), 12 + shifts.u);
    f_v[i] = wrap_shl(wrap_sub(corners.at[i].v, least.v), 12 + shifts.v);
  }
  const PrecisePlanes planes(frame);
  std::int32_t u_over_w[3];
  std::int32_t v_over_w[3];
  for (int i = 0; i < 3; ++i) {
    u_over_w[i] = multiply_high(wrap_shl(f_u[i], 3), wrap_shl(q[i], 1));
    v_over_w[i] = multiply_high(wrap_shl(f_v[i], 3), wrap_shl(q[i], 1));
  }
  planes.make(q[0], q[1], q[2], t.q);
  planes.make(u_over_w[0], u_over_w[1], u_over_w[2], t.u);
  planes.make(v_over_w[0], v_over_w[1], v_over_w[2], t.v);
  const Extent q_extent(q[0], q[1], q[2]);
  t.least_q = q_extent.least;
  if (t.size.levels != 1) {
    t.sides = perspective_sides(frame, q, u_over_w, v_over_w, t.size.width_bits - shifts.u,
                                t.size.height_bits - shifts.v, t.log_area);
    // The level with the finest texels, which limits the pieces. Rounding may raise 1/w a little.
    const std::int32_t log_most = low_log2(static_cast<std::uint32_t>(q_extent.most)) + 1;
    t.set(t.size, level_of_side(t.size, t.sides.log_longer(log_most)));
  }
  PerspectiveSlope slope_u{t.u.dx.raw(), t.q.dx.raw()};
  PerspectiveSlope slope_v{t.v.dx.raw(), t.q.dx.raw()};
  for (int i = 0; i < 3; ++i) {
    slope_u.add(f_u[i], q[i]);
    slope_v.add(f_v[i], q[i]);
  }
  const PieceLength length =
      piece_length(t.least_q, slope_u, slope_v, t.width_bits - shifts.u, t.height_bits - shifts.v);
  t.piece = length.pixels == 0 ? 1 : length.pixels;
  t.pixel_q = length.pixel_q;
  t.piece_q = length.pixels == 0 ? INT32_MAX >> 2 : t.least_q;  // where each pixel is a piece, all are
}

/// The spare bits of a triangle with these corners: one for the sign, one for errors of rounding.
[[nodiscard]] constexpr std::uint8_t spare_bits_of(const MappedPoint& a, const MappedPoint& b,
                                                   const MappedPoint& c) {
  const auto size = [](const MappedPoint& p) { return low_magnitude(p.u) | low_magnitude(p.v); };
  const std::uint32_t all = size(a) | size(b) | size(c);  // with bits at least as high as each magnitude has
  return static_cast<std::uint8_t>(std::bit_width(all >> 16) + 2);
}

/// Half a texel of a level of 2^0 texels, as fractions of 2^spare_bits repetitions in 32 bits: with
/// TextureFilter::kBilinear a texel's colour is that of its middle. Otherwise 0.
template <TextureFilter Filter, class Steps>
[[nodiscard]] constexpr std::uint32_t half_texel_of(const TextureLevel& level) {
  if (Filter != TextureFilter::kBilinear) return 0;
  return std::uint32_t{1} << (31 - (Steps::kHasBorders ? level.spare_bits : 0));
}

/// Returns a texture coordinate as a fraction of a repetition in 32 bits, with BorderSteps of
/// 2^spare_bits repetitions.
template <class Steps>
[[nodiscard]] constexpr std::uint32_t word_of(std::int32_t at, const TextureLevel& level) {
  return static_cast<std::uint32_t>(
      wrap_shl(at, 16 - (Steps::kHasBorders ? level.spare_bits : 0)));  // 3 at least
}

/// True if linear mapping is exact enough: it is wrong by at most d (sqrt(r) - 1) / (sqrt(r) + 1), which is
/// less than d (r - 1) / 4 texels, if d is the range in texels and r the ratio of the distances.
[[nodiscard]] constexpr bool is_nearly_linear(const TextureLevel& t, std::uint32_t range_u,
                                              std::uint32_t range_v, const Extent& near_over_w) {
  const std::uint32_t d_u = range_u >> (12 - t.width_bits);  // 4 fraction bits
  const std::uint32_t d_v = range_v >> (12 - t.height_bits);
  const std::uint32_t texels = (d_u > d_v ? d_u : d_v) + 1;
  return wide_product(texels, near_over_w.range()) <=
         wide_product(28, static_cast<std::uint32_t>(near_over_w.least));
}

/// True if linear mapping moves texels along x and along y by at most 2^kLogMostPixels pixels: d (r - 1) / 4,
/// if d is the extent in pixels and r the ratio of the distances.
[[nodiscard]] constexpr bool is_linear_within_pixels(std::uint32_t width, std::uint32_t height,
                                                     const Extent& near_over_w) {
  const std::uint32_t extent = width > height ? width : height;  // 4 fraction bits
  return wide_product(extent, near_over_w.range()) <=
         wide_product(std::uint32_t{64} << kLogMostPixels, static_cast<std::uint32_t>(near_over_w.least));
}

}  // namespace detail

/// Prepares the texture of a triangle, and its light if there are `levels` and `piece` becomes 0. `corners`
/// are those of the frame's vertices.
/// `Steps` is TexelSteps or BorderSteps.
template <TextureFilter Filter, class Steps, class Levels, class Frame>
constexpr void prepare_texture(const Frame& frame, const TextureSize& size, const TextureCorners& corners,
                               Levels levels, TextureTriangle& t) {
  const detail::Extent u(corners.at[0].u, corners.at[1].u, corners.at[2].u);
  const detail::Extent v(corners.at[0].v, corners.at[1].v, corners.at[2].v);
  const detail::Extent w(corners.near_over_w[0], corners.near_over_w[1], corners.near_over_w[2]);
  const MappedPoint least{u.least, v.least};
  if constexpr (Steps::kHasBorders)
    t.spare_bits = detail::spare_bits_of(corners.at[0], corners.at[1], corners.at[2]);
  t.size = size;
  t.half_texel = detail::half_texel_of<Filter, Steps>(t);
  t.set(size, 0);
  if (size.levels != 1) {
    t.log_area = detail::log_area_of<std::int64_t>(
        doubled_area(frame.top->position, frame.middle->position, frame.bottom->position), size,
        corners.at[1] - corners.at[0], corners.at[2] - corners.at[0]);
    t.set(size, detail::least_mip_level(size, t.log_area));
  }
  t.u_origin = detail::word_of<Steps>(least.u, t);
  t.v_origin = detail::word_of<Steps>(least.v, t);
  t.middle_left = frame.middle_left;
  const detail::Extent x(frame.top->position.x, frame.middle->position.x, frame.bottom->position.x);
  const detail::TextureShifts shifts(u.range(), v.range());
  if (!detail::is_linear_within_pixels(x.range(), static_cast<std::uint32_t>(frame.long_edge.dy), w) ||
      !detail::is_nearly_linear(t, u.range(), v.range(), w) ||
      !detail::prepare_linearly<Steps, Levels>(frame, corners, levels, least, shifts, t)) {
    detail::prepare_in_perspective<Steps>(frame, corners, least, shifts, w, t);
  }
}

}  // namespace arcspan
