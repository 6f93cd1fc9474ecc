// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace arcspan::test {

/// Largest and mean square error over many pixels.
struct ErrorFigure {
  double max = 0;
  double sum_of_squares = 0;
  std::uint64_t count = 0;

  void add(double error) {
    max = std::max(max, std::abs(error));
    sum_of_squares += error * error;
    ++count;
  }
  [[nodiscard]] double rms() const {
    return count == 0 ? 0 : std::sqrt(sum_of_squares / static_cast<double>(count));
  }
};

}  // namespace arcspan::test
