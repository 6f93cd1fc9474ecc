// SPDX-License-Identifier: MIT
// N·L of small triangles that are patches although their normals are 33 to 60 degrees apart, against bilinear
// SLERP in double precision.
#include <arcspan/lighting/illumination.hpp>
#include <arcspan/shading/arc/arc.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/slerp_oracle.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Light = Illumination<1, Highlight::kPhong>;
using Method = Arc<Light>;
using Small = Method::Small;

struct Triangle {
  std::array<RasterVertex<Method>, 3> vertices;
  std::array<Direction, 3> normals;
};

/// The integers of a patch add this much to its error: Directions and coordinates have 15 fraction bits.
constexpr double kRounding = 0x1p-12;

struct Figures {
  int triangles = 0;
  int refused = 0;       ///< triangles
  int above_bound = 0;   ///< pixels
  double used = 0;       ///< the largest error of a pixel, divided by the bound
  int wrong_bounds = 0;  ///< triangles
};

/// Normals equally far from each other, with the light between them. In the middle of the triangle N·L of the
/// patch is much too small.
std::array<Vec3, 3> normals_about(Random& random, Vec3 towards_light) {
  const Vec3 middle = tilted(random, towards_light, radians(random.real(0, 5)));
  const double radius = std::asin(2 / std::sqrt(3.0) * std::sin(radians(random.real(17, 29.95))));
  const Vec3 side = tilted(random, middle, radians(90));
  const Vec3 other = cross(middle, side);
  const auto normal = [&](double turn) {
    return std::cos(radius) * middle +
           std::sin(radius) * (std::cos(radians(turn)) * side + std::sin(radians(turn)) * other);
  };
  return {normal(0), normal(120), normal(240)};
}
/// Two normals that are hardly lit and far apart, and a dark one near the first. Between the second and the
/// others N·L of the patch is much too large.
std::array<Vec3, 3> normals_at_terminator(Random& random, Vec3 towards_light) {
  const Vec3 side = tilted(random, towards_light, radians(90));
  const Vec3 other = cross(towards_light, side);
  const auto normal = [&](double normal_light, double turn) {
    return normal_light * towards_light +
           std::sqrt(1 - normal_light * normal_light) * (std::cos(turn) * side + std::sin(turn) * other);
  };
  const double lit = random.real(0.02, 0.1);
  const double apart = radians(random.chance(0.5) ? random.real(56, 59.5) : random.real(33, 60));
  return {normal(lit, 0), normal(-lit * random.real(2, 3.5), 0), normal(lit, apart)};
}
std::array<Vec3, 3> random_normals(Random& random, Vec3 towards_light) {
  const int kind = random.integer(0, 3);
  if (kind == 0) return normals_about(random, towards_light);
  if (kind == 1) return normals_at_terminator(random, towards_light);
  const Vec3 a = tilted(random, towards_light, radians(random.real(0, 110)));
  const double angle = radians(random.real(33, 60));
  return {a, tilted(random, a, angle), tilted(random, a, angle * std::sqrt(random.unit()))};
}

Triangle random_triangle(Random& random, const Light& light, Vec3 towards_light) {
  const std::array<Vec3, 3> normals = random_normals(random, towards_light);
  const std::int32_t half_size = 8 * kSmallSize;
  Triangle t;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const auto coordinate = [&] { return static_cast<std::int16_t>(random.integer(-half_size, half_size)); };
    t.normals[i] = to_direction(normals[i]);
    t.vertices[i] = {{coordinate(), coordinate(), 0}, Method::shade_vertex(light, t.normals[i])};
  }
  return t;
}

/// The bound of decision 26, 1.57 times the estimate by which patches are chosen; `s` is the widest squared
/// chord.
double documented_bound(const Triangle& t, double s) {
  constexpr double kOfRange = 1.57 * 0.022;
  constexpr double kOfLargest = 1.57 * 0.0073;
  const auto light_at = [&t](std::size_t i) { return to_double(t.vertices[i].shade.scalars[0]); };
  const auto [least, most] = std::minmax({light_at(0), light_at(1), light_at(2)});
  return kOfRange * s * (most - least) + kOfLargest * s * s * most;
}

/// Bilinear SLERP over the triangle.
TriangleOracle oracle_of(const Triangle& t) {
  const auto corner = [&t](std::size_t i) {
    const RasterPosition& p = t.vertices[i].position;
    return TriangleOracle::Corner{{p.x, p.y}, normalised(to_vec3(t.normals[i]))};
  };
  return {corner(0), corner(1), corner(2)};
}

/// Draws N·L of a triangle and compares it with the oracle's. Negative N·L counts as 0, as in the ramp.
void compare_pixels(const Small& small, const SmallTriangle& triangle, const TriangleOracle& oracle,
                    Vec3 towards_light, double bound, Figures& figures) {
  (void)small.walk([&](const auto& surface) {
    for (std::int32_t row = 0; row < triangle.rows; ++row) {
      const SmallSpan span = triangle.spans[row];
      if (span.count == 0) continue;
      const TriangleOracle::Row truths = oracle.row(triangle.row + row);
      auto run =
          surface.row((triangle.row + row) * 16 + 8, triangle.coordinate(triangle.of_middle(span.first, row)),
                      triangle.coordinate(triangle.of_bottom(span.first, row)));
      for (std::int32_t x = span.first; x < span.first + span.count; ++x, run.next()) {
        if constexpr (requires { run.scalars(); }) {
          const double drawn = std::max(to_double(run.scalars()[0]), 0.0);
          const double truth = std::max(dot(truths.at(x), towards_light), 0.0);
          const double error = std::abs(drawn - truth) - kRounding;
          figures.above_bound += error > bound ? 1 : 0;
          figures.used = std::max(figures.used, error / bound);
        } else {
          ++figures.above_bound;  // drawn as an arc
        }
      }
    }
    return Status::kOk;
  });
}

void measure(const Triangle& t, const Light& light, Vec3 towards_light, Figures& figures) {
  const auto& v = t.vertices;
  const std::int32_t area = doubled_area(v[0].position, v[1].position, v[2].position);
  SortedVertices<Method> sorted{&v[0], &v[1], &v[2], area < 0};
  arcspan::detail::sort_by_height(sorted);
  const RasterVertex<Method>& a = *sorted.top;
  const RasterVertex<Method>& b = *sorted.middle;
  const RasterVertex<Method>& c = *sorted.bottom;
  const TriangleChords chords = chords_between(a.shade.normal, b.shade.normal, c.shade.normal);
  const std::uint32_t widest = chords.widest();
  SmallTriangle triangle;
  Small small;
  if (area == 0 || !is_small(sorted) || widest <= kWidestDiffusePatch || widest > kWidestArc ||
      !cover_small_triangle(a.position, b.position, c.position, sorted.middle_left, {-100, 100}, triangle) ||
      small.prepare_dark(a.shade.scalars, b.shade.scalars, c.shade.scalars)) {
    return;
  }
  prepare_small_triangle(a.position, b.position, c.position, triangle);
  const SmallCorners corners{a, b, c};
  double bound = 0;
  const auto diffuse = Small::diffuse_of(light, corners, widest, false, [&bound](std::uint32_t error) {
    bound = 1.57 * std::ldexp(error, -20);
    return true;
  });
  if (!small.prepare(light, corners, chords, false, diffuse, triangle)) {
    ++figures.refused;
    return;
  }
  const double documented = documented_bound(t, std::ldexp(widest, -28));
  figures.wrong_bounds += std::abs(bound - documented) > 0.004 * documented + 0x1p-16 ? 1 : 0;
  compare_pixels(small, triangle, oracle_of(t), towards_light, bound, figures);
  ++figures.triangles;
}

}  // namespace

TEST_CASE("N·L of a small triangle wider than 33 degrees differs from bilinear SLERP by at most its bound") {
  Random random(181);
  const Direction direction = normalised(3, -4, 5);
  const Vec3 towards_light = normalised(to_vec3(direction));
  Light light;
  REQUIRE(ok(Light::make({}, {DirectionalLight{direction}}, normalised(0, 0, 1), light)));
  Figures figures;
  for (int i = 0; i < share_of(20000); ++i) {
    measure(random_triangle(random, light, towards_light), light, towards_light, figures);
  }
  INFO("the largest error is " << figures.used << " of the bound");
  CHECK(figures.above_bound == 0);
  CHECK(figures.used > 0.6);
  CHECK(figures.wrong_bounds == 0);
  CHECK(figures.refused == 0);
  CHECK(figures.triangles > share_of(8000));
}
