// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/span/linear_walk.hpp>

#include <cstdint>

namespace arcspan {

/// N·L that is linear on the screen, for triangles where that is near enough and no highlight is to be seen:
/// one addition and one look-up a pixel.
struct LinearLight {
  static constexpr int kFraction = Unit::kFraction - FullLinear::kFraction;

  /// N·L of a vertex as a signed attribute, rounded.
  [[nodiscard]] static constexpr std::int32_t level(Unit normal_light) {
    return round_shift(normal_light.raw(), FullLinear::kFraction);
  }
};

/// A row whose N·L steps evenly and whose highlight cannot be seen: a pixel is one addition and its colour.
template <class Object>
class LinearLightRun {
 public:
  constexpr LinearLightRun(FullLinear at, FullLinear step)
      : light_(Unit::from_raw(at.raw())), step_(Unit::from_raw(step.raw())) {}

  [[nodiscard, gnu::always_inline]] constexpr PackedRgb colour(const Object& object) const {
    return object.diffuse_colour(light_);
  }
  /// The same, encoded; `codes` is a CodeTable.
  template <class Format, class Codes>
  [[nodiscard, gnu::always_inline]] constexpr typename Format::Code code(const Object&,
                                                                         const Codes& codes) const {
    return codes[light_];
  }
  constexpr void next() { light_ += step_; }

 private:
  Unit light_;
  Unit step_;
};

/// The rows of such a triangle (RowWalker).
template <class Object>
class LinearLightWalker {
 public:
  using Run = LinearLightRun<Object>;
  static constexpr std::int32_t kLongestRun = 2 * kGuardBand;

  constexpr LinearLightWalker(FullLinearPlane& light, bool middle_left)
      : light_(&light), middle_left_(middle_left) {}

  [[nodiscard, gnu::always_inline]] constexpr Run row(const RowStart& start) const {
    return Run(linear_at(*light_, start), light_->dx);
  }
  constexpr void next_row() { light_->next_row(); }
  constexpr void enter_lower() { light_->enter_lower(middle_left_); }

 private:
  FullLinearPlane* light_;
  bool middle_left_;
};

}  // namespace arcspan
