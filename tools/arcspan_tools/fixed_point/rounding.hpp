// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace arcspan::tools {

/// The integer nearest to `value`. Halves, and what the last bits of the host's sines and roots may have made
/// of them, go up: the same mesh and camera give the same integers on every host.
[[nodiscard]] inline double rounded(double value) { return std::floor(value + 0.5 + 1e-7); }

/// `value` in the fixed-point format F, rounded; nothing if it is out of the format's range.
template <class F>
[[nodiscard]] std::optional<F> to_fixed_point(double value) {
  using Rep = typename F::Rep;
  const double raw = rounded(std::ldexp(value, F::kFraction));
  if (!(raw >= static_cast<double>(std::numeric_limits<Rep>::min()) &&
        raw <= static_cast<double>(std::numeric_limits<Rep>::max()))) {
    return std::nullopt;
  }
  return F::from_raw(static_cast<Rep>(raw));
}

}  // namespace arcspan::tools
