// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/row_start.hpp>
#include <arcspan/shading/patch/patch_walker.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// Returns the run of pixels that no light reaches: N·L = 0.
template <class Lighting>
[[nodiscard]] ARCSPAN_INLINE constexpr PatchRun<Lighting, 1> dark_run() {
  PatchRun<Lighting, 1> run;
  run.start_at(0, {});
  return run;
}

/// Steps over the rows of a triangle that no light reaches (RowWalker).
template <class Lighting>
class DarkWalker {
 public:
  using Run = PatchRun<Lighting, 1>;

  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart&) const { return dark_run<Lighting>(); }
  constexpr void next_row() {}
  constexpr void enter_lower() {}
};

}  // namespace arcspan
