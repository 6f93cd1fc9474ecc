// SPDX-License-Identifier: MIT
// Lower bounds of a highlight's distance over a triangle.
#include <arcspan/lighting/illumination.hpp>
#include <arcspan/literature/highlights_over.hpp>
#include <arcspan/shading/surface/chords.hpp>

#include <catch2/catch.hpp>
#include <tests/support/test_share.hpp>
#include <tests/support/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace arcspan;
using namespace arcspan::test;

namespace {

struct Normals {
  Vec3 middle;
  std::array<Vec3, 3> around;  ///< within a random angle of `middle`
};
Normals random_normals(Random& random, double most_degrees) {
  Normals normals{random_unit(random), {}};
  const double widest = radians(random.real(5, most_degrees));
  for (Vec3& normal : normals.around) normal = tilted(random, normals.middle, random.real(0, 1) * widest);
  return normals;
}

}  // namespace

namespace {

/// Random triangles by all lights of `Lit`: no normal has a highlight that is nearer, or of which the sum of
/// slopes is larger, than highlights_over() says. Returns the percentage whose slopes are below three
/// quarters.
template <class Lit>
int check_highlights_over(std::uint64_t seed, int triangles) {
  constexpr std::size_t kLights = Lit::kLights;
  Random random(seed);
  int faint = 0;
  for (int i = 0; i < share_of(triangles); ++i) {
    const auto [middle, normals] = random_normals(random, 28);
    const Direction to_eye = to_direction(tilted(random, middle, random.real(0, 1.2)));
    std::array<DirectionalLight, kLights> lights;
    double weights = 0;
    for (DirectionalLight& light : lights) {
      light.towards = to_direction(tilted(random, middle, random.real(0, 1.6)));
      if (kLights > 1) light.strength = Coefficient::from_raw(random.integer(3000, 32768));
      if (Lit::kFeatures.coloured_lights) light.colour.r = light.colour.b = Coefficient::of(0.25);
      weights += light.strength.raw() * 0x1p-15;
    }
    Material material;
    material.shininess = random.chance(0.3) ? random.integer(1, 4) : random.integer(1, 64);
    Lit lit;
    REQUIRE(ok(Lit::make(material, lights, to_eye, lit)));
    std::array<typename Lit::Scalars, 3> at;
    std::array<Normal, 3> packed;
    for (std::size_t k = 0; k < 3; ++k) {
      at[k] = lit.scalars(to_direction(normals[k]));
      packed[k] = to_normal(to_direction(normals[k]));
    }
    const NormalChords chords{squared_chord(packed[0], packed[1]), squared_chord(packed[0], packed[2]),
                              squared_chord(packed[1], packed[2])};
    if (chords.widest() > std::uint32_t{1} << 28) continue;
    const HighlightBound bound =
        highlights_over(lit, at[0], at[1], at[2], chords.top_middle, chords.top_bottom, chords.middle_bottom);
    faint += bound.slope < 12 ? 1 : 0;
    for (int sample = 0; sample < 60; ++sample) {
      const double a = random.unit();
      const double b = random.unit() * (1 - a);
      const Vec3 n = normalised(a * normals[0] + b * normals[1] + (1 - a - b) * normals[2]);
      const Vec3 v = to_vec3(to_eye);
      double slopes = 0;
      for (const DirectionalLight& light : lights) {
        const Vec3 l = to_vec3(light.towards);
        if (dot(n, l) <= 0) continue;
        const double c = Lit::kModel == Highlight::kBlinn ? dot(n, normalised(l + v))
                                                          : 2 * dot(n, l) * dot(n, v) - dot(l, v);
        REQUIRE(bound.nearest * 0x1p-30 <= (1 - c) / 2 + 0x1p-20);
        if (c > 0) slopes += light.strength.raw() * 0x1p-15 * std::pow(c, material.shininess - 1);
      }
      if (bound.nearest >= lit.power().half_reach()) continue;
      REQUIRE(slopes / weights < (bound.slope + 1 + 0.02) / 16);
    }
  }
  return faint * 100 / share_of(triangles);
}

}  // namespace

TEST_CASE("no normal of a triangle has nearer or steeper highlights than the bound of all lights says") {
  CHECK(check_highlights_over<Illumination<1, Highlight::kPhong>>(52, 1500) > 33);
  CHECK(check_highlights_over<Illumination<2, Highlight::kPhong>>(54, 1500) > 33);
  CHECK(check_highlights_over<Illumination<3, Highlight::kPhong>>(55, 1500) > 33);
  CHECK(check_highlights_over<Illumination<1, Highlight::kBlinn>>(56, 1500) > 16);
  CHECK(check_highlights_over<Illumination<2, Highlight::kBlinn>>(57, 1500) > 16);
  constexpr IlluminationFeatures kColoured{.coloured_lights = true};
  CHECK(check_highlights_over<Illumination<2, Highlight::kPhong, kColoured>>(59, 500) > 30);
  CHECK(check_highlights_over<Illumination<3, Highlight::kBlinn, kColoured>>(60, 500) > 16);
}

namespace {

/// The largest product of `axis` and a unit vector on the arc between p and q.
double highest_on_arc(const Vec3& p, const Vec3& q, const Vec3& axis) {
  const double angle = std::acos(std::clamp(dot(p, q), -1.0, 1.0));
  const double along = (dot(axis, q) - dot(axis, p) * std::cos(angle)) / std::sin(angle);
  const double at = std::clamp(std::atan2(along, dot(axis, p)), 0.0, angle);
  return std::max({dot(axis, p), dot(axis, q), dot(axis, p) * std::cos(at) + along * std::sin(at)});
}

/// The largest product of `axis` and a unit vector in a triangle. It is that of a vector on the border,
/// unless the axis points through the triangle.
double highest_in_triangle(const std::array<Vec3, 3>& n, const Vec3& axis) {
  const double a = dot(cross(n[0], n[1]), axis);
  const double b = dot(cross(n[1], n[2]), axis);
  const double c = dot(cross(n[2], n[0]), axis);
  if ((a > 0) == (b > 0) && (b > 0) == (c > 0) && dot(n[0], axis) > 0) return 1;
  return std::max(
      {highest_on_arc(n[0], n[1], axis), highest_on_arc(n[1], n[2], axis), highest_on_arc(n[2], n[0], axis)});
}

}  // namespace

TEST_CASE(
    "no scalar of a triangle exceeds its bound, which is at most that of the vertices and the headroom") {
  Random random(58);
  int by_headroom = 0;
  constexpr int kTriangles = 20000;
  for (int i = 0; i < kTriangles; ++i) {
    const auto [middle, normals] = random_normals(random, 34);
    const Vec3 axis = tilted(random, middle, random.real(0, random.chance(0.5) ? 0.7 : 3.1));
    std::array<Cosine, 3> at;
    std::array<Normal, 3> packed;
    for (std::size_t k = 0; k < 3; ++k) {
      at[k] = dot(to_direction(normals[k]), to_direction(axis));
      packed[k] = to_normal(to_direction(normals[k]));
    }
    const NormalChords chords{squared_chord(packed[0], packed[1]), squared_chord(packed[0], packed[2]),
                              squared_chord(packed[1], packed[2])};
    if (chords.widest() > std::uint32_t{1} << 28) continue;
    const double bound = detail::highest_over(at[0], at[1], at[2], chords.widest()).raw() * 0x1p-30;
    const std::int32_t headroom = detail::cap_height(chords.widest()) + (1 << 18);
    const double rough = (std::max({at[0], at[1], at[2]}).raw() + headroom) * 0x1p-30;
    REQUIRE(bound <= rough);
    by_headroom += bound > rough - 0x1p-9 ? 1 : 0;
    REQUIRE(highest_in_triangle(normals, axis) < bound);
  }
  CAPTURE(by_headroom);
  CHECK(by_headroom < kTriangles / 2);
}

// In a build with sanitizers signed overflow would end the program.
TEST_CASE("the bounds of scalars and of highlights are defined for any scalars") {
  constexpr std::array<std::int32_t, 5> kValues{INT32_MIN, -1, 0, 1 << 30, INT32_MAX};
  for (const std::int32_t a : kValues) {
    for (const std::int32_t b : kValues) {
      for (const std::int32_t c : kValues) {
        const Cosine bound = detail::highest_over(Cosine::from_raw(a), Cosine::from_raw(b),
                                                  Cosine::from_raw(c), std::uint32_t{1} << 28);
        if (std::max({a, b, c}) <= 1 << 30) CHECK(bound.raw() > std::max({a, b, c}));
        const auto light_and_eye = [](std::int32_t x, std::int32_t y) {
          return std::array{Cosine::from_raw(x), Cosine::from_raw(y)};
        };
        const Illumination<1, Highlight::kPhong> lit{};
        (void)highlights_over(lit, light_and_eye(a, b), light_and_eye(b, a), light_and_eye(c, b),
                              std::uint32_t{1} << 28, std::uint32_t{1} << 28, std::uint32_t{1} << 28);
      }
    }
  }
}

TEST_CASE("the bound of a scalar is sharp where its maximum is inside of the triangle") {
  // The axis is the middle of an equilateral triangle, so that the scalar is 1 there.
  const Vec3 axis{0, 0, 1};
  for (const double degrees : {2.0, 6.0, 12.0, 20.0, 30.0}) {
    std::array<Cosine, 3> at;
    std::array<Normal, 3> packed;
    for (std::size_t k = 0; k < 3; ++k) {
      const double turn = radians(120.0 * static_cast<double>(k));
      const double tilt = radians(degrees);
      const Vec3 normal{std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt)};
      at[k] = dot(to_direction(normal), to_direction(axis));
      packed[k] = to_normal(to_direction(normal));
    }
    const double bound =
        detail::highest_over(at[0], at[1], at[2], squared_chord(packed[0], packed[1])).raw() * 0x1p-30;
    CHECK(bound >= 1);
    CHECK(bound < 1 + 0x1p-12 + 0.4 * std::pow(radians(degrees), 4) + 1e-4);
  }
}

namespace {

/// The unit vector at an angle from the x axis, about the z axis.
Vec3 at_degrees(double degrees) { return {std::cos(radians(degrees)), std::sin(radians(degrees)), 0}; }

/// One light along the x axis and the eye `degrees` away from it.
template <class Lit>
Lit lit_from_x(double degrees, std::int32_t shininess, Coefficient fade = {}) {
  Material material;
  material.shininess = shininess;
  material.highlight_fade = fade;
  Lit lit;
  REQUIRE(ok(Lit::make(material, {DirectionalLight{to_direction(at_degrees(0))}},
                       to_direction(at_degrees(degrees)), lit)));
  return lit;
}

}  // namespace

TEST_CASE("a highlight by N·H counts as if it were brightest where a vertex is hardly lit") {
  using Lit = Illumination<1, Highlight::kBlinn>;
  const auto lit = lit_from_x<Lit>(60, 2);
  const auto slope_at = [&lit](double degrees) {
    const Lit::Scalars at = lit.scalars(to_direction(at_degrees(degrees)));
    return highlights_over(lit, at, at, at, 0, 0, 0).slope;
  };
  CHECK(slope_at(90) < 1);  // out of the light
  CHECK(slope_at(89.8) == HighlightBound::kBrightest);
  CHECK(slope_at(89) < 9);
}

TEST_CASE("a highlight that may end in the triangle counts as if it were brightest") {
  // Light and eye are 140 degrees apart, so that R·V is 0.77 wherever N·L = 0.
  using Lit = Illumination<1, Highlight::kPhong>;
  const auto lit = lit_from_x<Lit>(140, 4);
  const auto bound_at = [&lit](double degrees) {
    const Vec3 middle = at_degrees(degrees);
    std::array<Lit::Scalars, 3> at;
    std::array<Normal, 3> packed;
    for (std::size_t k = 0; k < 3; ++k) {
      const double turn = radians(120.0 * static_cast<double>(k));
      const Vec3 normal = normalised(middle + 0.02 * std::cos(turn) * cross(middle, Vec3{0, 0, 1}) +
                                     0.02 * std::sin(turn) * Vec3{0, 0, 1});
      at[k] = lit.scalars(to_direction(normal));
      packed[k] = to_normal(to_direction(normal));
    }
    return highlights_over(lit, at[0], at[1], at[2], squared_chord(packed[0], packed[1]),
                           squared_chord(packed[0], packed[2]), squared_chord(packed[1], packed[2]));
  };
  CHECK(bound_at(90).slope == HighlightBound::kBrightest);
  CHECK(bound_at(86).slope < HighlightBound::kBrightest);
}

TEMPLATE_TEST_CASE("a highlight that may fade in the triangle counts as if it were brightest", "",
                   (Illumination<1, Highlight::kPhong, IlluminationFeatures{.fading_highlights = true}>),
                   (Illumination<1, Highlight::kBlinn, IlluminationFeatures{.fading_highlights = true}>)) {
  // Where N·L = 0, R·V is 0.17, whose power is out of reach.
  using Lit = TestType;
  const auto slope_with = [](Coefficient fade) {
    const auto lit = lit_from_x<Lit>(100, 8, fade);
    const typename Lit::Scalars at = lit.scalars(to_direction(at_degrees(65)));  // N·L = 0.42
    return highlights_over(lit, at, at, at, 0, 0, 0).slope;
  };
  CHECK(slope_with({}) < HighlightBound::kBrightest);
  CHECK(slope_with(Coefficient::of(0.5)) == HighlightBound::kBrightest);
}

TEST_CASE("limits of quadratic surfaces grow as highlights become faint, by the power 2/3 of the slope") {
  constexpr std::uint32_t kLimit = 10000000;
  for (std::uint8_t slope = 0; slope < 16; ++slope) {
    const double exact = kLimit * std::pow(16.0 / (slope + 1), 2.0 / 3);
    CHECK(limit_at_slope(kLimit, slope) <= exact + 1);
    CHECK(limit_at_slope(kLimit, slope) > exact * 0.93);
  }
}
