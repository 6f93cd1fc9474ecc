// SPDX-License-Identifier: MIT
// Gradients by one long product, which machines with wide registers use, and by short ones.
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/prepare/linear.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>

using namespace arcspan;
using namespace arcspan::test;

namespace {

/// The product of the difference and the 15-bit mantissa, shifted, rounded and saturated without overflow.
template <class Value>
std::int64_t exact_gradient(std::int64_t difference, const Reciprocal& inverse, int bits) {
  const std::int64_t product = difference * (inverse.mantissa >> 1);
  const int shift = inverse.exponent - 1 - bits - Value::kFraction;
  const std::int64_t quotient = shift < 1 ? product * (std::int64_t{1} << -shift)
                                          : (product + (std::int64_t{1} << (shift - 1))) >> shift;
  constexpr std::int64_t kMost = kMaxGradient<Value>;
  return std::clamp(quotient, -kMost, kMost);
}

struct Figures {
  int wrong = 0;
  int saturated = 0;
  double worst = 0;  ///< relative error beyond the rounding of the result
};

/// `distance` has `bits` fraction bits.
template <class Value>
void check(std::int32_t difference, std::uint32_t distance, int bits, Figures& figures) {
  const Reciprocal inverse = nonzero_reciprocal(distance);
  const std::int32_t got = gradient<Value>(difference, inverse, bits).raw();
  figures.wrong += got == exact_gradient<Value>(difference, inverse, bits) ? 0 : 1;
  if (std::abs(got) == kMaxGradient<Value>) {
    ++figures.saturated;
    return;
  }
  const double truth = std::ldexp(static_cast<double>(difference) / distance, bits + Value::kFraction);
  if (difference != 0) {
    figures.worst = std::max(figures.worst, (std::abs(got - truth) - 0.5) / std::abs(truth));
  }
}

}  // namespace

TEMPLATE_TEST_CASE("a gradient is the quotient, saturated", "", Linear, FullLinear) {
  Random random(22);
  Figures figures;
  for (int i = 0; i < share_of(200000); ++i) {
    const std::int32_t difference = random.chance(0.1)
                                        ? 65535 * random.integer(-1, 1)
                                        : random.integer(-65535, 65535) >> random.integer(0, 15);
    // Heights in 16ths of a row, widths of rows in pixels with 16 fraction bits, and lengths of lines.
    check<TestType>(difference, static_cast<std::uint32_t>(random.decades(1, 32768)), 4, figures);
    check<TestType>(difference, static_cast<std::uint32_t>(random.decades(1, 1u << 27)), 16, figures);
    check<TestType>(difference, static_cast<std::uint32_t>(random.decades(1, 2048)), 0, figures);
  }
  CHECK(figures.wrong == 0);
  CHECK(figures.saturated > share_of(2000));
  CHECK(figures.worst < 7e-5);  // 3.8e-5 of the reciprocal and 2^-15 of its mantissa's last bit
}
