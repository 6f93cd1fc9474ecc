// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/pixel_light.hpp>
#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/shading/adaptive/highlight_patch.hpp>
#include <arcspan/shading/adaptive/highlight_product.hpp>
#include <arcspan/shading/arc/wide_walker.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// Which values are stepped from pixel to pixel in a piece of a row of a wide triangle.
enum class PiecePath : std::uint8_t {
  kScalars,   ///< all scalars
  kDistance,  ///< N·L and the highlight's scaled distance (decision 7)
  kProduct,   ///< HighlightFactors
  kDiffuse,   ///< N·L; no highlight above half the tolerance is within reach
};

/// Starts `run`, which has all scalars, by the path that `lighting` (AdaptiveIllumination) allows, and
/// returns that. Only one light has paths.
template <class Lighting, class Piece, class Run>
[[nodiscard]] ARCSPAN_INLINE constexpr PiecePath start_adaptive(const Lighting& lighting, const Piece& piece,
                                                                Run& run) {
  const PieceSteps steps = piece.steps();
  if (lighting.lights() != 1) {
    piece.start(steps, run);
    return PiecePath::kScalars;
  }
  const auto& ends = piece.ends;
  const PieceLights lights = lights_of_piece(lighting, ends, lighting.half_tolerance_reach());
  if (lights.shining == 0) {
    piece.start(steps, run);
    return PiecePath::kDiffuse;
  }
  if constexpr (kMayMultiply<Lighting>) {
    if (start_factors(lighting, ends, steps, run, 0, 1)) return PiecePath::kProduct;
  }
  if constexpr (!kAlwaysMultipliesPieces<Lighting>) {
    if (lighting.start_highlight(ends.left, ends.right, 0, lights.lit, steps, ends.angle2, run))
      return PiecePath::kDistance;
  }
  piece.start(steps, run);
  return PiecePath::kScalars;
}

/// The pixels of a piece of a row by any PiecePath (PiecewiseRun). enter() chooses the path.
template <class Lighting, std::size_t Count, class Walker>
class AdaptiveWideRun : public SecondDifferenceRun<Count> {
 public:
  static constexpr std::size_t kUsed = Count;

  /// `product_origin` is that of the only light.
  ARCSPAN_INLINE constexpr AdaptiveWideRun(const Walker& walker, const RowStart& start,
                                           std::int32_t product_origin)
      : walker_(&walker), next_(start), product_origin_(product_origin) {}
  [[nodiscard]] constexpr std::int32_t enter(const Lighting& lighting, std::int32_t left) {
    const auto piece = walker_->piece_at(next_);
    for (std::size_t i = 0; i < Count; ++i) this->start_at(i, {});
    path_ = start_adaptive(lighting, piece, *this);
    if (piece.skipped != 0) this->skip(piece.skipped);
    const std::int32_t count = left < piece.length ? left : piece.length;
    next_ = next_.moved(count);
    return count;
  }

  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb colour(const Lighting& lighting) const {
    if (path_ == PiecePath::kScalars) return lighting.colour(this->scalars());
    if (path_ == PiecePath::kDiffuse) return lighting.diffuse_colour(this->scalars()[0]);
    return lighting.colour_with_highlight_at(this->scalars()[0], distance(), kWeight);
  }
  /// Returns the parts of colour() (LightRun).
  [[nodiscard]] ARCSPAN_INLINE constexpr PixelLight light(const Lighting& lighting) const {
    if (path_ == PiecePath::kScalars) return lighting.light(this->scalars());
    if (path_ == PiecePath::kDiffuse) return {lighting.diffuse_colour(this->scalars()[0]), {}};
    return lighting.light_with_highlight_at(this->scalars()[0], distance(), kWeight);
  }

 private:
  static constexpr std::uint32_t kWeight = std::uint32_t{1} << 15;
  [[nodiscard]] constexpr std::int32_t distance() const {
    if (path_ == PiecePath::kDistance) return this->scalars()[1].raw();
    return HighlightFactors{this->scalars()[0], this->scalars()[1]}.distance_from(product_origin_);
  }

  const Walker* walker_;
  RowStart next_;  ///< of the next piece
  std::int32_t product_origin_;
  PiecePath path_ = PiecePath::kScalars;
};

/// Steps a wide triangle of Adaptive (RowWalker), for illuminations with a ramp.
template <class Lighting, class Pixels, std::size_t Count>
class AdaptiveWideWalker : public WideWalker<Pixels, Count> {
 public:
  using Base = WideWalker<Pixels, Count>;
  using Run = AdaptiveWideRun<Lighting, Count, Base>;

  /// `product_origin` is that of the only light.
  constexpr AdaptiveWideWalker(typename Base::Prepared& triangle, std::int32_t product_origin)
      : Base(triangle), product_origin_(product_origin) {}

  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    return Run(*this, start, product_origin_);
  }

 private:
  std::int32_t product_origin_;
};

}  // namespace arcspan
