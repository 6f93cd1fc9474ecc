// SPDX-License-Identifier: MIT
// The polynomials of arcs and of the rows' angles, against double precision.
#include <arcspan/literature/row_angles.hpp>

#include <catch2/catch.hpp>
#include <tests/support/slerp_oracle.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>

using namespace arcspan;
using namespace arcspan::test;
using literature::ArcShape;
using literature::HalfChords;
using literature::RowAngles;

namespace {

std::uint32_t chord28(Vec3 a, Vec3 b) {
  const Vec3 d = a - b;
  return static_cast<std::uint32_t>(std::lround(std::ldexp(dot(d, d), 28)));
}
Cosine cosine_of(double v) {
  return Cosine::from_raw(static_cast<std::int32_t>(std::lround(std::ldexp(v, 30))));
}
double psi2(Vec3 a, Vec3 b) { return angle_between(a, b) * angle_between(a, b); }

}  // namespace

TEST_CASE("a scalar on an arc is within 2e-5 up to 30 degrees and 5e-5 up to 60, either way round") {
  Random random(31);
  const double limits[2] = {30, 60};
  const double bounds[2] = {2e-5, 5e-5};
  for (int k = 0; k < 2; ++k) {
    double worst = 0;
    double one_way = 0;
    for (int i = 0; i < share_of(50000); ++i) {
      const Vec3 n = random_unit(random);
      const Vec3 m = tilted(random, n, radians(limits[k] * random.unit()));
      const Vec3 axis = random_unit(random);
      const Factor t = Factor::from_raw(random.integer(0, 32768));
      const ArcShape shape(chord28(n, m));
      const Cosine a = cosine_of(dot(n, axis));
      const Cosine b = cosine_of(dot(m, axis));
      const double there = to_double(shape.between(a, b, t, shape.excess(t)));
      const Factor back = Factor::of(1.0) - t;
      one_way = std::max(one_way, std::abs(there - to_double(shape.between(b, a, back, shape.excess(back)))));
      worst = std::max(worst, std::abs(there - dot(Slerp(n, m)(t.raw() / 32768.0), axis)));
    }
    INFO("up to " << limits[k] << " degrees");
    CHECK(worst < bounds[k]);
    CHECK(one_way < 3e-5);
  }
}

TEST_CASE("the squared angles of rows are within 2e-4 up to 30 degrees and 1e-3 up to 60") {
  Random random(32);
  const double limits[2] = {30, 60};
  const double bounds[2] = {2e-4, 1e-3};
  for (int k = 0; k < 2; ++k) {
    double worst = 0;
    for (int i = 0; i < share_of(20000); ++i) {
      const Vec3 around = random_unit(random);
      const Vec3 a = tilted(random, around, radians(limits[k] / 2 * random.unit()));
      const Vec3 b = tilted(random, around, radians(limits[k] / 2 * random.unit()));
      const Vec3 c = tilted(random, around, radians(limits[k] / 2 * random.unit()));
      const Factor t = Factor::from_raw(random.integer(0, 32768));
      const auto chord16 = [](Vec3 p, Vec3 q) { return (chord28(p, q) + (1u << 11)) >> 12; };
      const HalfChords chords{chord16(a, b), chord16(a, c), chord16(b, c)};
      const ArcShape ac(chord28(a, c));
      const RowAngles rows =
          make_row_angles(chords, ArcShape(chord28(a, b)), ac, t, middle_row_angle(chords, ac, t), true);
      const Factor at = Factor::from_raw(random.integer(0, 32768));
      const double down = at.raw() / 32768.0;
      const double truth = psi2(Slerp(a, b)(down), Slerp(a, c)(down * t.raw() / 32768.0));
      worst = std::max(worst, std::abs(rows.squared(at).raw() / 32768.0 - truth));
    }
    INFO("up to " << limits[k] << " degrees");
    CHECK(worst < bounds[k]);
  }
}
