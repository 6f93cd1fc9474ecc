// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/sink.hpp>
#include <arcspan/prepare/linear.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/span/draw_pieces.hpp>
#include <arcspan/span/draw_pixels.hpp>
#include <arcspan/span/indexed_run.hpp>
#include <arcspan/span/row_memory.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

namespace arcspan::detail {

/// Draws the pixels of a span by a run that starts at its first pixel. A function object and no lambda, which
/// compilers would call.
template <class Command, class Target>
struct RunDrawer {
  const Command& command;
  const RowStart& start;
  Span& span;  ///< becomes shorter if the run is (LimitedRun)
  const Target& target;
  const RowMemory<Target>& memory;

  template <class Run>
  [[nodiscard]] ARCSPAN_INLINE constexpr Status operator()(Run& run) const {
    using Lighting = typename Target::Lighting;
    if constexpr (BeginsWithLighting<Run, Lighting>) run.begin(target.lighting);
    if constexpr (LimitedRun<Run>) {
      if (span.count > run.length()) span.count = run.length();
    }
    if constexpr (IndexedRows<Target> && !SegmentedRun<Run> && !PiecewiseRun<Run, Lighting>) {
      if constexpr (kHasWideRegisters) {
        Linear z{};
        if constexpr (!CarriesDepth<Run>) z = linear_at(command.depth, start);
        auto [place, first] = indexed_run(memory, span, z);
        draw_pixels(place, span, run, target, command.depth.dx, first);
      } else {
        // As indexed_run() does, by which gcc would allocate a Cortex-M3's registers differently.
        PixelPlace<Target> place{memory.pixels.behind(span), memory.depths.behind(span),
                                 linear_at(command.depth, start)};
        draw_pixels(place, span, run, target, command.depth.dx, first_index(span));
      }
    } else {
      PixelPlace<Target> place{memory.pixels.open(span), memory.depths.at(span),
                               linear_at(command.depth, start)};
      if constexpr (SegmentedRun<Run>) {
        draw_segments(place, span, run, target, command.depth.dx);
      } else if constexpr (PiecewiseRun<Run, Lighting>) {
        draw_pieces(place, span, run, target, command.depth.dx);
      } else {
        draw_pixels(place, span, run, target, command.depth.dx, first_index(span));
      }
    }
    return target.sink.close(span);
  }
};

}  // namespace arcspan::detail
