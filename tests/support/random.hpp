// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

namespace arcspan::test {

/// SplitMix64 (Steele, Lea, Flood 2014): the same numbers on every host, which <random> does not promise.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  [[nodiscard]] std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  /// Uniform in [0, 1).
  [[nodiscard]] double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  [[nodiscard]] double real(double from, double to) { return from + (to - from) * unit(); }
  /// Uniform in its logarithm, for sizes that span decades.
  [[nodiscard]] double decades(double from, double to) {
    return from * std::exp(unit() * std::log(to / from));
  }
  /// Uniform in from ... to, both included.
  [[nodiscard]] std::int32_t integer(std::int32_t from, std::int32_t to) {
    const auto count = static_cast<std::uint64_t>(std::int64_t{to} - from + 1);
    return static_cast<std::int32_t>(from + static_cast<std::int64_t>(bits() % count));
  }
  [[nodiscard]] bool chance(double probability) { return unit() < probability; }

 private:
  std::uint64_t state_;
};

}  // namespace arcspan::test
