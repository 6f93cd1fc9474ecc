// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/unroll.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/shading/surface/run.hpp>
#include <arcspan/shading/surface/surface.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>

/// Steps the scalars of a triangle from row to row (RowWalker). Walkers change the prepared surface in place.
namespace arcspan {

/// Linear scalars and the missing square of the normal's length.
template <std::size_t Count>
struct NormalisedSurface {
  std::array<PlaneScalar, Count> scalars;
  BentScalar missing;
  int slope_dropped;  ///< of `missing` (SurfaceFormat)
};

/// The walker of an array of planes (`RunOf` is a LinearRun), one of quadratic surfaces (QuadraticRun), or a
/// NormalisedSurface (NormalisedRun).
template <class RunOf, class Surface>
class SurfaceWalker {
 public:
  using Run = RunOf;

  constexpr SurfaceWalker(bool middle_left, Surface& surface)
      : middle_left_(middle_left), surface_(&surface) {}

  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    Run run;
    if constexpr (kIsNormalised) {
      unrolled<Run::kUsed>([&](auto i) { run.linear.start(i, surface_->scalars[i], start.distance); });
      run.missing.start(0, surface_->missing, start.distance, surface_->slope_dropped);
    } else {
      unrolled<Run::kUsed>([&](auto i) { run.start(i, (*surface_)[i], start.distance); });
    }
    if (start.skipped != 0) run.skip(start.skipped);
    return run;
  }
  ARCSPAN_INLINE constexpr void next_row() {
    for_scalars([](auto& scalar) { scalar.next_row(); });
  }
  constexpr void enter_lower() {
    if (middle_left_) for_scalars([](auto& scalar) { scalar.enter_lower(); });
  }

 private:
  static constexpr bool kIsNormalised = requires(Surface & surface) { surface.missing; };

  /// Calls change(scalar) for all that the run uses.
  template <class Change>
  ARCSPAN_INLINE constexpr void for_scalars(const Change& change) {
    if constexpr (kIsNormalised) {
      unrolled<Run::kUsed>([&](auto i) { change(surface_->scalars[i]); });
      change(surface_->missing);
    } else {
      unrolled<Run::kUsed>([&](auto i) { change((*surface_)[i]); });
    }
  }

  bool middle_left_;
  Surface* surface_;
};

}  // namespace arcspan
