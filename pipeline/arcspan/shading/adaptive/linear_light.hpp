// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/pixel_light.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/prepare/linear.hpp>
#include <arcspan/prepare/small_triangle.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// The format of N·L that is linear on the screen (decision 6): a FullLinear attribute in units of
/// 2^-kFraction, whose raw value is that of a Cosine.
struct LinearLight {
  static constexpr int kFraction = Cosine::kFraction - FullLinear::kFraction;

  /// Returns N·L of a vertex as a signed attribute, rounded to nearest: 15 fraction bits.
  [[nodiscard]] static constexpr std::int32_t level(Cosine normal_light) {
    return round_shift(normal_light.raw(), FullLinear::kFraction);
  }
};

/// N·L along a row.
class LightSteps {
 public:
  constexpr LightSteps(FullLinear at, FullLinear step)
      : light_(Cosine::from_raw(at.raw())), step_(Cosine::from_raw(step.raw())) {}

  [[nodiscard]] ARCSPAN_INLINE constexpr Cosine normal_light() const { return light_; }
  constexpr void next() { light_ += step_; }

 private:
  Cosine light_;
  Cosine step_;
};

/// The pixels of a row (PixelRun) without highlight, whose N·L is linear: one addition and one look-up per
/// pixel. `Steps` is LightSteps or LightAndDepth.
template <class Lighting, class Steps = LightSteps>
class LinearLightRun : public Steps {
 public:
  static constexpr std::size_t kUsed = 1;

  using Steps::normal_light;
  using Steps::Steps;

  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb colour(const Lighting& lighting) const {
    return lighting.diffuse_colour(normal_light());
  }
  /// Returns the parts of colour() (LightRun).
  [[nodiscard]] ARCSPAN_INLINE constexpr PixelLight light(const Lighting& lighting) const {
    return {lighting.diffuse_colour(normal_light()), {}};
  }
};

/// N·L of a small triangle that is linear on the screen.
template <class Lighting>
class SmallLinearLight {
 public:
  using Run = LinearLightRun<Lighting>;

  /// Prepares the plane through three levels.
  constexpr void prepare(std::int32_t a, std::int32_t b, std::int32_t c, const SmallTriangle& triangle) {
    a_ = a;
    b_ = b - a;
    c_ = c - a;
    // Where two pixels of a row are inside, no coordinate changes by more than 1; elsewhere the step may
    // wrap.
    step_ = at_coordinates(0, triangle.d_middle, triangle.d_bottom);
  }
  /// Returns the run that begins at the barycentric coordinates l_b and l_c, 16 fraction bits.
  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(std::int32_t, std::int32_t b, std::int32_t c) const {
    return Run(at_coordinates(a_, b, c), step_);
  }

 private:
  [[nodiscard]] ARCSPAN_INLINE constexpr FullLinear at_coordinates(std::int32_t a, std::int32_t b,
                                                                   std::int32_t c) const {
    const std::int32_t part = wrap_add(wrap_mul(b_, b >> 1), wrap_mul(c_, c >> 1));
    return FullLinear::from_raw(wrap_add(wrap_shl(a, FullLinear::kFraction), part));
  }

  std::int32_t a_;
  std::int32_t b_;
  std::int32_t c_;
  FullLinear step_;
};

/// Steps N·L along the left edge from row to row (RowWalker). It changes the plane in place.
template <class Lighting>
class LinearLightWalker {
 public:
  using Run = LinearLightRun<Lighting>;

  constexpr LinearLightWalker(FullLinearPlane& light, bool middle_left)
      : light_(&light), middle_left_(middle_left) {}

  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    return Run(linear_at(*light_, start), light_->dx);
  }
  constexpr void next_row() { light_->next_row(); }
  constexpr void enter_lower() { light_->enter_lower(middle_left_); }

 protected:
  [[nodiscard]] constexpr const FullLinearPlane& plane() const { return *light_; }
  [[nodiscard]] constexpr bool middle_left() const { return middle_left_; }

 private:
  FullLinearPlane* light_;
  bool middle_left_;
};

}  // namespace arcspan
