// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/shading/textured/joined_point.hpp>
#include <arcspan/shading/textured/piece_length.hpp>
#include <arcspan/shading/textured/texture_triangle.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

namespace detail {

/// Entry n is 2^30 / n, rounded down; entry 0 is not used.
consteval std::array<std::int32_t, kLongestPiece + 1> make_piece_inverses() {
  std::array<std::int32_t, kLongestPiece + 1> table{};
  for (std::size_t n = 1; n < table.size(); ++n)
    table[n] = static_cast<std::int32_t>((std::uint32_t{1} << 30) / n);
  return table;
}
inline constexpr auto kPieceInverses = make_piece_inverses();

}  // namespace detail

/// The texels of a row's pixels, stepped as a JoinedPoint. A rotation of its upper half brings row and column
/// together as the index of the texel.
class TexelSteps : public JoinedPoint {
 public:
  static constexpr bool kHasBorders = false;

  ARCSPAN_INLINE constexpr explicit TexelSteps(const TextureLevel& t) { set_size(t); }
  /// Goes on in another level of the texture.
  ARCSPAN_INLINE constexpr void set_size(const TextureLevel& t) {
    height_bits_ = t.height_bits;
    width_bits_ = t.width_bits;
    rotation_ = t.rotation;
    mask_ = t.mask;
  }

  /// Starts at u and v, fractions of a repetition in 32 bits.
  ARCSPAN_INLINE constexpr void start(std::uint32_t u, std::uint32_t v) { at_ = joined(u, v, height_bits_); }
  ARCSPAN_INLINE constexpr void start_at(std::uint64_t joined) { at_ = joined; }
  ARCSPAN_INLINE constexpr void set_step(std::uint64_t step) { step_ = step; }
  ARCSPAN_INLINE constexpr void set_step(std::int32_t u, std::int32_t v) {
    step_ = step(rounded(u, height_bits_), v, height_bits_);
  }
  /// The index of the current texel in its level.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t index() const { return rotated() & mask_; }
  ARCSPAN_INLINE constexpr void next() { at_ += step_; }

  /// The light_factor() of the level beside u and v (JoinedLevel).
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t light_factor() const {
    constexpr unsigned kAbove = 32 - JoinedLevel::kBits;
    return static_cast<std::uint32_t>(at_) << kAbove >> (kAbove + JoinedLevel::kFraction) << 25;
  }
  /// The level as a channel of PackedRgb.
  [[nodiscard]] constexpr std::uint32_t packed_level() const {
    const std::uint32_t raised =
        (static_cast<std::uint32_t>(at_) & ((std::uint32_t{1} << JoinedLevel::kBits) - 1)) + 256;
    return raised < JoinedLevel::kHalf ? 0 : (raised - JoinedLevel::kHalf) >> 7;
  }

  /// An object with the four texels around the current pixel: index() is that of the texel at the pixel,
  /// to_right() the distance from it to the next one in its row, below() the index of the one in the next
  /// row. Both wrap.
  [[nodiscard]] constexpr const TexelSteps& around() const { return *this; }
  [[nodiscard]] constexpr std::uint32_t to_right(std::uint32_t texel) const {
    // The next index differs in this bit if the row ends, and then in all bits below it.
    const std::uint32_t width = std::uint32_t{1} << width_bits_;
    return 1 - (((texel + 1) ^ texel) & width);
  }
  [[nodiscard]] constexpr std::uint32_t below(std::uint32_t texel) const {
    return (texel + (std::uint32_t{1} << width_bits_)) & mask_;
  }
  /// Where the current pixel lies between the current texel and these two, 0...31.
  [[nodiscard]] constexpr std::uint32_t fraction_right() const { return rotated() >> 27; }
  [[nodiscard]] constexpr std::uint32_t fraction_below() const {
    return static_cast<std::uint32_t>(at_) >> 27;
  }

  /// u and v of the current pixel, fractions of a repetition in 32 bits. The last height_bits of u are 0.
  [[nodiscard]] constexpr std::uint32_t u() const {
    return static_cast<std::uint32_t>(at_ >> 32) >> height_bits_ << height_bits_;
  }
  [[nodiscard]] constexpr std::uint32_t v() const { return static_cast<std::uint32_t>(at_ >> height_bits_); }

 private:
  /// The upper half of the word from the fraction of u on, so that row and column of the texel end it.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t rotated() const {
    const auto upper = static_cast<std::uint32_t>(at_ >> 32);
    return (upper >> rotation_) | (upper << (-rotation_ & 31u));
  }

  std::uint64_t at_;
  std::uint64_t step_;
  unsigned height_bits_;
  unsigned width_bits_;
  unsigned rotation_;  ///< to the right: 22...31, or 0 for a single column
  std::uint32_t mask_;
};

/// u and v along a row, linear in the whole row; with `HasLevel` also the level of light. `StepsType` is
/// TexelSteps or BorderSteps.
template <class StepsType, bool HasLevel>
class LinearTexture {
 public:
  using Steps = StepsType;
  static constexpr bool kInPerspective = false;
  static constexpr bool kHasLevel = HasLevel;

  ARCSPAN_INLINE constexpr LinearTexture(const TextureTriangle& t, const RowStart& row) : steps_(t) {
    steps_.start_at(t.grid.at_column<Steps>(static_cast<std::uint32_t>(row.column)));
    steps_.set_step(t.grid.step);
  }
  /// Starts at u and v, which change by `step` per pixel.
  ARCSPAN_INLINE constexpr LinearTexture(const TextureLevel& level, const TextureWords& at,
                                         std::uint64_t step)
      : steps_(level) {
    steps_.start(at.u, at.v);
    steps_.set_step(step);
  }
  [[nodiscard]] ARCSPAN_INLINE constexpr const Steps& steps() const { return steps_; }
  ARCSPAN_INLINE constexpr void next() { steps_.next(); }

 private:
  Steps steps_;
};

/// u and v along a row, in pieces over which they are linear: as many pixels as keep the error of perspective
/// below half a texel and two pixels. At the ends of pieces u = (u/w) / (1/w), by a table of reciprocals.
template <class StepsType, TextureFilter Filter>
class PerspectiveTexture {
 public:
  using Steps = StepsType;
  static constexpr bool kInPerspective = true;
  static constexpr bool kHasLevel = false;

  /// Pieces change the mip level of the triangle, so that rows begin with that of the row above.
  ARCSPAN_INLINE constexpr PerspectiveTexture(TextureTriangle& t, const RowStart& row)
      : steps_(t),
        triangle_(&t),
        u_(linear_at(t.u, row).raw()),
        v_(linear_at(t.v, row).raw()),
        q_(linear_at(t.q, row).raw()),
        at_(divided()) {}
  [[nodiscard]] ARCSPAN_INLINE constexpr const Steps& steps() const { return steps_; }
  /// The first texel of the mip level of the current piece.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t first() const { return triangle_->first; }
  ARCSPAN_INLINE constexpr void next() { steps_.next(); }
  /// Begins the next piece of a row of which `left` pixels are left, at least 1. Returns its length.
  ARCSPAN_OUTLINE constexpr std::int32_t enter(std::int32_t left) {
    const std::int32_t length = length_of_piece(left);
    // The last piece ends at its last pixel, because 1/w may vanish beyond the triangle.
    const bool last = length >= left;
    const std::int32_t steps = last ? left - 1 : length;
    End end = at_;
    std::int32_t du = 0;
    std::int32_t dv = 0;
    if (steps != 0) {
      u_ = wrap_add(u_, wrap_mul(triangle_->u.dx.raw(), steps));
      v_ = wrap_add(v_, wrap_mul(triangle_->v.dx.raw(), steps));
      q_ = wrap_add(q_, wrap_mul(triangle_->q.dx.raw(), steps));
      end = divided();
      const std::int32_t inverse = detail::kPieceInverses[static_cast<std::size_t>(steps)];
      const auto step = [inverse](std::int32_t from, std::int32_t to) {
        return multiply_high(wrap_shl(wrap_sub(to, from), 2), inverse);
      };
      du = step(at_.u, end.u);
      dv = step(at_.v, end.v);
    }
    if (triangle_->size.levels != 1) choose_level((at_.log_q + end.log_q) >> 1);
    const auto word = [](std::int32_t relative, int shift) {
      return static_cast<std::uint32_t>(detail::to_word<Steps>(relative, shift));
    };
    std::uint32_t u = triangle_->u_origin + word(at_.u, triangle_->u_shift);
    std::uint32_t v = triangle_->v_origin + word(at_.v, triangle_->v_shift);
    if constexpr (Filter == TextureFilter::kBilinear) {
      u -= triangle_->half_texel_u();
      v -= triangle_->half_texel_v();
    }
    steps_.start(u, v);
    steps_.set_step(detail::to_word<Steps>(du, triangle_->u_shift),
                    detail::to_word<Steps>(dv, triangle_->v_shift));
    at_ = end;
    return last ? left : length;
  }

 private:
  /// An end of a piece.
  struct End {
    std::int32_t u;      ///< relative to TextureTriangle::u_origin, 28 fraction bits
    std::int32_t v;      ///< the same to v_origin
    std::int32_t log_q;  ///< low_log2() of the raw value of 1/w
  };

  /// The current pixel as an end, by division.
  [[nodiscard]] ARCSPAN_INLINE constexpr End divided() const {
    // Rounding may lower 1/w below the least of the vertices, by far less than half of it.
    const std::int32_t least = triangle_->least_q >> 1;
    const auto q = static_cast<std::uint32_t>(q_ < least ? least : q_);
    const int zeros = leading_zeros(q | 1u);
    const auto inverse = static_cast<std::int32_t>(detail::reciprocal_mantissa(q << zeros) << 14);
    return {multiply_high(wrap_shl(u_, zeros - 1), inverse), multiply_high(wrap_shl(v_, zeros - 1), inverse),
            detail::low_log2(q)};
  }
  /// Returns the length of the next piece. It is doubled while 1/w is large enough for that: the error in
  /// texels is as the square of the length over the cube of 1/w, that in pixels as the square over 1/w.
  [[nodiscard]] constexpr std::int32_t length_of_piece(std::int32_t left) const {
    const std::int32_t fall = triangle_->q.dx.raw() < 0 ? triangle_->q.dx.raw() : 0;
    std::int32_t length = triangle_->piece;
    auto threshold = static_cast<std::uint32_t>(triangle_->piece_q);
    auto pixel_q = static_cast<std::uint32_t>(triangle_->pixel_q);
    while (length < left && 2 * length <= kLongestPiece) {
      const std::int32_t longer = 2 * length;
      threshold += (threshold >> 1) + (threshold >> 4) + (threshold >> 5);  // times 2^(2/3), a bit more
      const std::int32_t end = wrap_add(q_, wrap_mul(fall, longer < left ? longer : left));
      if (end < 0 || static_cast<std::uint32_t>(end) < threshold) break;
      if (static_cast<std::uint32_t>(end) >> 2 < pixel_q) break;  // twice the length needs 4 times the 1/w
      pixel_q <<= 2;
      length = longer;
    }
    return length;
  }
  /// Chooses the mip level of a piece. `log_q` is the mean of End::log_q at both ends.
  ARCSPAN_INLINE constexpr void choose_level(std::int32_t log_q) {
    TextureTriangle& t = *triangle_;
    const unsigned chosen = detail::level_of_side(t.size, t.sides.log_longer(log_q));
    if (chosen != t.number) [[unlikely]]
      set_level(chosen);
  }
  ARCSPAN_OUTLINE constexpr void set_level(unsigned number) {
    triangle_->set(triangle_->size, number);
    steps_.set_size(*triangle_);
  }

  Steps steps_;
  TextureTriangle* triangle_;
  std::int32_t u_;  ///< u, or u/w, at the end of the current piece, as Linear
  std::int32_t v_;
  std::int32_t q_;
  End at_;  ///< of the current piece
};

}  // namespace arcspan
