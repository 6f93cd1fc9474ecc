// SPDX-License-Identifier: MIT
#include <arcspan/literature/arc_vertex.hpp>

#include <catch2/catch.hpp>
#include <tests/support/slerp_oracle.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>

using namespace arcspan;
using namespace arcspan::test;
using literature::HalfWay;
using Vertex = literature::ArcVertex<2>;

namespace {

Cosine cosine_of(double v) {
  return Cosine::from_raw(static_cast<std::int32_t>(std::lround(std::ldexp(v, Cosine::kFraction))));
}

Vertex vertex_of(Vec3 normal, Vec3 axis) {
  return {to_normal(to_direction(normal)), {cosine_of(dot(normal, axis)), Cosine{}}};
}

bool same(const Vertex& p, const Vertex& q) { return p.normal == q.normal && p.scalars == q.scalars; }

Vec3 normal_of(const Vertex& v) {
  return (1.0 / 16384) * Vec3{double(v.normal.x.raw()), double(v.normal.y.raw()), double(v.normal.z.raw())};
}

}  // namespace

TEST_CASE("the vertex half-way along an arc does not depend on the arc's direction, and is half-way") {
  Random random(21);
  int different = 0;
  double worst = 0;
  double longest = 0;
  for (int i = 0; i < share_of(20000); ++i) {
    const Vec3 around = random_unit(random);
    const Vec3 axis = random_unit(random);
    const Vertex a = vertex_of(tilted(random, around, radians(random.real(0, 75))), axis);
    const Vertex b = vertex_of(tilted(random, around, radians(random.real(0, 75))), axis);
    const Vertex middle = half_way(a, b);
    different += same(middle, half_way(b, a)) ? 0 : 1;
    worst = std::max(worst, angle_between(normal_of(middle), normal_of(a) + normal_of(b)));
    longest = std::max(longest, std::abs(length(normal_of(middle)) - 1));
  }
  CHECK(different == 0);
  CHECK(degrees(worst) < 0.02);
  CHECK(longest < 0.0003);
}

TEST_CASE("half an arc has the chord that HalfWay says") {
  double worst = 0;
  for (int degree = 0; degree <= 175; ++degree) {
    const double s = 2 - 2 * std::cos(radians(degree));
    const double half = 2 - 2 * std::cos(radians(degree) / 2);
    const HalfWay halved(static_cast<std::uint32_t>(std::lround(std::ldexp(s, 28))));
    worst = std::max(worst, std::abs(std::ldexp(halved.chord(), -28) - half));
  }
  CHECK(worst < 1e-3);
}

TEST_CASE("a vertex between two others lies on their arc") {
  Random random(25);
  const double limits[4] = {30, 60, 120, 170};
  const double bounds[4] = {2e-4, 2.5e-4, 4e-4, 6e-3};
  for (int k = 0; k < 4; ++k) {
    double worst = 0;
    double worst_scalar = 0;
    for (int i = 0; i < share_of(20000); ++i) {
      const Vec3 n = random_unit(random);
      const Vec3 m = tilted(random, n, radians(limits[k] * std::sqrt(random.unit())));
      const Vec3 axis = random_unit(random);
      const std::int32_t raw = random.integer(0, 32768);
      const Vertex got = on_arc(vertex_of(n, axis), vertex_of(m, axis), Factor::from_raw(raw));
      const Vec3 truth = Slerp(n, m)(raw / 32768.0);
      worst = std::max(worst, length(normal_of(got) - truth));
      worst_scalar = std::max(worst_scalar, std::abs(to_double(got.scalars[0]) - dot(truth, axis)));
    }
    INFO("up to " << limits[k] << " degrees");
    CHECK(worst < bounds[k]);
    CHECK(worst_scalar < bounds[k]);
  }
}
