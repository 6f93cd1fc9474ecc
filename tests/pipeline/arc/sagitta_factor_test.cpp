// SPDX-License-Identifier: MIT
#include <arcspan/shading/patch/sagitta_factor.hpp>

#include <catch2/catch.hpp>
#include <tests/support/vec3.hpp>

#include <cmath>

using namespace arcspan;
using namespace arcspan::test;

TEST_CASE("an edge's sagitta factor is 4 (1 / cos(psi/2) - 1) within 3e-4 up to 40 degrees") {
  for (double degrees = 0; degrees <= 40; degrees += 0.25) {
    const double half = radians(degrees) / 2;
    const auto chord = static_cast<std::uint32_t>(4 * std::sin(half) * std::sin(half) * 0x1p28);
    CAPTURE(degrees);
    CHECK(sagitta_factor(chord).raw() * 0x1p-18 == Approx(4 * (1 / std::cos(half) - 1)).margin(3e-4));
  }
}
