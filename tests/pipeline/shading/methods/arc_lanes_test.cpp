// SPDX-License-Identifier: MIT
// Lanes against the single step, and the printed equations of S0 against what they should be.
#include <catch2/catch.hpp>
#include <tests/support/arc_lanes.hpp>
#include <tests/support/random.hpp>
#include <tests/support/vec3.hpp>

#include <algorithm>
#include <cmath>

using namespace arcspan;
using namespace arcspan::test;

namespace {

double value_of(const ArcStep& k) { return std::ldexp(k.mantissa, -(16 + k.shift)); }

/// k of a step of phi radians, rounded to ArcStep's 15 bits.
ArcStep step_of(double phi) {
  const double k = 2 - 2 * std::cos(phi);
  int exponent = 0;
  const double fraction = std::frexp(k, &exponent);  // k = fraction * 2^exponent
  const auto mantissa = std::min<long>(std::lround(fraction * 32768), 32767);
  return {static_cast<std::int32_t>(mantissa), 15 - exponent - 16, 0};
}

struct LaneError {
  double from_single = 0;
  double from_exact = 0;
};

/// ArcTriangle of up to 60 degrees over up to 256 pixels.
template <std::size_t Count>
LaneError worst_of(std::uint64_t seed, int arcs) {
  Random random(seed);
  LaneError worst;
  for (int i = 0; i < arcs; ++i) {
    const int pixels = random.integer(8 * static_cast<int>(Count), 256);
    const double phi = radians(random.decades(0.5, 58)) / pixels;
    const double from = random.real(-3.14, 3.14);
    const auto exact = [&](int t) { return std::cos(from + t * phi); };
    const ArcStep single = step_of(phi);
    ArcStep stride = single;
    REQUIRE(make_stride<Count>(stride));
    const auto unit = [](double v) {
      return Cosine::from_raw(static_cast<std::int32_t>(std::lround(std::ldexp(v, 30))));
    };
    ArcScalar walk{unit(exact(0)), unit(exact(1) - exact(0))};
    ArcLanes<Count> lanes;
    lanes.start(walk, single);
    for (int t = 0; t < pixels; ++t) {
      const auto lane = static_cast<std::size_t>(t) % Count;
      if (t > 0 && lane == 0) lanes.step(stride);
      const double got = to_double(lanes.lanes[lane].x);
      if (t < 2 * static_cast<int>(Count)) REQUIRE(lanes.lanes[lane].x == walk.x);
      worst.from_single = std::max(worst.from_single, std::abs(got - to_double(walk.x)));
      worst.from_exact = std::max(worst.from_exact, std::abs(got - exact(t)));
      walk.step(single.mantissa, single.shift);
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("doubling the stride keeps k to its 15 bits") {
  for (double angle = 0.002; angle < 14.4; angle *= 1.003) {
    ArcStep k = step_of(radians(angle));
    if (k.shift > 31) continue;
    const double before = value_of(k);
    REQUIRE(double_stride(k));
    const double truth = before * (4 - before);
    CHECK(std::abs(value_of(k) - truth) <= truth * 0x1p-14);
    CHECK(k.mantissa < 32768);
  }
}

TEST_CASE("a stride that cannot be held is refused and leaves k alone") {
  ArcStep k = step_of(radians(14.6));
  const ArcStep before = k;
  CHECK_FALSE(double_stride(k));
  CHECK(k.mantissa == before.mantissa);
  CHECK(k.shift == before.shift);
  k = step_of(radians(7.3));
  CHECK_FALSE(make_stride<4>(k));
  CHECK(k.shift == step_of(radians(7.3)).shift);
  CHECK(make_stride<2>(k));
  ArcStep linear{0, 31, 0};
  CHECK(make_stride<8>(linear));
  CHECK(linear.mantissa == 0);
}

TEST_CASE("four and eight lanes agree with the single step") {
  const LaneError one = worst_of<1>(3, 4000);
  const LaneError four = worst_of<4>(3, 4000);
  const LaneError eight = worst_of<8>(4, 4000);
  INFO("one " << one.from_exact << ", four " << four.from_single << " " << four.from_exact << ", eight "
              << eight.from_single << " " << eight.from_exact);
  CHECK(one.from_exact < 3e-5);
  CHECK(four.from_single < 3e-5);
  CHECK(four.from_exact < 4.5e-5);
  CHECK(eight.from_single < 3e-5);
  CHECK(eight.from_exact < 5e-5);
}

TEST_CASE("S0 eq. 9 is right, eq. 10 and 11 are printed wrong") {
  const double phi = radians(5);
  const auto x = [phi](int t) { return std::cos(0.3 + t * phi); };
  const double c = std::cos(phi);
  const double c2 = std::cos(2 * phi);
  // From N(0) and N(-1): N(t+j) = U_j N(t) - U_{j-1} N(t-1), U the Chebyshev polynomials of the second kind.
  const auto general = [&](double u, double before) { return u * x(0) - before * x(-1); };
  CHECK(general(1 + 2 * c2, 2 * c) == Approx(x(2)).margin(1e-12));
  CHECK(general(4 * c * c2, 1 + 2 * c2) == Approx(x(3)).margin(1e-12));
  CHECK(general(4 * c2 * c2 + 2 * c2 - 1, 4 * c * c2) == Approx(x(4)).margin(1e-12));
  // In the paper's form, corrected: two factors and a sign.
  CHECK(c2 * (4 * c * x(0) - 2 * x(-1)) - x(-1) == Approx(x(3)).margin(1e-12));
  CHECK(2 * c2 * (2 * c2 + 1) * x(0) - 4 * c * c2 * x(-1) - x(0) == Approx(x(4)).margin(1e-12));
  // As printed.
  CHECK(x(3) == Approx(0.846298).margin(1e-6));
  CHECK(x(4) == Approx(0.796649).margin(1e-6));
  CHECK(c2 * (4 * c * x(0) - x(-1)) - 3 * x(-1) == Approx(-0.146009).margin(1e-6));
  CHECK(2 * x(0) * c2 * (2 * c2 + 3) - 2 * x(-1) * c * (c2 + 4) + x(0) == Approx(0.598599).margin(1e-6));
}
