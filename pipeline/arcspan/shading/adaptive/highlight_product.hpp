// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/highlight_table.hpp>
#include <arcspan/lighting/several_lights.hpp>
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/shading/adaptive/highlight_factors.hpp>
#include <arcspan/shading/adaptive/highlight_patch.hpp>
#include <arcspan/shading/arc/row_pieces.hpp>
#include <arcspan/shading/patch/parabola.hpp>
#include <arcspan/shading/patch/patch.hpp>
#include <arcspan/shading/patch/patch_walker.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

/// Highlights R·V of a single light, in patches and in pieces of rows: HighlightFactors are stepped, and each
/// pixel multiplies them.
namespace arcspan {

/// HighlightFactors, stepped by second differences. N·L is the diffuse scalar, too.
class HighlightProduct : public SecondDifferenceRun<2> {
 public:
  static constexpr std::size_t kUsed = 2;
  static constexpr std::size_t kLight = 0;
  static constexpr std::size_t kEye = 1;

  [[nodiscard]] constexpr Cosine diffuse() const { return scalars()[kLight]; }
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t distance() const {
    return HighlightFactors{scalars()[kLight], scalars()[kEye]}.distance_from(origin_);
  }
  /// Sets the product_origin(), which distance() needs.
  constexpr void set_origin(std::int32_t origin) { origin_ = origin; }

 private:
  std::int32_t origin_;
};

template <class Lighting>
using HighlightProductRun = SteppedHighlightRun<Lighting, HighlightProduct, HighlightPixels::kAny>;

/// Steps a patch of a HighlightProduct (RowWalker).
template <class Lighting, std::size_t Count>
class HighlightProductWalker : public PatchWalker<HighlightProductRun<Lighting>, Count> {
 public:
  using Base = PatchWalker<HighlightProductRun<Lighting>, Count>;
  using typename Base::Run;

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

/// Prepares the patch and the product_origin() of a HighlightProductWalker for a TriangleFrame.
template <class Lighting, class Frame, std::size_t Count>
constexpr void prepare_product(const Lighting& lighting, const Frame& frame, Patch<Count>& patch,
                               std::int32_t& origin) {
  const EdgeSagittaFactors factors = sagitta_factors_of(frame.chords);
  make_factor_surface(frame, factors, values_of(frame, 0), patch[HighlightProduct::kLight]);
  make_factor_surface(frame, factors, scaled_eye_of(lighting, frame, 0), patch[HighlightProduct::kEye]);
  origin = product_origin(lighting, 0);
}

/// True if highlights may be drawn by a HighlightProduct. That needs exactly one light, which may be known at
/// run time only.
template <class Lighting>
inline constexpr bool kMayMultiply = kMayHaveOneLight<Lighting>&& kMayReflect<Lighting>;
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
