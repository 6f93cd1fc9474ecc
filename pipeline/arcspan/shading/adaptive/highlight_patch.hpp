// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/pixel_light.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/prepare/linear.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/shading/patch/joined_run.hpp>
#include <arcspan/shading/patch/patch.hpp>
#include <arcspan/shading/patch/patch_limits.hpp>
#include <arcspan/shading/patch/patch_walker.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan {

/// Two scalars stepped by second differences.
using CurvedSteps = std::conditional_t<kHasWideRegisters, JoinedRun<0, false>, SecondDifferenceRun<2>>;

/// The diffuse_scalar() and the scaled distance of a highlight (HighlightTable), both stepped by second
/// differences.
class CurvedHighlight : public CurvedSteps {
 public:
  static constexpr std::size_t kUsed = 2;

  [[nodiscard]] constexpr Cosine diffuse() const { return scalars()[0]; }
  [[nodiscard]] constexpr std::int32_t distance() const { return scalars()[1].raw(); }
};

/// Like CurvedHighlight, with a diffuse scalar that is linear on the screen.
class LinearHighlight {
 public:
  static constexpr std::size_t kUsed = 2;

  ARCSPAN_INLINE constexpr void start(FullLinear light, FullLinear step, const PatchScalar& distance,
                                      const RowStart& start) {
    light_ = Cosine::from_raw(light.raw());
    step_ = Cosine::from_raw(step.raw());
    distance_.start(0, distance, start.fraction);
    if (start.skipped != 0) distance_.skip(start.skipped);
  }
  ARCSPAN_INLINE constexpr void next() {
    light_ += step_;
    distance_.next();
  }
  [[nodiscard]] constexpr Cosine diffuse() const { return light_; }
  [[nodiscard]] constexpr std::int32_t distance() const { return distance_.scalars()[0].raw(); }

 private:
  Cosine light_;
  Cosine step_;
  SecondDifferenceRun<1> distance_;
};

/// The highlights that a SteppedHighlightRun can draw.
enum class HighlightPixels : std::uint8_t {
  kAny,           ///< of any colour
  kOnlyWhite,     ///< white ones
  kWhiteFitting,  ///< white ones in a triangle of which AdaptiveIllumination::never_saturates() is true
};

/// The pixels of a row (PixelRun) with the highlight of one light. `Steps` has the diffuse scalar and the
/// highlight's distance: stepped (CurvedHighlight, LinearHighlight) or computed (HighlightProduct; decision
/// 7).
template <class Lighting, class Steps, HighlightPixels kPixels>
class SteppedHighlightRun : public Steps {
 public:
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb colour(const Lighting& lighting) const {
    if constexpr (kPixels == HighlightPixels::kOnlyWhite) {
      return lighting.colour_with_white_at(this->diffuse(), this->distance());
    } else if constexpr (kPixels == HighlightPixels::kWhiteFitting) {
      return lighting.colour_with_fitting_white_at(this->diffuse(), this->distance());
    }
    return lighting.colour_with_highlight_at(this->diffuse(), this->distance(), weight());
  }
  /// Returns the parts of colour() (LightRun).
  [[nodiscard]] ARCSPAN_INLINE constexpr PixelLight light(const Lighting& lighting) const {
    if constexpr (kPixels != HighlightPixels::kAny)
      return lighting.light_with_white_at(this->diffuse(), this->distance());
    return lighting.light_with_highlight_at(this->diffuse(), this->distance(), weight());
  }
  constexpr void set_weight(std::uint32_t weight) {
    if constexpr (Lighting::kLights > 1) weight_[0] = weight;
  }

 private:
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t weight() const {
    if constexpr (Lighting::kLights > 1) return weight_[0];
    return std::uint32_t{1} << 15;
  }
  std::array<std::uint32_t, Lighting::kLights == 1 ? 0 : 1> weight_;  ///< highlight_weight() of its light
};

template <class Lighting>
using HighlightPatchRun = SteppedHighlightRun<Lighting, CurvedHighlight, HighlightPixels::kAny>;

/// Steps a highlight patch (RowWalker).
template <class Lighting, std::size_t Count>
class HighlightPatchWalker : public PatchWalker<HighlightPatchRun<Lighting>, Count> {
 public:
  using Base = PatchWalker<HighlightPatchRun<Lighting>, Count>;
  using typename Base::Run;

  constexpr HighlightPatchWalker(Patch<Count>& patch, bool middle_left, std::uint32_t weight)
      : Base(patch, middle_left), weight_(weight) {}
  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    Run run = Base::row(start);
    run.set_weight(weight_);
    return run;
  }

 private:
  std::uint32_t weight_;
};

/// Returns the HighlightPixels of a TriangleFrame by one light, whose half distance is at least `nearest`.
template <class Lighting, class Frame>
[[nodiscard]] constexpr HighlightPixels highlight_pixels_of(const Lighting& lighting, const Frame& frame,
                                                            std::int32_t nearest) {
  if (!lighting.highlight_table().is_always_white()) return HighlightPixels::kAny;
  const Cosine top = frame.top->shade.scalars[0];
  const Cosine middle = frame.middle->shade.scalars[0];
  const Cosine bottom = frame.bottom->shade.scalars[0];
  const Cosine upper = top > middle ? top : middle;
  const Cosine highest = upper > bottom ? upper : bottom;
  const bool fits = lighting.never_saturates(highest + arc_headroom(frame.chords.widest()), nearest);
  return fits ? HighlightPixels::kWhiteFitting : HighlightPixels::kOnlyWhite;
}

/// Steps a highlight patch whose diffuse scalar is linear on the screen (RowWalker): a plane and one scalar
/// of a patch, which it changes in place.
template <class Lighting, HighlightPixels kPixels>
class LinearHighlightWalker {
 public:
  using Run = SteppedHighlightRun<Lighting, LinearHighlight, kPixels>;

  constexpr LinearHighlightWalker(FullLinearPlane& light, PatchScalar& distance, bool middle_left,
                                  std::uint32_t weight)
      : light_(&light), distance_(&distance), middle_left_(middle_left), weight_(weight) {}

  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    Run run;
    run.start(linear_at(*light_, start), light_->dx, *distance_, start);
    run.set_weight(weight_);
    return run;
  }
  constexpr void next_row() {
    light_->next_row();
    distance_->left.advance();
  }
  constexpr void enter_lower() {
    light_->enter_lower(middle_left_);
    if (middle_left_) distance_->left.become(distance_->lower);
  }

 private:
  FullLinearPlane* light_;
  PatchScalar* distance_;
  bool middle_left_;
  std::uint32_t weight_;
};

}  // namespace arcspan
