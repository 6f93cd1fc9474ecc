// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/lighting/pixel_light.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/shading/patch/diffuse_scalars.hpp>
#include <arcspan/shading/patch/patch_limits.hpp>
#include <arcspan/shading/patch/patch_walker.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

/// Patches of triangles that the highlight of one of several grey lights may reach (decision 28).
namespace arcspan {

/// Stands for a OneHighlight where illuminations have no such patches.
struct NoOneHighlight {};

/// The pixels of a row (PixelRun). Their scalars are the diffuse_scalar() of all lights, N·L of the light and
/// the scalar that its highlight depends on besides.
template <class Lighting>
class OneHighlightRun : public SecondDifferenceRun<3> {
 public:
  static constexpr std::size_t kUsed = 3;

  constexpr void set_highlight(const OneHighlight& highlight) { highlight_ = highlight; }

  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb colour(const Lighting& lighting) const {
    const std::uint32_t power = this->power(lighting);
    const PackedRgb diffuse = lighting.diffuse_colour(scalars()[0]);
    return power == 0 ? diffuse : diffuse.plus(lighting.highlight(power));
  }
  /// Returns the parts of colour() (LightRun).
  [[nodiscard]] ARCSPAN_INLINE constexpr PixelLight light(const Lighting& lighting) const {
    const std::uint32_t power = this->power(lighting);
    return {lighting.diffuse_colour(scalars()[0]), power == 0 ? PackedRgb{} : lighting.highlight(power)};
  }

 private:
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t power(const Lighting& lighting) const {
    return lighting.highlight_power(highlight_, scalars()[1], scalars()[2]);
  }

  OneHighlight highlight_;
};

/// Steps a patch of the scalars of a OneHighlightRun (RowWalker).
template <class Lighting, std::size_t Count>
class OneHighlightWalker : public PatchWalker<OneHighlightRun<Lighting>, Count> {
 public:
  using Base = PatchWalker<OneHighlightRun<Lighting>, Count>;
  using typename Base::Run;

  constexpr OneHighlightWalker(Patch<Count>& patch, bool middle_left, const OneHighlight& highlight)
      : Base(patch, middle_left), highlight_{highlight.half_one_plus_light_eye, highlight.weight} {}
  // Member by member, because compilers call memcpy for the whole on small cores.
  ARCSPAN_INLINE constexpr OneHighlightWalker(const OneHighlightWalker& other)
      : Base(other), highlight_{other.highlight_.half_one_plus_light_eye, other.highlight_.weight} {}
  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    Run run = Base::row(start);
    run.set_highlight(highlight_);
    return run;
  }

 private:
  OneHighlight highlight_;
};

/// Makes the patch of the diffuse_scalar() of several lights. Returns false if one of the lights reaches only
/// a part of the triangle.
template <class Lighting, class Frame>
ARCSPAN_OUTLINE_IF_TIGHT constexpr bool make_diffuse_patch(const Lighting& lighting, const Frame& frame,
                                                           const EdgeSagittaFactors& factors,
                                                           PatchScalar& scalar) {
  std::uint32_t lit = 0;
  if (!lit_throughout(lighting, frame, lit)) return false;
  make_patch_scalar(frame, factors, diffuse_scalars(lighting, frame, lit), scalar);
  return true;
}

/// Prepares the patch and the highlight of a OneHighlightWalker for a TriangleFrame. Returns false if several
/// highlights are within reach, or if one of the lights reaches only a part of the triangle.
template <class Lighting, class Frame, std::size_t Count>
[[nodiscard]] constexpr bool prepare_one_highlight(const Lighting& lighting, const Frame& frame,
                                                   Patch<Count>& patch, OneHighlight& highlight) {
  if (!lighting.draws_one_highlight()) return false;
  const auto& top = frame.top->shade.scalars;
  const auto& middle = frame.middle->shade.scalars;
  const auto& bottom = frame.bottom->shade.scalars;
  const Cosine headroom = arc_headroom(frame.chords.widest());
  std::size_t light = Lighting::kLights;
  for (std::size_t i = 0; i < Lighting::kLights; ++i) {
    if (lighting.nearest_highlight_of(i, top, middle, bottom, headroom) >= lighting.power().half_reach())
      continue;
    if (light != Lighting::kLights) return false;
    light = i;
  }
  if (light == Lighting::kLights) return false;
  const EdgeSagittaFactors factors = sagitta_factors_of(frame.chords);
  if (!make_diffuse_patch(lighting, frame, factors, patch[0])) return false;
  highlight = lighting.one_highlight(light);
  std::size_t i = light;
  for (PatchScalar* scalar : {&patch[1], &patch[2]}) {
    make_patch_scalar(frame, factors, {top[i], middle[i], bottom[i]}, *scalar);
    i = Lighting::highlight_index(light);
  }
  return true;
}

}  // namespace arcspan
