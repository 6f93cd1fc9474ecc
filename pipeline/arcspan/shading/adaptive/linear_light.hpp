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

  [[nodiscard]] ARCSPAN_INLINE constexpr Cosine light() const { return light_; }
  constexpr void next() { light_ += step_; }

 private:
  Cosine light_;
  Cosine step_;
};

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
  [[nodiscard]] ARCSPAN_INLINE constexpr Cosine light() const {
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

/// The pixels of a row (PixelRun) without highlight, whose N·L is linear: one addition and one look-up per
/// pixel. `Steps` is LightSteps or LightAndDepth.
template <class Lighting, class Steps = LightSteps>
class LinearLightRun : public Steps {
 public:
  static constexpr std::size_t kUsed = 1;

  using Steps::light;
  using Steps::Steps;

  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb colour(const Lighting& lighting) const {
    return lighting.diffuse_colour(light());
  }
  /// Returns the parts of colour() (LightRun).
  [[nodiscard]] ARCSPAN_INLINE constexpr PixelLight light(const Lighting& lighting) const {
    return {lighting.diffuse_colour(light()), {}};
  }
  /// Returns colour() encoded in `Format`; `encoded` is an EncodedColourTable (EncodingRun).
  template <class Format, class Colours>
  [[nodiscard]] ARCSPAN_INLINE constexpr typename Format::Encoded encoded(const Lighting&,
                                                                          const Colours& encoded) const {
    return encoded[light()];
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
  constexpr void skip_rows(std::int32_t rows) { light_->skip_rows(rows); }
  constexpr void enter_lower() { light_->enter_lower(middle_left_); }

 private:
  FullLinearPlane* light_;
  bool middle_left_;
};

/// The planes of N·L and of the depth as LightAndDepth.
struct LightAndDepthPlane {
  std::uint64_t at;    ///< on the left edge
  std::uint64_t step;  ///< per row
  std::uint64_t lower_at;
  std::uint64_t lower_step;
  std::uint64_t dx;          ///< per pixel
  std::int64_t upper_light;  ///< the gradient of N·L, without its lower half
  std::int64_t depth_dx;
};

/// Used where both are stepped separately.
struct NoLightAndDepthPlane {};

/// LinearLightWalker that steps N·L and the depth together (StepsDepth).
template <class Lighting>
class LightAndDepthWalker {
 public:
  using Run = LinearLightRun<Lighting, LightAndDepth>;

  constexpr LightAndDepthWalker(const FullLinearPlane& light, LightAndDepthPlane& plane, bool middle_left)
      : light_(&light), plane_(&plane), middle_left_(middle_left) {}
  ARCSPAN_INLINE constexpr void take_depth(const LinearPlane& depth) {
    const auto joined = [](FullLinear light, Linear z) {
      return LightAndDepth::of_light(light) + LightAndDepth::of_depth(z);
    };
    plane_->at = joined(light_->left.at, depth.left.at) + LightAndDepth::kStart;
    plane_->step = joined(light_->left.step, depth.left.step);
    plane_->dx = joined(light_->dx, depth.dx);
    plane_->upper_light = light_->dx.raw() >> 16;
    plane_->depth_dx = depth.dx.raw();
    if (!middle_left_) return;
    plane_->lower_at = joined(light_->lower.at, depth.lower.at) + LightAndDepth::kStart;
    plane_->lower_step = joined(light_->lower.step, depth.lower.step);
  }

  /// linear_at() of both planes.
  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    const auto light = static_cast<std::uint64_t>(plane_->upper_light * start.fraction);
    const auto depth = static_cast<std::uint64_t>((plane_->depth_dx * start.fraction) >> 16);
    std::uint64_t at = plane_->at + light + (depth << 32);
    if (start.skipped != 0) at += plane_->dx * static_cast<std::uint64_t>(start.skipped);
    return Run(at, plane_->dx);
  }
  constexpr void next_row() { plane_->at += plane_->step; }
  constexpr void skip_rows(std::int32_t rows) {
    plane_->at += plane_->step * static_cast<std::uint64_t>(rows);
  }
  constexpr void enter_lower() {
    if (!middle_left_) return;
    plane_->at = plane_->lower_at;
    plane_->step = plane_->lower_step;
  }

 private:
  const FullLinearPlane* light_;
  LightAndDepthPlane* plane_;
  bool middle_left_;
};

}  // namespace arcspan
