// SPDX-License-Identifier: MIT
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/shading/adaptive/highlight_quartic.hpp>
#include <arcspan/shading/patch/parabola.hpp>
#include <arcspan/shading/patch/patch_limits.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

using namespace arcspan;
using namespace arcspan::test;

namespace {

/// amplitude * cos(at + step * x) near a pixel x = 0, as the parabola of a patch is.
Parabola arc_at(double amplitude, double at, double step) {
  const auto cosine = [](double v) {
    return Cosine::from_raw(static_cast<std::int32_t>(std::lround(std::ldexp(v, 30))));
  };
  const double second = -amplitude * step * step * std::cos(at);
  return {cosine(amplitude * std::cos(at)), cosine(-amplitude * step * std::sin(at) + second / 2),
          cosine(second)};
}

double value_at(const Parabola& p, double x) {
  return p.x.raw() + p.d.raw() * x + p.second_difference.raw() * x * (x - 1) / 2;
}

}  // namespace

TEST_CASE("fourth differences step the product of two parabolas") {
  Random random(3);
  double most = 0;
  for (int i = 0; i < share_of(20000); ++i) {
    const double width =
        std::exp2(random.real(std::log2(QuarticConstants::kLeastWidth >> 16), std::log2(kLargestPatch)));
    const double step = random.real(-1, 1) * 0.576 / width;  // up to 33 degrees per row
    const double scale = random.real(0.05, 1.22);            // HighlightTable::scaled_factor()
    const Parabola f = arc_at(1, random.real(-1.5, 1.5), step);
    const Parabola g = arc_at(scale, random.real(-1.5, 1.5), step);
    const std::int32_t origin = 1 << 26;
    const auto pixels = static_cast<std::int32_t>(width);
    QuarticSteps steps;
    steps.start(f, g, QuarticConstants(origin, f.second_difference, g.second_difference, pixels));
    double off = 0;
    for (int x = 0; x < pixels; ++x) {
      const double exact = origin - std::ldexp(value_at(f, x) * value_at(g, x), -30);
      off = std::max(off, std::abs(steps.value() - exact));
      steps.next();
    }
    most = std::max(most, off);
  }
  // In 8-bit steps where a highlight of n = 64 falls fastest: 7 * 255 steps per reach.
  CAPTURE(most);
  CHECK(std::ldexp(most, -26) * 7 * 255 < 0.2);
}
