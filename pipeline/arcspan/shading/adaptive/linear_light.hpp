// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/linear.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// N·L that is linear on the screen, for triangles where that is near enough and no highlight is to be seen:
/// one addition and one look-up a pixel.
struct LinearLight {
  static constexpr int kFraction = Cosine::kFraction - FullLinear::kFraction;

  /// N·L of a vertex as a signed attribute, rounded.
  [[nodiscard]] static constexpr std::int32_t level(Cosine normal_light) {
    return round_shift(normal_light.raw(), FullLinear::kFraction);
  }
};

/// A row whose N·L steps evenly and whose highlight cannot be seen: a pixel is one addition and its colour.
template <class Lighting>
class LinearLightRun {
 public:
  constexpr LinearLightRun(FullLinear at, FullLinear step)
      : light_(Cosine::from_raw(at.raw())), step_(Cosine::from_raw(step.raw())) {}

  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb colour(const Lighting& lighting) const {
    return lighting.diffuse_colour(light_);
  }
  /// The same, encoded; `encoded` is an EncodedColourTable.
  template <class Format, class Colours>
  [[nodiscard]] ARCSPAN_INLINE constexpr typename Format::Encoded encoded(const Lighting&,
                                                                          const Colours& encoded) const {
    return encoded[light_];
  }
  constexpr void next() { light_ += step_; }

 private:
  Cosine light_;
  Cosine step_;
};

/// The rows of such a triangle (RowWalker).
template <class Lighting>
class LinearLightWalker {
 public:
  using Run = LinearLightRun<Lighting>;
  static constexpr std::int32_t kLongestRun = 2 * kGuardBand;

  constexpr LinearLightWalker(FullLinearPlane& light, bool middle_left)
      : light_(&light), middle_left_(middle_left) {}

  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    return Run(linear_at(*light_, start), light_->dx);
  }
  constexpr void next_row() { light_->next_row(); }
  constexpr void enter_lower() { light_->enter_lower(middle_left_); }

 private:
  FullLinearPlane* light_;
  bool middle_left_;
};

}  // namespace arcspan
