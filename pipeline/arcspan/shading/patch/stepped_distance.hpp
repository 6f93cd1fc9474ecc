// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/lighting/pixel_light.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/shading/patch/patch_walker.hpp>
#include <arcspan/shading/patch/raise_patch.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

/// Patches with Blinn's highlight of one light. Its distance (1 - N·H) / 2 is linear in N·H, so that a patch
/// can step it in the scale of the table of powers (PowerTable::scaled()) instead of N·H.
namespace arcspan {

/// True if Arc may step the distance of Blinn's highlight: `Lighting` is by one light with that highlight, or
/// its lights are known at run time only.
template <class Lighting>
inline constexpr bool kMayStepBlinnDistance =
    kMayHaveOneLight<Lighting>&& requires(const Lighting& lighting) {
  requires(Lighting::kHasRamp);
  lighting.model();
  lighting.power();
}
&&!requires { requires(Lighting::kModel == Highlight::kPhong); };
/// True if it is known at compile time that Arc steps it in every patch with a highlight.
template <class Lighting>
inline constexpr bool kAlwaysStepsBlinnDistance = kMayStepBlinnDistance<Lighting>&& requires {
  requires(Lighting::kModel == Highlight::kBlinn);
};
/// Returns true if Arc steps it in every patch with a highlight. Requires kMayStepBlinnDistance.
template <class Lighting>
[[nodiscard]] constexpr bool steps_blinn_distance(const Lighting& lighting) {
  return lighting.lights() == 1 && lighting.model() == Highlight::kBlinn;
}

/// The scaled distance that counts as 0 in a SteppedDistanceRun. On processors that saturate it is the end of
/// the highlight, so that signs tell what is within reach and lit.
inline constexpr std::int32_t kSteppedOrigin = kHasSaturate ? PowerTable::kReach : 0;

/// The pixels of a row (PixelRun): N·L, and a scaled distance less kSteppedOrigin.
template <class Lighting>
class SteppedDistanceRun : public SecondDifferenceRun<2> {
 public:
  static constexpr std::size_t kUsed = 2;

  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb colour(const Lighting& lighting) const {
    const PackedRgb diffuse = lighting.diffuse_colour(scalars()[0]);
    return misses() ? diffuse : diffuse.plus(highlight(lighting));
  }
  /// Returns the parts of colour() (LightRun).
  [[nodiscard]] ARCSPAN_INLINE constexpr PixelLight light(const Lighting& lighting) const {
    return {lighting.diffuse_colour(scalars()[0]), misses() ? PackedRgb{} : highlight(lighting)};
  }

 private:
  /// N·L = 0 counts as lit, because a vertex is.
  [[nodiscard]] constexpr bool misses() const {
    const std::int32_t light = scalars()[0].raw();
    const std::int32_t distance = scalars()[1].raw();
    if constexpr (kHasSaturate) return (distance & ~light) >= 0;
    return light < 0 || distance >= PowerTable::kReach;
  }
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb highlight(const Lighting& lighting) const {
    std::int32_t distance = scalars()[1].raw();
    if constexpr (kHasSaturate) distance = clamped_to_bits<26>(distance) & (PowerTable::kReach - 1);
    return lighting.highlight(lighting.power().at_scaled(distance));
  }
};

/// Returns true if the highlight does not fade in a triangle: it ends abruptly, or every vertex is out of the
/// fade.
template <class Lighting, class Frame>
[[nodiscard]] constexpr bool is_out_of_fade(const Lighting& lighting, const Frame& frame) {
  if (lighting.fade_end().raw() == 0) return true;
  // Above the end of the fade by 2^-10, which is more than any rounding error.
  const std::int32_t from = lighting.fade_end().raw() + (std::int32_t{1} << 20);
  return frame.top->shade.scalars[0].raw() >= from && frame.middle->shade.scalars[0].raw() >= from &&
         frame.bottom->shade.scalars[0].raw() >= from;
}

/// Returns true if a vertex of a TriangleFrame has N·L > 0, of one light.
template <class Frame>
[[nodiscard]] constexpr bool has_lit_vertex(const Frame& frame) {
  return frame.top->shade.scalars[0].raw() > 0 || frame.middle->shade.scalars[0].raw() > 0 ||
         frame.bottom->shade.scalars[0].raw() > 0;
}

/// Prepares the patch of SteppedDistanceRun for a TriangleFrame that is_out_of_fade(). (1 - N·H) / 2 is a
/// constant less a scalar that is linear in the normal, and the patch of that is raised by the constant.
///
/// A triangle within reach of the highlight that is a patch is less than 15 times as far from it as the
/// reach, and at least 4 pixels wide beyond widest_patch(), so that slopes fit.
template <class Lighting, class Frame, std::size_t Count>
constexpr void prepare_stepped_distance(const Lighting& lighting, const Frame& frame, Patch<Count>& patch) {
  constexpr std::size_t kOther = Lighting::highlight_index(0);
  const auto& top = frame.top->shade.scalars;
  const auto& middle = frame.middle->shade.scalars;
  const auto& bottom = frame.bottom->shade.scalars;
  const EdgeSagittaFactors factors = sagitta_factors_of(frame.chords);
  make_patch_scalar(frame, factors, {top[0], middle[0], bottom[0]}, patch[0]);
  const PowerTable& power = lighting.power();
  const auto fall = [&power](Cosine other) { return Cosine::from_raw(power.scaled(-(other.raw() >> 1))); };
  PatchScalar& distance = patch[1];
  make_patch_scalar(frame, factors, {fall(top[kOther]), fall(middle[kOther]), fall(bottom[kOther])},
                    distance);
  const auto half =
      Cosine::from_raw(power.scaled(std::int32_t{1} << (Cosine::kFraction - 1)) - kSteppedOrigin);
  raise_patch_scalar(frame, half, distance);
}

}  // namespace arcspan
