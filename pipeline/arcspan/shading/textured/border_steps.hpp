// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/textured/texture_triangle.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// The texels of a row's pixels as TexelSteps, but beyond the borders of the texture those that its sampler
/// names. u and v are two words, because a JoinedPoint does not tell in which repetition it is.
class BorderSteps {
 public:
  static constexpr bool kHasBorders = true;

  /// The texels around a pixel, as TexelSteps::around() tells them.
  class Around {
   public:
    constexpr Around(std::uint32_t index, std::uint32_t to_right, std::uint32_t below)
        : index_(index), to_right_(to_right), below_(below) {}
    [[nodiscard]] constexpr std::uint32_t index() const { return index_; }
    [[nodiscard]] constexpr std::uint32_t to_right(std::uint32_t) const { return to_right_; }
    [[nodiscard]] constexpr std::uint32_t below(std::uint32_t) const { return below_; }

   private:
    std::uint32_t index_;
    std::uint32_t to_right_;
    std::uint32_t below_;
  };

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

  ARCSPAN_INLINE constexpr explicit BorderSteps(const TextureLevel& t)
      : level_(&t), beyond_(~std::uint32_t{0} << (32 - t.spare_bits)) {
    set_size(t);
  }
  /// Goes on in another level of the texture.
  ARCSPAN_INLINE constexpr void set_size(const TextureLevel& t) {
    width_bits_ = t.width_bits;
    u_shift_ = 32 - t.spare_bits - t.width_bits;
    v_shift_ = 32 - t.spare_bits - t.height_bits;
  }

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
      const TextureLevel& level = hidden_level();
      u = within(u, level.u_wrap);
      v = within(v, level.v_wrap);
    }
    return v >> v_shift_ << width_bits_ | u >> u_shift_;
  }
  /// The four texels around the current pixel. At a border some of them may be the same, and in a mirrored
  /// repetition the next ones lie to the left and above.
  [[nodiscard]] ARCSPAN_INLINE constexpr Around around() const {
    const std::uint32_t u_next = u_ + (std::uint32_t{1} << u_shift_);
    const std::uint32_t v_next = v_ + (std::uint32_t{1} << v_shift_);
    if (((u_ | v_ | u_next | v_next) & beyond_) != 0) [[unlikely]] {
      const TextureLevel& level = hidden_level();
      const std::uint32_t u = within(u_, level.u_wrap) >> u_shift_;
      const std::uint32_t v = within(v_, level.v_wrap) >> v_shift_;
      return {v << width_bits_ | u, (within(u_next, level.u_wrap) >> u_shift_) - u,
              within(v_next, level.v_wrap) >> v_shift_ << width_bits_ | u};
    }
    const std::uint32_t here = v_ >> v_shift_ << width_bits_ | u_ >> u_shift_;
    return {here, 1, here + (std::uint32_t{1} << width_bits_)};
  }
  /// Where the current pixel lies between the first of these texels and the next ones, 0...31.
  [[nodiscard]] constexpr std::uint32_t fraction_right() const { return (u_ >> (u_shift_ - 5)) & 31u; }
  [[nodiscard]] constexpr std::uint32_t fraction_below() const { return (v_ >> (v_shift_ - 5)) & 31u; }

 private:
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint32_t upper(std::uint64_t word) {
    return static_cast<std::uint32_t>(word >> 32);
  }
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint32_t lower(std::uint64_t word) {
    return static_cast<std::uint32_t>(word);
  }
  /// The level, whose wraps would otherwise take registers of every pixel.
  [[nodiscard]] ARCSPAN_INLINE constexpr const TextureLevel& hidden_level() const {
    const TextureLevel* level = level_;
    hide_value(level);
    return *level;
  }
  /// The place within the texture that is shown at `word`.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t within(std::uint32_t word, TextureWrap wrap) const {
    hide_value(word);  // otherwise gcc steps ~word beside word in every pixel
    if (wrap == TextureWrap::kClamp) {
      if ((word & beyond_) != 0) word = ~static_cast<std::uint32_t>(static_cast<std::int32_t>(word) >> 31);
    } else if (wrap == TextureWrap::kMirror) {
      const std::uint32_t parity = beyond_ & (0 - beyond_);  // of the repetition
      if ((word & parity) != 0) word = ~word;
    }
    return word & ~beyond_;
  }

  const TextureLevel* level_;
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
