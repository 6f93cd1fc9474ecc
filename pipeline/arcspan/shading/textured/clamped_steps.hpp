// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/textured/texture_triangle.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// The texels of a row's pixels as TexelSteps, but beyond the borders of the texture those along the border.
/// u and v are two words, because a JoinedPoint does not tell in which repetition it is.
class ClampedSteps {
 public:
  static constexpr bool kClamps = true;

  /// The members of JoinedPoint, for u in the upper and v in the lower half.
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint64_t joined(std::uint32_t u, std::uint32_t v,
                                                                     unsigned = 0) {
    return std::uint64_t{u} << 32 | v;
  }
  [[nodiscard]] static constexpr std::int32_t rounded(std::int32_t u, unsigned) { return u; }
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint64_t step(std::int32_t u, std::int32_t v, unsigned) {
    return joined(static_cast<std::uint32_t>(u), static_cast<std::uint32_t>(v));
  }
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint64_t sum(std::uint64_t a, std::uint64_t b) {
    return joined(upper(a) + upper(b), lower(a) + lower(b));
  }
  [[nodiscard]] static constexpr std::uint64_t negative(std::uint64_t a) {
    return joined(0 - upper(a), 0 - lower(a));
  }
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint64_t times(std::uint64_t step,
                                                                    std::uint32_t factor) {
    return joined(upper(step) * factor, lower(step) * factor);
  }

  ARCSPAN_INLINE constexpr explicit ClampedSteps(const TextureLevel& t)
      : width_bits_(t.width_bits),
        u_shift_(32 - t.spare_bits - t.width_bits),
        v_shift_(32 - t.spare_bits - t.height_bits),
        beyond_(~std::uint32_t{0} << (32 - t.spare_bits)) {}

  /// Starts at u and v, signed fractions of 2^spare_bits repetitions.
  ARCSPAN_INLINE constexpr void start(std::uint32_t u, std::uint32_t v) {
    u_ = u;
    v_ = v;
  }
  ARCSPAN_INLINE constexpr void start_at(std::uint64_t joined) {
    u_ = upper(joined);
    v_ = lower(joined);
  }
  ARCSPAN_INLINE constexpr void set_step(std::uint64_t step) {
    du_ = upper(step);
    dv_ = lower(step);
  }
  ARCSPAN_INLINE constexpr void set_step(std::int32_t u, std::int32_t v) {
    du_ = static_cast<std::uint32_t>(u);
    dv_ = static_cast<std::uint32_t>(v);
  }
  ARCSPAN_INLINE constexpr void next() {
    u_ += du_;
    v_ += dv_;
  }

  /// The index of the current texel in its level.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t index() const {
    std::uint32_t u = u_;
    std::uint32_t v = v_;
    if (((u | v) & beyond_) != 0) [[unlikely]] {
      u = clamped(u);
      v = clamped(v);
    }
    return v >> v_shift_ << width_bits_ | u >> u_shift_;
  }
  /// The distance of the texel to the right of the current one, and of that below it; and the index of the
  /// texel below.
  [[nodiscard]] constexpr std::uint32_t to_right(std::uint32_t) const {
    return has_next(u_, u_shift_) ? 1 : 0;
  }
  [[nodiscard]] constexpr std::uint32_t below(std::uint32_t texel) const {
    return texel + (has_next(v_, v_shift_) ? std::uint32_t{1} << width_bits_ : 0);
  }
  /// Where the current pixel lies between the current texel and these two, 0...31.
  [[nodiscard]] constexpr std::uint32_t fraction_right() const { return (u_ >> (u_shift_ - 5)) & 31u; }
  [[nodiscard]] constexpr std::uint32_t fraction_below() const { return (v_ >> (v_shift_ - 5)) & 31u; }

 private:
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint32_t upper(std::uint64_t word) {
    return static_cast<std::uint32_t>(word >> 32);
  }
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint32_t lower(std::uint64_t word) {
    return static_cast<std::uint32_t>(word);
  }
  /// The nearest place within the texture.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t clamped(std::uint32_t word) const {
    if ((word & beyond_) == 0) return word;
    return static_cast<std::int32_t>(word) < 0 ? 0 : ~beyond_;
  }
  /// True if a texel lies to the right of the texel of `word`, or below it.
  [[nodiscard]] constexpr bool has_next(std::uint32_t word, int shift) const {
    return (word & beyond_) == 0 && word >> shift != ~beyond_ >> shift;
  }

  std::uint32_t u_ = 0;
  std::uint32_t v_ = 0;
  std::uint32_t du_ = 0;
  std::uint32_t dv_ = 0;
  int width_bits_;
  int u_shift_;
  int v_shift_;
  std::uint32_t beyond_;  ///< bits that are set beyond the texture
};

}  // namespace arcspan
