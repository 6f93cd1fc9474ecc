// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/highlight_table.hpp>
#include <arcspan/lighting/illumination_features.hpp>
#include <arcspan/lighting/several_lights.hpp>
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/shading/adaptive/highlight_patch.hpp>
#include <arcspan/shading/arc/row_pieces.hpp>
#include <arcspan/shading/patch/parabola.hpp>
#include <arcspan/shading/patch/patch.hpp>
#include <arcspan/shading/patch/patch_walker.hpp>
#include <arcspan/shading/patch/raise_patch.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

/// Highlights R·V of one light where normals are too far apart to step the half distance itself. N·L and N·V
/// are stepped instead, and a pixel computes the half distance (1 + L·V) / 2 - (N·L)(N·V) from them, in the
/// scale of HighlightTable (decision 7). For patches, and with one light for pieces of rows.
namespace arcspan {

/// True if the highlight of `Lighting` may be R·V. Some illuminations know that at run time only.
template <class Lighting>
inline constexpr bool kMayReflect = !requires {
  requires(Lighting::kModel == Highlight::kBlinn);
};

/// The factors of the half distance at a pixel: N·L, and N·V in the scale of distances. Both are raised by
/// kHalf, so that a shift rounds them to nearest.
struct HighlightFactors {
  static constexpr Cosine kHalf = Cosine::from_raw(1 << 14);

  Cosine light;
  Cosine eye;

  /// Returns the scaled distance; `origin` is product_origin().
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t distance_from(std::int32_t origin) const {
    return wrap_sub(origin, wrap_mul(light.raw() >> 15, eye.raw() >> 15));
  }
};

/// Returns (1 + L·V) / 2 of a light with the highlight R·V as a scaled distance.
template <class Lighting>
[[nodiscard]] constexpr std::int32_t product_origin(const Lighting& lighting, std::size_t light) {
  const Cosine half_one_plus_light_eye = Cosine::from_raw(lighting.half_distance({}, {}, light));
  return lighting.highlight_table().scaled_factor(half_one_plus_light_eye).raw();
}

/// The diffuse_scalar() and HighlightFactors, stepped by second differences. With one light N·L is both the
/// diffuse scalar and a factor.
template <std::size_t Scalars>
class HighlightProduct : public SecondDifferenceRun<Scalars> {
 public:
  static constexpr std::size_t kUsed = Scalars;
  static constexpr std::size_t kLight = Scalars - 2;
  static constexpr std::size_t kEye = Scalars - 1;

  [[nodiscard]] constexpr Cosine diffuse() const { return this->scalars()[0]; }
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t distance() const {
    return HighlightFactors{this->scalars()[kLight], this->scalars()[kEye]}.distance_from(origin_);
  }
  /// Sets the product_origin(), which distance() needs.
  constexpr void set_origin(std::int32_t origin) { origin_ = origin; }

 private:
  std::int32_t origin_;
};

template <class Lighting>
using HighlightProductRun =
    SteppedHighlightRun<Lighting, HighlightProduct<(Lighting::kLights == 1 ? 2 : 3)>, HighlightPixels::kAny>;

/// Steps a patch of a HighlightProduct (RowWalker).
template <class Lighting, std::size_t Count>
class HighlightProductWalker : public PatchWalker<HighlightProductRun<Lighting>, Count> {
 public:
  using Base = PatchWalker<HighlightProductRun<Lighting>, Count>;
  using typename Base::Run;
  /// Inlining the loop over the rows costs x86-64 0.5 % of the benchmark frame; a function of its own costs
  /// other targets 1 % of the random scenes.
  static constexpr bool kOutlinesRowLoop = kHasWideRegisters;

  constexpr HighlightProductWalker(Patch<Count>& patch, bool middle_left, std::int32_t origin,
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

/// Makes the patch of HighlightFactors of a light over a TriangleFrame.
template <class Lighting, class Frame>
constexpr void make_factor_surfaces(const Lighting& lighting, const Frame& frame, std::size_t light,
                                    const EdgeSagittaFactors& factors, PatchScalar& of_light,
                                    PatchScalar& of_eye) {
  const std::size_t other = Lighting::highlight_index(light);
  const auto& top = frame.top->shade.scalars;
  const auto& middle = frame.middle->shade.scalars;
  const auto& bottom = frame.bottom->shade.scalars;
  const auto eye = [&](const auto& scalars) {
    return lighting.highlight_table().scaled_factor(scalars[other]);
  };
  make_patch_scalar(frame, factors, {top[light], middle[light], bottom[light]}, of_light);
  make_patch_scalar(frame, factors, {eye(top), eye(middle), eye(bottom)}, of_eye);
  raise_patch_scalar(frame, HighlightFactors::kHalf, of_light);
  raise_patch_scalar(frame, HighlightFactors::kHalf, of_eye);
}

/// True if pieces of rows may be drawn by a HighlightProduct. That needs exactly one light, which may be
/// known at run time only: with several lights a third scalar costs more than the product saves.
template <class Lighting>
inline constexpr bool kMayMultiplyPieces = kMayHaveOneLight<Lighting>&& kMayReflect<Lighting>;
/// True if pieces of rows never have a parabola of the distance: they have HighlightFactors, or all scalars
/// where start_factors() returns false.
template <class Lighting>
inline constexpr bool kAlwaysMultipliesPieces = Lighting::kLights == 1 && kMayReflect<Lighting>;

/// Starts the HighlightFactors of the only light over a piece of a row as the scalars `of_light` and `of_eye`
/// of `run`. Returns false unless multiplies_highlights(), if an end of the piece is not fully lit, or if the
/// piece is so short that stepping all its scalars costs less.
template <class Lighting, class Ends, class Run>
[[nodiscard]] ARCSPAN_INLINE constexpr bool start_factors(const Lighting& lighting, const Ends& ends,
                                                          const PieceSteps& steps, Run& run,
                                                          std::size_t of_light, std::size_t of_eye) {
  if (!lighting.multiplies_highlights() || steps.exponent < Lighting::kLeastPieceExponent ||
      !lighting.is_fully_lit(ends.left[0]) || !lighting.is_fully_lit(ends.right[0]))
    return false;
  const auto start = [&](std::size_t i, Cosine left, Cosine right) {
    Parabola f = parabola_of(steps, left, right);
    f.x += HighlightFactors::kHalf;
    run.start_at(i, f);
  };
  const std::size_t other = Lighting::highlight_index(0);
  const HighlightTable& table = lighting.highlight_table();
  start(of_light, ends.left[0], ends.right[0]);
  start(of_eye, table.scaled_factor(ends.left[other]), table.scaled_factor(ends.right[other]));
  return true;
}

}  // namespace arcspan
