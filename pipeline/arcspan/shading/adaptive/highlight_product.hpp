// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/highlight_table.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/shading/adaptive/highlight_patch.hpp>
#include <arcspan/shading/patch/patch.hpp>
#include <arcspan/shading/patch/patch_walker.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

/// Patches with the highlight R·V of one light, whose half distance (1 + L·V) / 2 - (N·L)(N·V) a pixel
/// computes in the scale of HighlightTable: N·V carries the scale. This is for triangles that are too wide
/// for a surface of the distance (decision 7).
namespace arcspan {

/// The diffuse_scalar(), N·L of the light and the scaled N·V. With one light the first two are one.
template <std::size_t Scalars>
class HighlightProduct : public SecondDifferenceRun<Scalars> {
 public:
  static constexpr std::size_t kUsed = Scalars;
  /// Added to both factors, so that a shift rounds them to nearest.
  static constexpr Cosine kHalf = Cosine::from_raw(1 << 14);

  [[nodiscard]] constexpr Cosine diffuse() const { return this->scalars()[0]; }
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t distance() const {
    const Cosine light = this->scalars()[Scalars - 2];
    const Cosine eye = this->scalars()[Scalars - 1];
    return wrap_sub(origin_, wrap_mul(light.raw() >> 15, eye.raw() >> 15));
  }
  /// Sets (1 + L·V) / 2 as a scaled distance.
  constexpr void set_origin(std::int32_t origin) { origin_ = origin; }

 private:
  std::int32_t origin_;
};

template <class Lighting>
using HighlightProductRun =
    SteppedHighlightRun<Lighting, HighlightProduct<Lighting::kScalars>, HighlightPixels::kAny>;

/// Steps a patch of a HighlightProduct (RowWalker).
template <class Lighting>
class HighlightProductWalker : public PatchWalker<HighlightProductRun<Lighting>, Lighting::kScalars> {
 public:
  using Base = PatchWalker<HighlightProductRun<Lighting>, Lighting::kScalars>;
  using typename Base::Run;

  constexpr HighlightProductWalker(Patch<Lighting::kScalars>& patch, bool middle_left, std::int32_t origin,
                                   std::uint32_t weight)
      : Base(patch, middle_left), origin_(origin), weight_(weight) {}
  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    Run run = Base::row(start);
    run.set_origin(origin_);
    run.set_weight(weight_);
    return run;
  }

 private:
  std::int32_t origin_;
  std::uint32_t weight_;
};

/// Makes the factors of a HighlightProduct, the last two scalars of the patch, for the highlight of `light`
/// over a TriangleFrame. With one light the first of them is the diffuse scalar.
template <class Lighting, class Frame, std::size_t Count>
constexpr void make_highlight_product(const Lighting& lighting, const Frame& frame, std::size_t light,
                                      Patch<Count>& patch) {
  const HighlightTable& table = lighting.highlight_table();
  const std::size_t other = Lighting::highlight_index(light);
  const EdgeSagittaFactors factors = sagitta_factors_of(frame.chords);
  const auto& top = frame.top->shade.scalars;
  const auto& middle = frame.middle->shade.scalars;
  const auto& bottom = frame.bottom->shade.scalars;
  const auto eye = [&](const auto& scalars) { return table.scaled_factor(scalars[other]); };
  make_patch_scalar(frame, factors, {top[light], middle[light], bottom[light]}, patch[Count - 2]);
  make_patch_scalar(frame, factors, {eye(top), eye(middle), eye(bottom)}, patch[Count - 1]);
  constexpr Cosine kHalf = HighlightProduct<Count>::kHalf;
  for (PatchScalar* scalar : {&patch[Count - 2], &patch[Count - 1]}) {
    if (!frame.middle_left || frame.has_upper) scalar->left.at += kHalf;
    if (frame.middle_left && frame.has_lower) scalar->lower.at += kHalf;
  }
}

}  // namespace arcspan
