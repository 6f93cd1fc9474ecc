// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/adaptive/highlight_patch.hpp>
#include <arcspan/shading/arc/wide_walker.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// Steps a wide triangle of Adaptive (RowWalker), for illuminations with a ramp.
template <class Lighting, class Pixels, std::size_t Count>
class AdaptiveWideWalker : public WideWalker<Pixels, Count> {
 public:
  using Base = WideWalker<Pixels, Count>;
  using Base::Base;

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
      PieceRun<HighlightPatchRun<Lighting>> run;
      if (lighting.start_highlight(ends.left, ends.right, lights.highlight, lights.lit, steps, ends.angle2,
                                   run)) {
        run.set_weight(lighting.highlight_weight(lights.highlight));
        return draw(Base::started(piece, run));
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
};

}  // namespace arcspan
