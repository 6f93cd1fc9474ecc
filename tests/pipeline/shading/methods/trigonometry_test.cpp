// SPDX-License-Identifier: MIT
// The sine table and the CORDIC that two of the methods are made of.
#include <arcspan/literature/polar.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace arcspan;
using namespace arcspan::test;

namespace {

double to_radians(Angle32 angle) { return angle * (std::numbers::pi / 2) / kQuarterTurn; }

}  // namespace

TEST_CASE("the sine table is within 5e-5 of the sine itself down to 2^-8 rad") {
  double worst = 0;
  for (Angle32 angle = 2670000; angle < kQuarterTurn; angle += 4099) {
    const double truth = std::sin(to_radians(angle));
    worst = std::max(worst, std::abs(std::ldexp(quarter_sine(angle), -30) - truth) / truth);
  }
  INFO("relative error " << worst);
  CHECK(worst < 5e-5);
  CHECK(quarter_sine(0) == 0);
  CHECK(quarter_sine(kQuarterTurn) == 1u << 30);
}

TEST_CASE("the cosine is the cosine all round") {
  double worst = 0;
  for (std::uint64_t angle = 0; angle < 1ull << 32; angle += 40009) {
    const auto a = static_cast<Angle32>(angle);
    worst = std::max(worst, std::abs(std::ldexp(cosine(a), -30) - std::cos(to_radians(a))));
  }
  INFO("error " << worst);
  CHECK(worst < 6e-6);
}

TEST_CASE("to_polar gives size and angle") {
  Random random(5);
  double worst_angle = 0;
  double worst_size = 0;
  for (int i = 0; i < 200000; ++i) {
    const double size = random.decades(1 << 24, 1 << 29);
    const double angle = random.real(-std::numbers::pi, std::numbers::pi);
    const auto x = static_cast<std::int32_t>(std::lround(size * std::cos(angle)));
    const auto y = static_cast<std::int32_t>(std::lround(size * std::sin(angle)));
    const Polar polar = to_polar(x, y);
    const double difference = to_radians(polar.angle) - std::atan2(y, x);
    worst_angle = std::max(worst_angle, std::abs(std::remainder(difference, 2 * std::numbers::pi)));
    const double truth = std::hypot(x, y);
    worst_size = std::max(worst_size, (std::abs(polar.size - truth) - 20) / truth);
  }
  INFO("angle " << worst_angle << ", size " << worst_size);
  CHECK(worst_angle < 0x1p-18);
  CHECK(worst_size < 0x1p-20);
  CHECK(to_polar(0, 0).size == 0);
}
