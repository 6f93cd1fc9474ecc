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
  static constexpr int kDrop = 15;              ///< from a Unit to 15 fraction bits
  static constexpr std::int32_t kZero = 32768;  ///< N·L = 0 as a 16-bit attribute, of which 1 is the most

  /// N·L of a vertex as a 16-bit attribute, rounded.
  [[nodiscard]] static constexpr std::int32_t level(Unit normal_light) {
    const std::int32_t level = kZero + round_shift(normal_light.raw(), kDrop);
    return level < 0 ? 0 : level > 65535 ? 65535 : level;
  }
};

/// A row whose N·L steps evenly and whose highlight cannot be seen: a pixel is one addition and its colour.
template <class Object>
class LinearLightRun {
 public:
  constexpr LinearLightRun(Linear at, Linear step) : light_(unit(at - kZero)), step_(unit(step)) {}

  [[nodiscard]] constexpr PackedRgb colour(const Object& object) const {
    return object.diffuse_colour(light_);
  }
  /// The same, encoded; `codes` is a CodeTable.
  template <class Format, class Codes>
  [[nodiscard]] constexpr typename Format::Code code(const Object&, const Codes& codes) const {
    return codes[light_];
  }
  constexpr void next() { light_ += step_; }

 private:
  static constexpr Linear kZero = Linear::from_raw(LinearLight::kZero << Linear::kFraction);
  static constexpr int kUp = LinearLight::kDrop - Linear::kFraction;
  [[nodiscard]] static constexpr Unit unit(Linear value) {
    return Unit::from_raw(wrap_shl(value.raw(), kUp));
  }

  Unit light_;
  Unit step_;
};

/// The rows of such a triangle (RowWalker).
template <class Object>
class LinearLightWalker {
 public:
  using Run = LinearLightRun<Object>;
  static constexpr std::int32_t kLongestRun = 2 * kGuardBand;

  constexpr LinearLightWalker(LinearPlane& light, bool middle_left)
      : light_(&light), middle_left_(middle_left) {}

  [[nodiscard]] constexpr Run row(const RowStart& start) const {
    return Run(linear_at(*light_, start), light_->dx);
  }
  constexpr void next_row() { light_->next_row(); }
  constexpr void enter_lower() { light_->enter_lower(middle_left_); }

 private:
  LinearPlane* light_;
  bool middle_left_;
};

}  // namespace arcspan
