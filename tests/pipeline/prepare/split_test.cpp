// SPDX-License-Identifier: MIT
#include <arcspan/prepare/split.hpp>
#include <arcspan/shading/arc/arc.hpp>

#include <catch2/catch.hpp>
#include <tests/support/slerp_oracle.hpp>

#include <set>

using namespace arcspan;
using namespace arcspan::test;
using Method = Arc<Illumination<1, Highlight::kBlinn>>;
using Vertex = RasterVertex<Method>;

namespace {

Vertex random_vertex(Random& random, Vec3 around, double cone) {
  Method::Lighting lighting;
  REQUIRE(ok(Method::Lighting::make({}, {DirectionalLight{to_direction(random_unit(random))}},
                                    to_direction(random_unit(random)), lighting)));
  const auto coordinate = [&random] { return static_cast<std::int16_t>(random.integer(-16384, 16383)); };
  return {{coordinate(), coordinate(), static_cast<std::uint16_t>(random.integer(256, 65279))},
          Method::shade_vertex(lighting, to_direction(tilted(random, around, random.real(0, cone))))};
}

bool same(const Vertex& p, const Vertex& q) {
  return p.position == q.position && p.shade.normal == q.shade.normal && p.shade.scalars == q.shade.scalars;
}

Vec3 normal_of(const Vertex& v) {
  return (1.0 / 16384) *
         Vec3{double(v.shade.normal.x.raw()), double(v.shade.normal.y.raw()), double(v.shade.normal.z.raw())};
}

}  // namespace

TEST_CASE("the middle of an edge does not depend on the edge's direction") {
  Random random(21);
  int different = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 around = random_unit(random);
    const Vertex a = random_vertex(random, around, radians(85));
    const Vertex b = random_vertex(random, around, radians(85));
    different += same(middle_vertex(a, b), middle_vertex(b, a)) ? 0 : 1;
  }
  CHECK(different == 0);
}

TEST_CASE("the middle of a wide edge is the middle of its arc") {
  Random random(22);
  double worst = 0;
  double longest = 0;
  int wide = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 around = random_unit(random);
    const Vertex a = random_vertex(random, around, radians(75));
    const Vertex b = random_vertex(random, around, radians(75));
    if (!Method::too_wide(a.shade, b.shade)) continue;
    const Vec3 middle = normal_of(middle_vertex(a, b));
    ++wide;
    worst = std::max(worst, angle_between(middle, normal_of(a) + normal_of(b)));
    longest = std::max(longest, std::abs(length(middle) - 1));
  }
  CHECK(wide > 5000);
  CHECK(degrees(worst) < 0.02);
  CHECK(longest < 0.0003);
}

TEST_CASE("a vertex between two others lies on their arc") {
  Random random(25);
  const double limits[4] = {30, 60, 120, 170};
  const double bounds[4] = {2e-4, 2.2e-3, 2.2e-3, 6e-3};
  for (int k = 0; k < 4; ++k) {
    double worst = 0;
    double worst_scalar = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vec3 n = random_unit(random);
      const Vec3 m = tilted(random, n, radians(limits[k] * std::sqrt(random.unit())));
      const Vec3 axis = random_unit(random);
      Method::Vertex v[2] = {{to_normal(to_direction(n)), {}}, {to_normal(to_direction(m)), {}}};
      v[0].scalars = {Cosine::from_raw(static_cast<std::int32_t>(std::lround(std::ldexp(dot(n, axis), 30)))),
                      {}};
      v[1].scalars = {Cosine::from_raw(static_cast<std::int32_t>(std::lround(std::ldexp(dot(m, axis), 30)))),
                      {}};
      const std::int32_t raw = random.integer(0, 32768);
      const Method::Vertex got = Method::between(v[0], v[1], Factor::from_raw(raw));
      const Vec3 truth = Slerp(n, m)(raw / 32768.0);
      worst = std::max(worst, length(normal_of({{}, got}) - truth));
      worst_scalar = std::max(worst_scalar, std::abs(to_double(got.scalars[0]) - dot(truth, axis)));
    }
    INFO("up to " << limits[k] << " degrees");
    CHECK(worst < bounds[k]);
    CHECK(worst_scalar < bounds[k]);
  }
}

TEST_CASE("splitting keeps the area, the orientation and narrow arcs") {
  Random random(23);
  int wide = 0;
  int parts = 0;
  double largest_difference = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 around = random_unit(random);
    const double cone = radians(i % 2 == 0 ? 60 : 90);
    const Vertex v[3] = {random_vertex(random, around, cone), random_vertex(random, around, cone),
                         random_vertex(random, around, cone)};
    double area = 0;
    const auto emit = [&](const Vertex& a, const Vertex& b, const Vertex& c) {
      ++parts;
      area += doubled_area(a.position, b.position, c.position);
      wide += Method::too_wide(a.shade, b.shade) || Method::too_wide(b.shade, c.shade) ||
                      Method::too_wide(c.shade, a.shade)
                  ? 1
                  : 0;
    };
    split_triangle(v[0], v[1], v[2], emit);
    const double whole = doubled_area(v[0].position, v[1].position, v[2].position);
    // A middle is snapped by at most half a sixteenth: times the perimeter.
    largest_difference = std::max(largest_difference, std::abs(area - whole));
  }
  CHECK(wide == 0);
  CHECK(parts > 25000);
  CHECK(largest_difference < 8 * 32768);
}

TEST_CASE("both triangles of an edge cut it into the same pieces") {
  Random random(24);
  int different = 0;
  int cut = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 around = random_unit(random);
    Vertex a = random_vertex(random, around, radians(100));
    Vertex b = random_vertex(random, around, radians(100));
    // A steep edge far to the left of both third corners: points on it are told by their x.
    a.position.x = b.position.x = -16384;
    using Pieces = std::set<std::pair<std::int16_t, std::int16_t>>;
    const auto pieces = [&](const Vertex& p, const Vertex& q) {
      Vertex c = random_vertex(random, around, radians(100));
      c.position.x = 16383;
      Pieces result;
      const auto emit = [&result](const Vertex& u, const Vertex& v, const Vertex& w) {
        const Vertex* const corner[3] = {&u, &v, &w};
        for (int k = 0; k < 3; ++k) {
          const RasterPosition& from = corner[k]->position;
          const RasterPosition& to = corner[(k + 1) % 3]->position;
          if (from.x == -16384 && to.x == -16384) result.insert(std::minmax(from.y, to.y));
        }
      };
      split_triangle(p, q, c, emit);
      return result;
    };
    const Pieces one = pieces(a, b);
    const Pieces other = pieces(b, a);
    different += one == other ? 0 : 1;
    cut += one.size() > 1 ? 1 : 0;
  }
  CHECK(different == 0);
  CHECK(cut > 5000);
}

TEST_CASE("a triangle that reaches beyond the guard band is refused") {
  const auto vertex = [](int x, int y) {
    return Vertex{{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), 1000}, {}};
  };
  TriangleCommand<Method> command;
  const RowRange rows{-1024, 1024};
  CHECK(prepare_triangle({}, vertex(-16384, -16384), vertex(16383, -16384), vertex(0, 16383), {}, rows,
                         command));
  for (const int beyond : {-32768, -16385, 16384, 32767}) {
    CHECK_FALSE(prepare_triangle({}, vertex(beyond, 0), vertex(0, 100), vertex(100, 0), {}, rows, command));
    CHECK_FALSE(prepare_triangle({}, vertex(0, 0), vertex(0, beyond), vertex(100, 0), {}, rows, command));
  }
}
