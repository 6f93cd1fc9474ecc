// SPDX-License-Identifier: MIT
// Adaptive's highlights by a distance of their own (decision 7): when they are taken, and how far off they
// are.
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/adaptive/adaptive.hpp>

#include <catch2/catch.hpp>
#include <tests/support/illumination_oracle.hpp>
#include <tests/support/method_accuracy.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Lit = Illumination<1, Highlight::kPhong>;
using Lighting = AdaptiveIllumination<Lit>;
using Method = Adaptive<Lit>;

Material shiny_material(Coefficient specular) {
  Material material;
  material.diffuse = {Coefficient::of(0.4), Coefficient::of(0.4), Coefficient::of(0.4)};
  material.specular = {specular, specular, specular};
  return material;
}
Lit shiny_light(std::int32_t shininess, const Vec3& towards, const Vec3& to_eye, Coefficient specular) {
  Material material = shiny_material(specular);
  material.shininess = shininess;
  Lit lit;
  REQUIRE(ok(Lit::make(material, {DirectionalLight{to_direction(towards)}}, to_direction(to_eye), lit)));
  return lit;
}
/// A light with a specular coefficient of 0.5. clang 14 rejects Coefficient::of(), which is consteval, as a
/// default argument, so this is an overload.
Lit shiny_light(std::int32_t shininess, const Vec3& towards, const Vec3& to_eye) {
  return shiny_light(shininess, towards, to_eye, Coefficient::of(0.5));
}

/// A triangle of some 20 pixels whose normals lean outwards from `middle` by `degrees` each.
struct Triangle {
  std::array<RasterVertex<Method>, 3> corners;
  Triangle(const Lighting& lighting, const Vec3& middle, double degrees) {
    const Vec3 one = orthogonal(middle);
    const Vec3 other = cross(middle, one);
    constexpr std::array<std::array<int, 2>, 3> kPlaces{{{-160, 150}, {170, 140}, {10, -180}}};
    for (std::size_t i = 0; i < 3; ++i) {
      const double turn = radians(120.0 * static_cast<double>(i));
      const double lean = radians(degrees);
      const Vec3 outwards = std::cos(turn) * one + std::sin(turn) * other;
      const Vec3 normal = std::cos(lean) * middle + std::sin(lean) * outwards;
      corners[i].position = {static_cast<std::int16_t>(kPlaces[i][0]),
                             static_cast<std::int16_t>(kPlaces[i][1]), 1000};
      corners[i].shade = Method::shade_vertex(lighting, to_direction(normal));
    }
  }
  static Vec3 orthogonal(const Vec3& v) {
    return normalised(cross(v, std::abs(v.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
  }
};

Method::Prepared prepared_shade(const Lighting& lighting, const Triangle& t) {
  TriangleCommand<Method> command;
  REQUIRE(
      prepare_triangle<Method>(lighting, t.corners[0], t.corners[1], t.corners[2], {}, {-80, 80}, command));
  return command.shade;
}

bool takes_highlight_patch(const Lighting& lighting, const Triangle& t) {
  return prepared_shade(lighting, t).highlight_path == HighlightPath::kDistance;
}
bool takes_linear_diffuse(const Lighting& lighting, const Triangle& t) {
  return takes_highlight_patch(lighting, t) && prepared_shade(lighting, t).linear_diffuse;
}

}  // namespace

TEST_CASE(
    "a small triangle in a highlight takes the highlight's own distance, within the tolerance's limit") {
  const Vec3 middle{0, 0, 1};
  const Vec3 towards = normalised(Vec3{0.3, 0.1, 1});
  const Vec3 to_eye = normalised(Vec3{-0.3, -0.1, 1});
  Lighting lighting(shiny_light(16, towards, to_eye));
  CHECK(takes_highlight_patch(lighting, Triangle(lighting, middle, 4)));
  REQUIRE(ok(lighting.set_tolerance(0)));
  CHECK_FALSE(takes_highlight_patch(lighting, Triangle(lighting, middle, 4)));
  REQUIRE(ok(lighting.set_tolerance(1)));
  CHECK_FALSE(takes_highlight_patch(lighting, Triangle(lighting, middle, 12)));  // no patch either
  Lighting sharp(shiny_light(65, towards, to_eye));
  CHECK_FALSE(takes_highlight_patch(sharp, Triangle(sharp, middle, 4)));
  // The light's horizon runs through the triangle.
  Lighting grazing(shiny_light(1, normalised(Vec3{1, 0, 0.02}), normalised(Vec3{-1, 0, 0.5})));
  CHECK_FALSE(takes_highlight_patch(grazing, Triangle(grazing, middle, 4)));
}

TEST_CASE("under a highlight N.L is linear if both errors together are within the tolerance") {
  const Vec3 middle{0, 0, 1};
  const Vec3 towards = normalised(Vec3{0.3, 0.1, 1});
  Lighting lighting(shiny_light(16, towards, normalised(Vec3{-0.3, -0.1, 1})));
  CHECK(takes_linear_diffuse(lighting, Triangle(lighting, middle, 4)));
  CHECK(takes_highlight_patch(lighting, Triangle(lighting, middle, 9)));
  CHECK_FALSE(takes_linear_diffuse(lighting, Triangle(lighting, middle, 9)));
  // A patch as wide as its limit, here below 16 degrees, uses all of the tolerance.
  Lighting sharp(shiny_light(64, towards, {0, 0, 1}));
  const std::uint32_t limit = sharp.highlight_patch_limit();
  CHECK(sharp.linear_limit_with_highlight(limit) <= sharp.linear_limit_with_highlight(0) >> 12);
  CHECK(sharp.linear_limit_with_highlight(limit / 2) < sharp.linear_limit_with_highlight(limit / 4));
  // Beyond that limit nothing is left.
  const Lighting bright(shiny_light(64, towards, {0, 0, 1}, Coefficient::of(1)));
  for (std::uint32_t chord = bright.highlight_patch_limit(); chord < 20797469; chord += limit / 16)
    CHECK(bright.linear_limit_with_highlight(chord) <= bright.linear_limit_with_highlight(0) >> 12);
  REQUIRE(ok(sharp.set_tolerance(0)));
  CHECK(sharp.linear_limit_with_highlight(0) == 0);
}

namespace {

/// The limit of the least exponents, squared chord with 28 fraction bits: 28.1 degrees.
constexpr std::uint32_t kWidestDistance = 63165604;

}  // namespace

TEST_CASE("the limit of a highlight's own distance falls with the exponent and grows with the tolerance") {
  const Vec3 towards = normalised(Vec3{0.3, 0.1, 1});
  std::uint32_t last = UINT32_MAX;
  for (std::int32_t n = 1; n <= 64; n *= 2) {
    INFO("n = " << n);
    Lighting lighting(shiny_light(n, towards, {0, 0, 1}));
    const std::uint32_t limit = lighting.highlight_patch_limit();
    REQUIRE(ok(lighting.set_tolerance(2)));
    const std::uint32_t of_two_steps = lighting.highlight_patch_limit();
    CHECK((limit < last || limit == kWidestDistance));
    CHECK((of_two_steps > limit || limit == kWidestDistance));
    last = limit;
  }
  CHECK(last < kWidestDistance / 2);
}

namespace {

/// f through three corners and the middles of the edges, at barycentric coordinates.
struct Surface {
  std::array<double, 3> corner;
  std::array<double, 3> rise;  ///< of the edges 01, 12, 20
  [[nodiscard]] double at(const std::array<double, 3>& l) const {
    return corner[0] * l[0] + corner[1] * l[1] + corner[2] * l[2] + rise[0] * l[0] * l[1] +
           rise[1] * l[1] * l[2] + rise[2] * l[2] * l[0];
  }
};
template <class F>
Surface surface(const std::array<Vec3, 3>& normals, const F& f) {
  Surface s{};
  for (std::size_t i = 0; i < 3; ++i) s.corner[i] = f(normals[i]);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 middle = normalised(normals[i] + normals[(i + 1) % 3]);
    s.rise[i] = 4 * f(middle) - 2 * (s.corner[i] + s.corner[(i + 1) % 3]);
  }
  return s;
}

/// Draws a triangle with these widest normals, and directions of light and eye, and returns the largest
/// difference between the two ways to a highlight as a part of the full highlight.
double random_difference(Random& random, std::int32_t n, double widest) {
  const Vec3 middle = random_unit(random);
  std::array<Vec3, 3> normals;
  for (Vec3& normal : normals) normal = tilted(random, middle, random.real(0.2, 1) * widest);
  double wide = 0;
  for (std::size_t i = 0; i < 3; ++i) wide = std::max(wide, length(normals[i] - normals[(i + 1) % 3]));
  const double scale = widest / wide;  // make the widest chord what was asked for
  for (Vec3& normal : normals) normal = normalised(middle + scale * (normal - middle));
  const Vec3 light = tilted(random, middle, random.real(0, 1.4));
  const Vec3 eye = tilted(random, normalised((2 * dot(middle, light)) * middle - light), random.real(0, 0.6));
  const double along = dot(light, eye);
  const Surface nl = surface(normals, [&](const Vec3& v) { return dot(v, light); });
  const Surface nv = surface(normals, [&](const Vec3& v) { return dot(v, eye); });
  const Surface rv = surface(normals, [&](const Vec3& v) { return 2 * dot(v, light) * dot(v, eye) - along; });
  double most = 0;
  for (int i = 0; i <= 16; ++i) {
    for (int j = 0; i + j <= 16; ++j) {
      const std::array<double, 3> l{i / 16.0, j / 16.0, (16 - i - j) / 16.0};
      const double product = 2 * nl.at(l) * nv.at(l) - along;
      const auto power = [n](double c) { return std::pow(std::clamp(c, 0.0, 1.0), n); };
      most = std::max(most, std::abs(power(product) - power(rv.at(l))));
    }
  }
  return most;
}

}  // namespace

TEST_CASE(
    "in triangles as wide as the limit, a highlight's own distance is within the tolerance of the product") {
  Random random(5);
  for (std::int32_t n = 1; n <= 64; n *= 2) {
    for (const std::int32_t tolerance : {1, 2}) {
      Lighting lighting(shiny_light(n, {0, 0, 1}, {0, 0, 1}));
      REQUIRE(ok(lighting.set_tolerance(tolerance)));
      // Beyond twice widest_patch() no triangle is a patch (is_accurate_patch()).
      const std::uint32_t limit = std::min(lighting.highlight_patch_limit(), 2 * lighting.widest_patch());
      const double widest = std::sqrt(std::ldexp(limit, -28));
      double most = 0;
      for (int i = 0; i < share_of(1500); ++i) most = std::max(most, random_difference(random, n, widest));
      INFO("n = " << n << ", tolerance " << tolerance);
      CHECK(most * 0.5 * 255 <= tolerance);
      if (limit == lighting.highlight_patch_limit() && limit != kWidestDistance)
        CHECK(most * 0.5 * 255 > 0.3 * tolerance);  // nor far below
    }
  }
}

TEST_CASE("beyond that limit, as far as patches go, highlights by R.V are computed from their factors") {
  const Vec3 middle{0, 0, 1};
  const Vec3 towards = normalised(Vec3{0.3, 0.1, 1});
  const Vec3 to_eye = normalised(Vec3{-0.3, -0.1, 1});
  const auto is_product = [&](const Lighting& lighting, double degrees) {
    return prepared_shade(lighting, Triangle(lighting, middle, degrees)).highlight_path ==
           HighlightPath::kProduct;
  };
  Lighting lighting(shiny_light(8, towards, to_eye));
  CHECK_FALSE(is_product(lighting, 9));
  CHECK(is_product(lighting, 12.5));
  CHECK_FALSE(is_product(lighting, 18));  // no patch
  REQUIRE(ok(lighting.set_tolerance(0)));
  CHECK_FALSE(is_product(lighting, 12.5));
  CHECK_FALSE(is_product(shiny_light(65, towards, to_eye), 4));
  // The light's horizon runs through the triangle.
  CHECK_FALSE(is_product(shiny_light(2, normalised(Vec3{1, 0, 0.02}), normalised(Vec3{-1, 0, 0.5})), 12.5));
}
