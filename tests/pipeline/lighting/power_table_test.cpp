// SPDX-License-Identifier: MIT
#include <arcspan/lighting/power_table.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>

using namespace arcspan;
using namespace arcspan::test;

namespace {

/// As the illumination asks: (1 - c) / 2 with 30 fraction bits, nothing beyond the reach.
double looked_up(const PowerTable& table, std::int32_t half_distance) {
  return half_distance < table.half_reach() ? table(half_distance) / 32768.0 : 0;
}

double truth(std::int32_t n, std::int32_t half_distance) {
  return std::pow(std::max(0.0, 1 - std::ldexp(half_distance, -29)), n);
}

double worst_error(std::int32_t n) {
  const PowerTable table(n);
  double worst = 0;
  const auto check = [&](std::int32_t half_distance) {
    worst = std::max(worst, std::abs(looked_up(table, half_distance) - truth(n, half_distance)));
  };
  for (std::int32_t i = 0; i <= 8192; i += stride_of(1)) {
    check(i << 16);                                                                 // the whole range 1 ... 0
    check(static_cast<std::int32_t>(std::int64_t{table.half_reach()} * i / 8192));  // the part in the table
  }
  for (std::int32_t d = -3; d <= 3; ++d) check(std::max(0, table.half_reach() + d));
  return worst;
}

}  // namespace

TEST_CASE("the power table is within 2^-10 of the power for every exponent") {
  double worst = 0;
  for (std::int32_t n = 1; n <= 256; ++n) {
    const double error = worst_error(n);
    INFO("n = " << n);
    CHECK(error <= 0x1p-10);
    worst = std::max(worst, error);
  }
  CHECK(worst > 0x1p-11);
}

TEST_CASE("inside its reach the power table is within 6.9e-4") {
  for (std::int32_t n = 1; n <= 256; ++n) {
    const PowerTable table(n);
    double worst = 0;
    for (std::int32_t i = 0; i <= 8192; i += stride_of(1)) {
      const auto d = static_cast<std::int32_t>(std::int64_t{table.half_reach() - 1} * i / 8192);
      worst = std::max(worst, std::abs(looked_up(table, d) - truth(n, d)));
    }
    INFO("n = " << n);
    CHECK(worst <= 6.9e-4);
    if (n <= 16) CHECK(worst <= 0x1p-11);
  }
}

TEST_CASE("the power falls monotonously from 1, also for cosines that rounding has lifted above 1") {
  for (const std::int32_t n : {1, 2, 3, 16, 64, 255, 256}) {
    const PowerTable table(n);
    CHECK(table(0) == 32768);
    CHECK(table(-1) == 32768);
    CHECK(table(-(1 << 29)) == 32768);
    std::uint32_t last = 32768;
    int rises = 0;
    for (std::int32_t i = 0; i < 20000; ++i) {
      const std::uint32_t here =
          table(static_cast<std::int32_t>(std::int64_t{table.half_reach() - 1} * i / 20000));
      rises += here > last ? 1 : 0;
      last = here;
    }
    CHECK(rises == 0);
  }
}

TEST_CASE("exponents out of range are clamped") {
  for (const std::int32_t d : {0, 1000, 100000, 1 << 24}) {
    CHECK(looked_up(PowerTable(0), d) == looked_up(PowerTable(1), d));
    CHECK(looked_up(PowerTable(-5), d) == looked_up(PowerTable(1), d));
    CHECK(looked_up(PowerTable(1000), d) == looked_up(PowerTable(256), d));
  }
}
