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

namespace detail {

/// Steps the first `Used` of some surfaces.
template <std::size_t Used, class Scalar, std::size_t Count>
ARCSPAN_INLINE constexpr void step_rows(std::array<Scalar, Count>& scalars) {
  unrolled<Used>([&](auto i) { scalars[i].next_row(); });
}
template <std::size_t Used, class Scalar, std::size_t Count>
constexpr void enter_lower_half(std::array<Scalar, Count>& scalars) {
  unrolled<Used>([&](auto i) { scalars[i].enter_lower(); });
}

}  // namespace detail

/// The walker of planes (`RunOf` is a LinearRun) or of quadratic surfaces.
template <class RunOf, class Scalar, std::size_t Count>
class ScalarWalker {
 public:
  using Run = RunOf;

  constexpr ScalarWalker(bool middle_left, std::array<Scalar, Count>& scalars)
      : middle_left_(middle_left), scalars_(&scalars) {}

  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    Run run;
    unrolled<Run::kUsed>([&](auto i) { run.start(i, (*scalars_)[i], start.distance); });
    if (start.skipped != 0) run.skip(start.skipped);
    return run;
  }
  ARCSPAN_INLINE constexpr void next_row() { detail::step_rows<Run::kUsed>(*scalars_); }
  constexpr void enter_lower() {
    if (middle_left_) detail::enter_lower_half<Run::kUsed>(*scalars_);
  }

 private:
  bool middle_left_;
  std::array<Scalar, Count>* scalars_;
};

/// Linear scalars and the missing square of the normal's length.
template <std::size_t Count>
struct NormalisedSurface {
  std::array<PlaneScalar, Count> scalars;
  BentScalar missing;
  int slope_dropped;  ///< of `missing` (SurfaceFormat)
};

/// The walker of a NormalisedSurface.
template <class RunOf, std::size_t Count>
class NormalisedWalker {
 public:
  using Run = RunOf;

  constexpr NormalisedWalker(bool middle_left, NormalisedSurface<Count>& surface)
      : middle_left_(middle_left), surface_(&surface) {}

  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    Run run;
    unrolled<Run::kUsed>([&](auto i) { run.linear.start(i, surface_->scalars[i], start.distance); });
    run.missing.start(0, surface_->missing, start.distance, surface_->slope_dropped);
    if (start.skipped != 0) run.skip(start.skipped);
    return run;
  }
  ARCSPAN_INLINE constexpr void next_row() {
    detail::step_rows<Run::kUsed>(surface_->scalars);
    surface_->missing.next_row();
  }
  constexpr void enter_lower() {
    if (!middle_left_) return;
    detail::enter_lower_half<Run::kUsed>(surface_->scalars);
    surface_->missing.enter_lower();
  }

 private:
  bool middle_left_;
  NormalisedSurface<Count>* surface_;
};

}  // namespace arcspan
