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
  kScalars,    ///< all scalars
  kHighlight,  ///< N·L and the highlight's scaled distance (decision 7)
  kDiffuse,    ///< N·L; no highlight above half the tolerance is within reach
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
  if (!lighting.start_highlight(ends.left, ends.right, 0, lights.lit, steps, ends.angle2, run)) {
    piece.start(steps, run);
    return PiecePath::kScalars;
  }
  return PiecePath::kHighlight;
}

/// The pixels of a piece of a row by any PiecePath (PixelRun, LimitedRun), for methods that wrap the runs of
/// Adaptive (Textured, WithOperation): one loop of pixels serves all paths. begin() chooses the path.
template <class Lighting, std::size_t Count>
class AdaptiveWideRun : public SecondDifferenceRun<Count> {
 public:
  static constexpr std::size_t kUsed = Count;

  ARCSPAN_INLINE constexpr explicit AdaptiveWideRun(const WidePiece<Count>& piece) : piece_(piece) {}
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
  [[nodiscard]] constexpr std::int32_t distance() const { return this->scalars()[1].raw(); }

  WidePiece<Count> piece_;
  PiecePath path_ = PiecePath::kScalars;
};

/// Steps a wide triangle of Adaptive (RowWalker), for illuminations with a ramp.
template <class Lighting, class Pixels, std::size_t Count>
class AdaptiveWideWalker : public WideWalker<Pixels, Count> {
 public:
  using Base = WideWalker<Pixels, Count>;
  using Run = AdaptiveWideRun<Lighting, Count>;
  static constexpr bool kMultiplies = Lighting::kLights == 1 && Lighting::kModel == Highlight::kPhong;

  constexpr AdaptiveWideWalker(typename Base::Prepared& triangle, std::int32_t product_origin)
      : Base(triangle), product_origin_(product_origin) {}

  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    return Run(this->piece_at(start));
  }

  /// Calls `draw` with the run of the row's next piece (ChoosesRuns): the diffuse_scalar() alone if no
  /// highlight above half the tolerance is within reach, with the scaled distance of one highlight (decision
  /// 7), or as Arc draws it.
  template <class Draw>
  [[nodiscard]] ARCSPAN_INLINE constexpr Status with_run(const RowStart& start, const Lighting& lighting,
                                                         const Draw& draw) const {
    const auto piece = this->piece_at(start);
    const PieceSteps steps = piece.steps();
    const auto& ends = piece.ends;
    const PieceLights lights = lights_of_piece(lighting, ends, lighting.half_tolerance_reach());
    if (lights.throughout && lights.shining == 1) {
      if constexpr (kMultiplies) {
        constexpr int kLeastExponent = 18;
        if (steps.exponent >= kLeastExponent && lighting.may_multiply() && is_lit(lighting, ends.left[0]) && is_lit(lighting, ends.right[0])) {
          PieceRun<HighlightProductRun<Lighting>> run;
          start_product(lighting, piece, steps, run);
          return draw(Base::started(piece, run));
        }
      } else {
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
  [[nodiscard]] static constexpr bool is_lit(const Lighting& lighting, Cosine light) {
    return light.raw() >= lighting.fade_end().raw() + (std::int32_t{1} << 20);
  }
  template <class Piece, class ProductRun>
  ARCSPAN_INLINE constexpr void start_product(const Lighting& lighting, const Piece& piece,
                                                     const PieceSteps& steps, ProductRun& run) const {
    const HighlightTable& table = lighting.highlight_table();
    run.set_origin(product_origin_);
    const auto start = [&](std::size_t i, Cosine a, Cosine b) {
      Parabola f = parabola_of(steps, a, b);
      f.x += ProductRun::kHalf;
      run.start_at(i, f);
    };
    start(0, piece.ends.left[0], piece.ends.right[0]);
    start(1, table.scaled_factor(piece.ends.left[1]), table.scaled_factor(piece.ends.right[1]));
  }

  std::int32_t product_origin_;
};

}  // namespace arcspan
