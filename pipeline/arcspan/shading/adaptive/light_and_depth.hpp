// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/linear.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/shading/adaptive/linear_light.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// N·L and the depth in one number, for machines with wide registers: the sum of N·L and 2^32 times the
/// depth, as signed numbers. The bits are those of two numbers as long as N·L does not leave the range of a
/// Cosine.
class LightAndDepth {
 public:
  /// N·L as a part of the number.
  [[nodiscard]] static constexpr std::uint64_t of_light(FullLinear light) {
    return static_cast<std::uint64_t>(std::int64_t{light.raw()});
  }
  /// The depth as a part of the number.
  [[nodiscard]] static constexpr std::uint64_t of_depth(Linear depth) {
    return static_cast<std::uint64_t>(std::int64_t{depth.raw()}) << 32;
  }
  /// A part of the number at a pixel: subtracting 2^31 from the sum gives back what N·L has borrowed.
  static constexpr std::uint64_t kStart = std::uint64_t{1} << 32;

  constexpr LightAndDepth(std::uint64_t at, std::uint64_t step) : at_(at), step_(step) {}
  [[nodiscard]] ARCSPAN_INLINE constexpr Cosine normal_light() const {
    return Cosine::from_raw(static_cast<std::int32_t>(at_));
  }
  [[nodiscard]] ARCSPAN_INLINE constexpr Linear depth() const {
    return Linear::from_raw(static_cast<std::int32_t>((at_ - (std::uint64_t{1} << 31)) >> 32));
  }
  constexpr void next() { at_ += step_; }

 private:
  std::uint64_t at_;
  std::uint64_t step_;
};

/// Steps N·L and the depth together from row to row (RowWalker).
template <class Lighting>
class LightAndDepthWalker {
 public:
  using Run = LinearLightRun<Lighting, LightAndDepth>;

  ARCSPAN_INLINE constexpr LightAndDepthWalker(const FullLinearPlane& light, const LinearPlane& depth,
                                               bool middle_left)
      : at_(joined(light.left.at, depth.left.at) + LightAndDepth::kStart),
        step_(joined(light.left.step, depth.left.step)),
        lower_at_(joined(light.lower.at, depth.lower.at) + LightAndDepth::kStart),
        lower_step_(joined(light.lower.step, depth.lower.step)),
        dx_(joined(light.dx, depth.dx)),
        upper_light_(light.dx.raw() >> 16),
        raised_depth_(hidden(std::int64_t{depth.dx.raw()} * (1 << 16))),
        middle_left_(middle_left) {}

  /// Does what linear_at() does with both planes.
  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    const auto light = static_cast<std::uint64_t>(upper_light_ * start.fraction);
    const auto depth = static_cast<std::uint64_t>(raised_depth_ * start.fraction);
    std::uint64_t at = at_ + light + (depth & 0xFFFFFFFF00000000u);
    if (start.skipped != 0) at += dx_ * static_cast<std::uint64_t>(start.skipped);
    return Run(at, dx_);
  }
  constexpr void next_row() {
    at_ += step_;
    hide_value(at_);  // gcc multiplies the rows by the step after the loop otherwise
  }
  constexpr void skip_rows(std::int32_t rows) { at_ += step_ * static_cast<std::uint64_t>(rows); }
  constexpr void enter_lower() {
    if (!middle_left_) return;
    at_ = lower_at_;
    step_ = lower_step_;
  }

 private:
  [[nodiscard]] static constexpr std::uint64_t joined(FullLinear light, Linear z) {
    return LightAndDepth::of_light(light) + LightAndDepth::of_depth(z);
  }

  std::uint64_t at_;    ///< on the left edge
  std::uint64_t step_;  ///< per row
  std::uint64_t lower_at_;
  std::uint64_t lower_step_;
  std::uint64_t dx_;           ///< per pixel
  std::int64_t upper_light_;   ///< the gradient of N·L, without its lower half
  std::int64_t raised_depth_;  ///< the gradient of the depth times 2^16
  bool middle_left_;
};

/// The walker of linear light where 64 bits fit one register. Drawn by itself, with a depth buffer, it steps
/// the depth too (JoinsDepth); inside another walker it is a LinearLightWalker.
template <class Lighting>
class JoiningLightWalker : public LinearLightWalker<Lighting> {
 public:
  using LinearLightWalker<Lighting>::LinearLightWalker;
  [[nodiscard]] ARCSPAN_INLINE constexpr LightAndDepthWalker<Lighting> with_depth(
      const LinearPlane& depth) const {
    return LightAndDepthWalker<Lighting>(this->plane(), depth, this->middle_left());
  }
};

}  // namespace arcspan
