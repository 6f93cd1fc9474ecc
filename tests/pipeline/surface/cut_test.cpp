// SPDX-License-Identifier: MIT
// Triangles cut by the near plane or the guard band.
#include <catch2/catch.hpp>
#include <tests/support/surface_accuracy.hpp>
#include <tests/support/test_share.hpp>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Measurement = SurfaceMeasurement<Highlight::kPhong>;
using Method = Measurement::Method;

struct CutVertex {
  Method::Vertex shade;
  Vec3 normal;  ///< linear, not normalised
};

CutVertex cut(const CutVertex& a, const CutVertex& b, Factor t) {
  const double fraction = std::ldexp(t.raw(), -Factor::kFraction);
  return {Method::between(a.shade, b.shade, t), a.normal + fraction * (b.normal - a.normal)};
}

Factor random_fraction(Random& random) {
  return Factor::from_raw(random.chance(0.1) ? random.integer(0, 1) << 15 : random.integer(0, 1 << 15));
}

/// Draws what is left of triangles of which corners are cut off; `twice`: and of the rest again.
SurfaceErrors measure_cuts(std::int32_t shininess, double highlight_limit, double to_degrees, bool twice) {
  Measurement measurement;
  measurement.errors.highlight_limit = highlight_limit;
  Random random(static_cast<std::uint64_t>(shininess) + (twice ? 1000 : 0));
  for (int i = 0; i < share_of(1500); ++i) {
    SurfaceCase c = random_surface(random, {.to_degrees = to_degrees});
    c.shininess = shininess;
    std::array<Measurement::Vertex, 3> v = measurement.set_up(c);
    std::array<CutVertex, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = {v[k].shade, to_vec3(c.normals[k])};
    for (int round = 0; round < (twice ? 2 : 1); ++round) {
      const std::array<CutVertex, 3> before = corners;
      corners[1] = cut(before[0], before[1], random_fraction(random));
      corners[2] = cut(before[2], before[1], random_fraction(random));
    }
    std::array<Vec3, 3> normals;
    for (std::size_t k = 0; k < 3; ++k) {
      v[k].shade = corners[k].shade;
      normals[k] = corners[k].normal;
    }
    measurement.compare(c, v, normals);
  }
  return measurement.errors;
}

void check(const SurfaceErrors& errors, double most_highlight) {
  INFO("N·L: " << errors.light_case);
  INFO("highlight: " << errors.highlight_case);
  const double most_share = share_of(100) < 100 ? 0.004 : 0.001;  // few pixels say little
  CHECK(errors.missing == 0);
  CHECK(errors.light <= 1);
  CHECK(errors.light_share() <= most_share);
  CHECK(errors.highlight <= most_highlight);
  CHECK(errors.highlight_share() <= most_share);
}

SurfaceVertex<2> vertex(Vec3 normal) {
  const Direction n = to_direction(normalised(normal));
  return {to_normal(n), 0, {n.x.raw() == 0 ? Cosine{} : Cosine::from_raw(n.x.raw() << 15), Cosine::of(0.25)}};
}

double deficit(const SurfaceVertex<2>& v) { return v.deficit / 65536.0; }

}  // namespace

TEST_CASE("cut triangles are shaded as Phong's, within the limits of uncut ones") {
  check(measure_cuts(16, 3, 60, false), 13);
  check(measure_cuts(64, 8, 60, false), 40);
}

TEST_CASE("triangles cut by two planes are shaded as Phong's, within the limits of uncut ones") {
  check(measure_cuts(16, 3, 60, true), 13);
  check(measure_cuts(64, 8, 60, true), 40);
}

// A triangle that the guard band cuts may be as large as the band: 2,040 pixels.
TEST_CASE("cut triangles as large as the guard band are within the limits") {
  for (const std::int32_t shininess : {16, 64}) {
    Measurement measurement;
    Random random(static_cast<std::uint64_t>(shininess));
    for (int i = 0; i < share_of(1500); ++i) {
      SurfaceCase c = random_surface(random, {.smallest = 900, .slivers = 0});
      c.shininess = shininess;
      for (Point& point : c.points) point = {random.integer(-16300, 16300), random.integer(-16300, 16300)};
      if (i % 2 == 0) {
        c.points[0].y = -16300;
        c.points[1].y = 16300;
      }
      const auto row = static_cast<std::int32_t>(random.integer(0, 2040));
      c.window = {0, row, 2048, row + 4};
      std::array<Measurement::Vertex, 3> v = measurement.set_up(c);
      const CutVertex top{v[0].shade, to_vec3(c.normals[0])};
      const CutVertex far{v[1].shade, to_vec3(c.normals[1])};
      const CutVertex end = cut(top, far, random_fraction(random));
      v[1].shade = end.shade;
      measurement.compare(c, v, {top.normal, end.normal, to_vec3(c.normals[2])});
    }
    INFO("highlight: " << measurement.errors.highlight_case);
    CHECK(measurement.errors.missing == 0);
    CHECK(measurement.errors.light <= 0.2);
    CHECK(measurement.errors.highlight <= (shininess == 16 ? 13 : 40));
  }
}

TEST_CASE("the middle of a chord does not depend on its direction") {
  Random random(1);
  const Factor half = Factor::of(0.5);
  for (int i = 0; i < share_of(10000); ++i) {
    const SurfaceVertex<2> a = vertex(random_unit(random));
    const SurfaceVertex<2> b = vertex(random_unit(random));
    const SurfaceVertex<2> ab = on_chord(a, b, half);
    const SurfaceVertex<2> ba = on_chord(b, a, half);
    REQUIRE(ab.normal == ba.normal);
    REQUIRE(ab.deficit == ba.deficit);
    REQUIRE(ab.scalars == ba.scalars);
  }
}

TEST_CASE("the ends of a chord are its vertices") {
  const SurfaceVertex<2> a = vertex({1, 2, 3});
  const SurfaceVertex<2> b = vertex({-1, 0.5, 0.25});
  CHECK(on_chord(a, b, Factor::of(0.0)).normal == a.normal);
  CHECK(on_chord(a, b, Factor::of(0.0)).deficit == 0);
  CHECK(on_chord(a, b, Factor::of(0.0)).scalars == a.scalars);
  CHECK(on_chord(a, b, Factor::of(1.0)).normal == b.normal);
  CHECK(on_chord(a, b, Factor::of(1.0)).deficit == 0);
  CHECK(on_chord(a, b, Factor::of(1.0)).scalars == b.scalars);
}

TEST_CASE("a cut knows what its normal lacks, and so does the cut of a cut") {
  Random random(2);
  for (int i = 0; i < share_of(10000); ++i) {
    const Vec3 a = random_unit(random);
    const Vec3 b = tilted(random, a, radians(random.real(0, 170)));
    const Vec3 c = tilted(random, a, radians(random.real(0, 170)));
    const Factor t = random_fraction(random);
    const Factor u = random_fraction(random);
    const SurfaceVertex<2> first = on_chord(vertex(a), vertex(b), t);
    const Vec3 m = a + std::ldexp(t.raw(), -15) * (b - a);
    REQUIRE(deficit(first) == Approx(1 - dot(m, m)).margin(3e-4));
    const SurfaceVertex<2> second = on_chord(first, vertex(c), u);
    const Vec3 n = m + std::ldexp(u.raw(), -15) * (c - m);
    REQUIRE(deficit(second) == Approx(1 - dot(n, n)).margin(6e-4));
  }
}
