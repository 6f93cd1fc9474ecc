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

/// A channel as colour() adds it: 2 fraction bits.
double channel(PackedRgb colour, std::size_t c) {
  constexpr std::array<int, 3> kAt{11, 22, 0};
  return ((colour.lanes >> kAt[c]) & 1023u) / 4.0;
}

double truth(std::int32_t n, double half_distance) {
  return std::pow(std::max(0.0, 1 - 2 * half_distance), n);
}

/// The farthest that any channel is from steps * c^n, both ways, over the whole reach.
struct Error {
  double above = 0;
  double below = 0;
};
Error worst_error(std::int32_t n, const Coefficients& specular) {
  const PowerTable power(n);
  const HighlightTable ramp(power, specular);
  Error worst;
  for (std::int32_t i = 0; i <= 4096; i += stride_of(1)) {
    const auto half = static_cast<std::int32_t>(std::int64_t{power.half_reach() - 1} * i / 4096);
    const std::int32_t distance = ramp.scaled(half);
    if (distance >= HighlightTable::kReach) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const double error = channel(ramp(distance), c) - specular[c] / 32.0 * truth(n, std::ldexp(half, -30));
      worst.above = std::max(worst.above, error);
      worst.below = std::max(worst.below, -error);
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("a specular ramp is the power times the coefficient, cut to a quarter of an 8-bit step") {
  Random random(1);
  for (std::int32_t n = 1; n <= 256; ++n) {
    const auto share = [&random] { return static_cast<std::uint32_t>(random.integer(0, 255 << 5)); };
    const Coefficients coloured{share(), share(), share()};
    for (const Coefficients& specular : {kWhite, coloured}) {
      const Error error = worst_error(n, specular);
      INFO("n = " << n);
      CHECK(error.above < 0.19);  // the power table's 6.9e-4, in steps
      CHECK(error.below < 0.26 + 0.19);
    }
  }
}

TEST_CASE("a specular ramp's reach is that of the power, whatever the exponent") {
  for (std::int32_t n = 1; n <= 256; ++n) {
    const PowerTable power(n);
    const HighlightTable ramp(power, kWhite);
    INFO("n = " << n);
    const double scale = std::ldexp(power.half_reach(), -26);
    int wrong = 0;
    for (std::int32_t i = -8; i < 32; ++i) {
      const auto half = static_cast<std::int32_t>(std::int64_t{power.half_reach()} * i / 8);
      if (!ramp.fits(half)) continue;
      wrong += std::abs(ramp.scaled(half) - half / scale) <= 4 ? 0 : 1;
    }
    CHECK(wrong == 0);
    const std::int32_t reach = power.half_reach();
    CHECK(ramp.fits(reach));
    CHECK((reach >= 1 << 27 || ramp.fits(4 * (reach - 1))));
  }
}

TEST_CASE("a specular ramp is full at no distance and at less, and black without coefficients") {
  for (const std::int32_t n : {1, 2, 16, 255, 256}) {
    const HighlightTable ramp(PowerTable(n), kWhite);
    for (const std::int32_t distance : {0, -1, -(1 << 20), INT32_MIN}) {
      CHECK(ramp(distance).lanes == PackedRgb::grey(1020).lanes);
    }
    const HighlightTable none(PowerTable(n), {0, 0, 0});
    for (const std::int32_t distance : {-1, 0, 1000, HighlightTable::kReach - 1}) {
      CHECK(none(distance).lanes == 0);
    }
  }
}

TEST_CASE("a line of a ramp is at most 2^-5 above its values and never below, anywhere in the table") {
  Random random(141);
  int wrong = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto interval = static_cast<std::uint32_t>(random.integer(0, 127));
    const auto here = static_cast<std::uint32_t>(random.integer(0, 65280));
    const auto next = static_cast<std::uint32_t>(random.integer(0, static_cast<std::int32_t>(here)));
    const detail::HighlightLine line(interval, here, next);
    const std::uint32_t length = 1u << detail::HighlightLine::kIntervalBits;
    for (std::uint32_t inside = 0; inside < length; inside += 8191) {
      const double value = here - (static_cast<double>(here) - next) * inside / length;
      const double at = std::ldexp(line(interval * length + inside), -16);
      wrong += at >= value - 1e-4 && at <= value + 8.2 ? 0 : 1;  // in 2^-8, with the fall's own bits
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("a white ramp has the same values at any distance, clamped, and ends at 0") {
  for (const std::int32_t n : {1, 2, 16, 255, 256}) {
    const HighlightTable ramp(PowerTable(n), kWhite);
    CHECK(ramp.is_always_white());
    int wrong = 0;
    for (std::int32_t distance = 0; distance < HighlightTable::kReach; distance += 4099)
      wrong += PackedRgb::grey(ramp.white(distance)).lanes == ramp(distance).lanes ? 0 : 1;
    CHECK(wrong == 0);
    for (const std::int32_t distance : {-1, INT32_MIN}) CHECK(ramp.white(distance) == 1020);
    for (const std::int32_t distance : {HighlightTable::kReach - 1, HighlightTable::kReach, INT32_MAX})
      CHECK(ramp.white(distance) == 0);
  }
  CHECK(!HighlightTable(PowerTable(16), {1, 2, 1}).is_always_white());
}
