// SPDX-License-Identifier: MIT
#include <arcspan/lighting/highlight_table.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Coefficients = std::array<std::uint32_t, 3>;  ///< 8-bit steps, 5 fraction bits

constexpr Coefficients kWhite{255 << 5, 255 << 5, 255 << 5};

/// A channel of a colour, which has 2 fraction bits.
double channel(PackedRgb colour, std::size_t c) {
  constexpr std::array<int, 3> kAt{11, 22, 0};
  return ((colour.lanes >> kAt[c]) & 1023u) / 4.0;
}

/// The closeness of a half distance, as a Blinn pixel has it: origin + scaled(N·H) / 2 at N·H = 1 - 2 h.
std::int32_t closeness(const HighlightTable& table, std::int32_t half_distance) {
  return table.reach() - table.scaled(Cosine::from_raw(half_distance)).raw();
}

PackedRgb highlight(const HighlightTable& table, std::int32_t at) {
  return table.colour(table.value(at) >> 16);
}

/// How far a channel is above and below specular * c^n at most, in 8-bit steps.
struct Error {
  double above = 0;
  double below = 0;
};
Error worst_error(std::int32_t n, const Coefficients& specular) {
  const PowerTable power(n);
  const HighlightTable table(power, specular);
  Error worst;
  for (std::int32_t i = 0; i <= 4096; i += stride_of(1)) {
    const auto half = static_cast<std::int32_t>(std::int64_t{power.half_reach() - 1} * i / 4096);
    const std::int32_t at = closeness(table, half);
    if (at <= 0) continue;
    const double cosine = std::max(0.0, 1 - 2 * std::ldexp(half, -30));
    for (std::size_t c = 0; c < 3; ++c) {
      const double error = channel(highlight(table, at), c) - specular[c] / 32.0 * std::pow(cosine, n);
      worst.above = std::max(worst.above, error);
      worst.below = std::max(worst.below, -error);
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("a highlight table is the power times the coefficient, cut to a quarter of an 8-bit step") {
  Random random(1);
  for (std::int32_t n = 1; n <= 256; ++n) {
    const auto share = [&random] { return static_cast<std::uint32_t>(random.integer(0, 255 << 5)); };
    const Coefficients coloured{share(), share(), share()};
    for (const Coefficients& specular : {kWhite, coloured}) {
      const Error error = worst_error(n, specular);
      INFO("n = " << n);
      // The power table, and lines between 128 values, of which larger exponents use half.
      CHECK(error.above < (n <= 104 ? 0.25 : 0.55));
      CHECK(error.below < 0.25 + 0.25);
    }
  }
}

TEST_CASE("the reach of a highlight table is at most 2^25, of which large exponents use less") {
  for (std::int32_t n = 1; n <= 256; ++n) {
    const PowerTable power(n);
    const HighlightTable table(power, kWhite);
    CAPTURE(n);
    CHECK(table.reach() <= 1 << HighlightTable::kReachBits);
    CHECK(table.reach() > (n <= 104 ? (1 << 25) - 64 : 1 << 23));
    CHECK(closeness(table, power.half_reach()) == 0);
    CHECK(closeness(table, 0) == table.reach());
  }
}

TEST_CASE("scaling keeps the sign and the proportions of a scalar") {
  const HighlightTable table(PowerTable(16), kWhite);
  const double factor = std::ldexp(table.reach(), -30) / std::ldexp(PowerTable(16).half_reach(), -30);
  for (const double value : {-1.0, -0.3, 0.0, 0.1, 0.999}) {
    const auto scalar = Cosine::from_raw(static_cast<std::int32_t>(std::lround(std::ldexp(value, 30))));
    CHECK(std::ldexp(table.scaled(scalar).raw(), -30) == Approx(value * factor).margin(1e-8));
  }
}

TEST_CASE("beyond its reach a highlight is as at its peak, and black without coefficients") {
  for (const std::int32_t n : {1, 2, 16, 104, 105, 255, 256}) {
    const HighlightTable table(PowerTable(n), kWhite);
    CAPTURE(n);
    for (const std::int32_t at : {table.reach(), table.reach() + 1000, 1 << 26, INT32_MAX}) {
      CHECK(channel(highlight(table, at), 1) == Approx(255).margin(0.25));
    }
    const HighlightTable none(PowerTable(n), {0, 0, 0});
    for (const std::int32_t at : {1, 1000, none.reach(), INT32_MAX}) CHECK(highlight(none, at).lanes == 0);
  }
}

TEST_CASE("any closeness has a value up to that of the peak, also those that stand for no highlight") {
  Random random(2);
  for (const std::int32_t n : {1, 16, 256}) {
    const HighlightTable table(PowerTable(n), kWhite);
    for (int i = 0; i < share_of(20000); ++i) {
      const auto any = static_cast<std::int32_t>(static_cast<std::uint32_t>(random.bits()));
      REQUIRE(table.value(any) <= table.value(INT32_MAX));
    }
    for (const std::int32_t at : {0, -1, INT32_MIN}) CHECK(channel(highlight(table, at), 0) < 0.5);
  }
}

TEST_CASE("the values of a highlight table do not fall with the closeness") {
  for (const std::int32_t n : {1, 2, 7, 16, 64, 104, 256}) {
    const HighlightTable table(PowerTable(n), kWhite);
    std::uint32_t last = 0;
    for (std::int32_t at = 0; at < 1 << HighlightTable::kReachBits; at += stride_of(997)) {
      const std::uint32_t value = table.value(at);
      REQUIRE(value + (1u << 17) >= last);
      last = value;
    }
  }
}

TEST_CASE("a channel is its part of the largest one") {
  const HighlightTable table(PowerTable(16), {100 << 5, 200 << 5, 0});
  CHECK(table.channel(0, 200 << 8) == Approx(100 << 8).margin(2));
  CHECK(table.channel(1, 200 << 8) == 200 << 8);
  CHECK(table.channel(2, 200 << 8) == 0);
  const PackedRgb peak = highlight(table, table.reach());
  CHECK(channel(peak, 0) == Approx(100).margin(0.3));
  CHECK(channel(peak, 1) == Approx(200).margin(0.3));
  CHECK(channel(peak, 2) == 0);
}
