// SPDX-License-Identifier: MIT
// Four pixels at a time against the single step, and the printed equations of S0 against what they should be.
#include <arcspan/literature/recurrence_four.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/vec3.hpp>

#include <algorithm>
#include <cmath>

using namespace arcspan;
using namespace arcspan::test;

namespace {

double value_of(const RecurrenceStep& k) { return std::ldexp(k.mantissa, -(16 + k.shift)); }

/// k of a step of phi radians, rounded to RecurrenceStep's 15 bits.
RecurrenceStep step_of(double phi) {
  const double k = 2 - 2 * std::cos(phi);
  int exponent = 0;
  const double fraction = std::frexp(k, &exponent);  // k = fraction * 2^exponent
  const auto mantissa = std::min<long>(std::lround(fraction * 32768), 32767);
  return {static_cast<std::int32_t>(mantissa), 15 - exponent - 16, 0};
}

double value_of(const BlockFactor& f) { return std::ldexp(f.mantissa, -(16 + f.shift)); }

struct FourError {
  double single = 0;       ///< of the single step, from the exact cosine
  double from_single = 0;  ///< of four at a time
  double from_exact = 0;
};

/// Arcs of up to `degrees` over 8...256 pixels.
FourError worst_of(std::uint64_t seed, int arcs, double degrees) {
  Random random(seed);
  FourError worst;
  for (int i = 0; i < arcs; ++i) {
    const int pixels = random.integer(8, 256);
    const double phi = radians(random.decades(0.5, degrees)) / pixels;
    const double from = random.real(-3.14, 3.14);
    const auto exact = [&](int t) { return std::cos(from + t * phi); };
    const RecurrenceStep single = step_of(phi);
    const FourSteps four = FourSteps::of(single);
    const auto unit = [](double v) {
      return Cosine::from_raw(static_cast<std::int32_t>(std::lround(std::ldexp(v, 30))));
    };
    RecurrenceScalar walk{unit(exact(0)), unit(exact(1) - exact(0))};
    RecurrenceScalar state = walk;
    std::array<Cosine, 4> values{};
    for (int t = 0; t < pixels; ++t) {
      if (t % 4 == 0) values = four.step(state);
      const double got = to_double(values[static_cast<std::size_t>(t) % 4]);
      if (t < 2) REQUIRE(got == to_double(walk.x));
      worst.single = std::max(worst.single, std::abs(to_double(walk.x) - exact(t)));
      worst.from_single = std::max(worst.from_single, std::abs(got - to_double(walk.x)));
      worst.from_exact = std::max(worst.from_exact, std::abs(got - exact(t)));
      walk.step(single.mantissa, single.shift);
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("the factors of four pixels are those of S0 eq. 7 and 9 to 11, for every angle of a step") {
  for (double angle = 0.002; angle < 28.9; angle *= 1.003) {
    const RecurrenceStep k = step_of(radians(angle));
    if (k.shift > 31) continue;
    const double c = 1 - value_of(k) / 2;
    // Chebyshev polynomials of the second kind: N(t+j) = U_j N(t) - U_{j-1} N(t-1).
    const double u[] = {1, 2 * c, 4 * c * c - 1, 8 * c * c * c - 4 * c, 16 * c * c * c * c - 12 * c * c + 1};
    const FourSteps four = FourSteps::of(k);
    CAPTURE(angle);
    for (std::size_t j = 1; j <= 4; ++j) {
      const double of_normal = 1 - (u[j] - u[j - 1]);
      CHECK(value_of(four.of_normal[j - 1]) == Approx(of_normal).epsilon(0x1p-14).margin(1e-9));
      CHECK(four.of_normal[j - 1].mantissa < 1 << 18);
      if (j == 1) continue;
      const double of_difference = static_cast<double>(j) - u[j - 1];
      CHECK(value_of(four.of_difference[j - 2]) == Approx(of_difference).epsilon(0x1p-14).margin(1e-9));
    }
  }
}

TEST_CASE("four pixels at a time agree with the single step and with the exact cosine") {
  const FourError narrow = worst_of(3, 4000, 30);
  const FourError wide = worst_of(4, 4000, 60);
  INFO("30 degrees: single " << narrow.single << ", four " << narrow.from_single << " " << narrow.from_exact
                             << ", 60 degrees: single " << wide.single << ", four " << wide.from_single << " "
                             << wide.from_exact);
  CHECK(narrow.from_exact < 1e-5);
  CHECK(wide.from_exact < 3e-5);
  CHECK(wide.from_single < 4e-5);
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
