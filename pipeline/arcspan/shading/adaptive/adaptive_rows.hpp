// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/pixel_light.hpp>
#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/shading/adaptive/highlight_patch.hpp>
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
/// returns that.
template <class Lighting, class Piece, class Run>
[[nodiscard]] ARCSPAN_INLINE constexpr PiecePath start_adaptive(const Lighting& lighting, const Piece& piece,
                                                                Run& run) {
  const PieceSteps steps = piece.steps();
  if (lighting.lights() != 1) {
    piece.start(steps, run);
    return PiecePath::kScalars;
  }
  const auto& ends = piece.ends;
  if (!lighting.may_shine_between(ends.left, ends.right, ends.angle2)) {
    piece.start(steps, run);
    return PiecePath::kDiffuse;
  }
  if (!lighting.start_highlight(ends.left, ends.right, steps, ends.angle2, run)) {
    piece.start(steps, run);
    return PiecePath::kScalars;
  }
  if (piece.skipped != 0) run.skip(piece.skipped);
  return PiecePath::kHighlight;
}

/// The pixels of a piece of a row by any PiecePath (PixelRun, LimitedRun), where the loop of the pixels is
/// the same for all of them. begin() chooses the path.
template <class Lighting, std::size_t Count>
class AdaptiveWideRun : public SecondDifferenceRun<Count> {
 public:
  static constexpr std::size_t kUsed = Count;

  ARCSPAN_INLINE constexpr explicit AdaptiveWideRun(const WidePiece<Count>& piece) : piece_(piece) {}
  ARCSPAN_INLINE constexpr void begin(const Lighting& lighting) {
    for (std::size_t i = 0; i < Count; ++i) this->start_at(i, {});
    path_ = start_adaptive(lighting, piece_, *this);
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
    return this->scalars()[Lighting::highlight_index(0)].raw();
  }

  WidePiece<Count> piece_;
  PiecePath path_ = PiecePath::kScalars;
};

/// Steps a wide triangle of Adaptive (RowWalker), for illuminations that may be by one light.
template <class Lighting, class Pixels, std::size_t Count>
class AdaptiveWideWalker : public WideWalker<Pixels, Count> {
 public:
  using Base = WideWalker<Pixels, Count>;
  using Run = AdaptiveWideRun<Lighting, Count>;
  using Base::Base;

  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    return Run(this->piece_at(start));
  }

  /// Calls `draw` with the run of the row's next piece: that of its PiecePath (ChoosesRuns).
  template <class Draw>
  [[nodiscard]] ARCSPAN_INLINE constexpr Status with_run(const RowStart& start, const Lighting& lighting,
                                                         const Draw& draw) const
      requires(Lighting::kLights == 1 && !kOptimisedForSize) {
    const auto piece = this->piece_at(start);
    const PieceSteps steps = piece.steps();
    const auto& ends = piece.ends;
    if (!lighting.may_shine_between(ends.left, ends.right, ends.angle2)) {
      auto run = Base::template run_of<PieceRun<typename Pixels::Diffuse>>(piece, steps);
      return draw(run);
    }
    PieceRun<HighlightPatchRun<Lighting>> highlight;
    if (lighting.start_highlight(ends.left, ends.right, steps, ends.angle2, highlight)) {
      if (piece.skipped != 0) highlight.skip(piece.skipped);
      highlight.set_length(piece.length);
      return draw(highlight);
    }
    auto run = Base::template run_of<PieceRun<Pixels>>(piece, steps);
    return draw(run);
  }
};

}  // namespace arcspan
