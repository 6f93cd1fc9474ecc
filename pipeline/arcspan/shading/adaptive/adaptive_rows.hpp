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

/// The pixels of a piece of a row by any PiecePath (PixelRun, LimitedRun), for methods that wrap the runs of
/// Adaptive (Textured, WithOperation): one loop of pixels serves all paths. begin() chooses the path.
template <class Lighting, std::size_t Count>
class AdaptiveWideRun : public SecondDifferenceRun<Count> {
 public:
  static constexpr std::size_t kUsed = Count;

  /// `product_origin` is that of the only light.
  ARCSPAN_INLINE constexpr AdaptiveWideRun(const WidePiece<Count>& piece, std::int32_t product_origin)
      : piece_(piece), product_origin_(product_origin) {}
  ARCSPAN_INLINE constexpr void begin(const Lighting& lighting) {
    for (std::size_t i = 0; i < Count; ++i) this->start_at(i, {});
    path_ = start_adaptive(lighting, piece_, *this);
    if (piece_.skipped != 0) this->skip(piece_.skipped);
  }
  [[nodiscard]] constexpr std::int32_t length() const { return piece_.length; }

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
  /// Returns colour() encoded in `Format` (EncodingRun).
  template <class Format, class Colours>
  [[nodiscard]] ARCSPAN_INLINE constexpr typename Format::Encoded encoded(const Lighting& lighting,
                                                                          const Colours& encoded) const {
    if (path_ == PiecePath::kDiffuse) return encoded[this->scalars()[0]];
    return encode_varying<Format>(colour(lighting));
  }

 private:
  static constexpr std::uint32_t kWeight = std::uint32_t{1} << 15;
  [[nodiscard]] constexpr std::int32_t distance() const {
    if (path_ == PiecePath::kDistance) return this->scalars()[1].raw();
    return HighlightFactors{this->scalars()[0], this->scalars()[1]}.distance_from(product_origin_);
  }

  WidePiece<Count> piece_;
  std::int32_t product_origin_;
  PiecePath path_ = PiecePath::kScalars;
};

/// Steps a wide triangle of Adaptive (RowWalker), for illuminations with a ramp.
template <class Lighting, class Pixels, std::size_t Count>
class AdaptiveWideWalker : public WideWalker<Pixels, Count> {
 public:
  using Base = WideWalker<Pixels, Count>;
  using Run = AdaptiveWideRun<Lighting, Count>;

  /// `product_origin` is that of the only light.
  constexpr AdaptiveWideWalker(typename Base::Prepared& triangle, std::int32_t product_origin)
      : Base(triangle), product_origin_(product_origin) {}

  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    return Run(this->piece_at(start), product_origin_);
  }

  /// Calls `draw` with the run of the row's next piece (ChoosesRuns): the diffuse_scalar() alone if no
  /// highlight above half the tolerance is within reach, with one highlight of which it has the factors or
  /// the scaled distance (decision 7), or as Arc draws it.
  template <class Draw>
  [[nodiscard]] ARCSPAN_INLINE constexpr Status with_run(const RowStart& start, const Lighting& lighting,
                                                         const Draw& draw) const {
    const auto piece = this->piece_at(start);
    const PieceSteps steps = piece.steps();
    const auto& ends = piece.ends;
    const PieceLights lights = lights_of_piece(lighting, ends, lighting.half_tolerance_reach());
    if (lights.throughout && lights.shining == 1) {
      if constexpr (kMayMultiply<Lighting>) {
        PieceRun<HighlightProductRun<Lighting>> run;
        if (lighting.lights() == 1 && start_product(lighting, ends, steps, run))
          return draw(Base::started(piece, run));
      }
      if constexpr (!kAlwaysMultipliesPieces<Lighting>) {
        PieceRun<HighlightPatchRun<Lighting>> run;
        if (lighting.start_highlight(ends.left, ends.right, lights.highlight, lights.lit, steps, ends.angle2,
                                     run)) {
          run.set_weight(lighting.highlight_weight(lights.highlight));
          return draw(Base::started(piece, run));
        }
      }
    }
    if constexpr (Lighting::kLights > 1) {
      return Base::draw_by_lights(piece, steps, lights, lighting, draw);
    } else {
      if (lights.shining == 0) {
        PieceRun<typename Pixels::Diffuse> run;
        piece.start_diffuse(steps, lighting, lights.lit, run);
        return draw(Base::started(piece, run));
      }
      auto run = Base::template run_of<PieceRun<Pixels>>(piece, steps);
      return draw(run);
    }
  }

 private:
  /// Starts `run` by the only light. Returns false as start_factors() does.
  template <class Ends, class ProductRun>
  [[nodiscard]] ARCSPAN_INLINE constexpr bool start_product(const Lighting& lighting, const Ends& ends,
                                                            const PieceSteps& steps, ProductRun& run) const {
    if (!start_factors(lighting, ends, steps, run, ProductRun::kLight, ProductRun::kEye)) return false;
    run.set_origin(product_origin_);
    run.set_weight(lighting.highlight_weight(0));
    return true;
  }

  std::int32_t product_origin_;
};

}  // namespace arcspan
