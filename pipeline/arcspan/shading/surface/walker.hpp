// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/numbers/unroll.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/shading/surface/run.hpp>
#include <arcspan/shading/surface/surface.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

/// Steps the scalars of a triangle from row to row (RowWalker). Walkers change the prepared surface in place.
namespace arcspan {

/// Where the rows of a triangle start. Set for all triangles.
struct SurfaceRows {
  bool middle_left;    ///< the middle vertex is on the left of the long edge
  bool is_sliver;      ///< narrower than a pixel
  Reciprocal inverse;  ///< of the width, 16 fraction bits; used for slivers

  /// Returns the distance from the left edge to the row's first column in the unit of the slopes: pixels, or
  /// the width of a sliver. 16 fraction bits, below 1.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t fraction(const RowStart& start) const {
    if (is_sliver) [[unlikely]]
      return sliver_fraction(start.fine);
    return start.fraction;
  }

 private:
  /// `fine`: the distance in pixels, 32 fraction bits.
  [[nodiscard]] ARCSPAN_OUTLINE ARCSPAN_COLD constexpr std::uint32_t sliver_fraction(
      std::uint32_t fine) const {
    // The fraction of a pixel with 32 bits times `mantissa` 2^-exponent; the width has exponent - 15 bits.
    const std::uint32_t upper = fine >> (inverse.exponent - 15);
    if (upper > 0xFFFFu) return 0xFFFFu;
    const std::uint32_t fraction = (upper * (inverse.mantissa >> 1)) >> 14;
    return fraction < 0xFFFFu ? fraction : 0xFFFFu;
  }
};

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

  constexpr ScalarWalker(const SurfaceRows& rows, std::array<Scalar, Count>& scalars)
      : rows_(&rows), scalars_(&scalars) {}

  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    const std::uint32_t p = rows_->fraction(start);
    Run run;
    unrolled<Run::kUsed>([&](auto i) { run.start(i, (*scalars_)[i], p); });
    if (start.skipped != 0) run.skip(start.skipped);
    return run;
  }
  ARCSPAN_INLINE constexpr void next_row() { detail::step_rows<Run::kUsed>(*scalars_); }
  constexpr void enter_lower() {
    if (rows_->middle_left) detail::enter_lower_half<Run::kUsed>(*scalars_);
  }

 private:
  const SurfaceRows* rows_;
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

  constexpr NormalisedWalker(const SurfaceRows& rows, NormalisedSurface<Count>& surface)
      : rows_(&rows), surface_(&surface) {}

  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    const std::uint32_t p = rows_->fraction(start);
    Run run;
    unrolled<Run::kUsed>([&](auto i) { run.linear.start(i, surface_->scalars[i], p); });
    run.missing.start(0, surface_->missing, p, surface_->slope_dropped);
    if (start.skipped != 0) run.skip(start.skipped);
    return run;
  }
  ARCSPAN_INLINE constexpr void next_row() {
    detail::step_rows<Run::kUsed>(surface_->scalars);
    surface_->missing.next_row();
  }
  constexpr void enter_lower() {
    if (!rows_->middle_left) return;
    detail::enter_lower_half<Run::kUsed>(surface_->scalars);
    surface_->missing.enter_lower();
  }

 private:
  const SurfaceRows* rows_;
  NormalisedSurface<Count>* surface_;
};

}  // namespace arcspan
