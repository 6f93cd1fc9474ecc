// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <tests/support/surface_accuracy.hpp>
#include <tests/support/test_share.hpp>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Light = Illumination<1, Highlight::kPhong>;
using Vertex = SurfaceVertex<2>;

/// The squared chord of an angle, 28 fraction bits.
std::uint32_t chord_of(double angle) {
  const double chord = 2 * std::sin(radians(angle) / 2);
  return static_cast<std::uint32_t>(std::lround(chord * chord * (1 << 28)));
}

/// White matt light from the front; highlights of n = 16 where the eye is in front, too.
Light make_light(Vec3 to_eye, double specular, std::int32_t tolerance) {
  const Coefficient height = Coefficient::from_raw(static_cast<std::int32_t>(32768 * specular));
  const Coefficient full = Coefficient::of(1.0);
  const Material material{{}, {full, full, full}, {height, height, height}, 16};
  Light light;
  REQUIRE(
      ok(Light::make(material, {DirectionalLight{to_direction({0, 0, 1})}}, to_direction(to_eye), light)));
  REQUIRE(ok(light.set_tolerance(tolerance)));
  return light;
}

constexpr Vec3 kFront{0, 0, 1};
constexpr Vec3 kAside{0, 1, 0};  ///< no highlight at the front

/// Three normals around `middle`, `angle` apart from each other.
std::array<Vec3, 3> equilateral(double angle, Vec3 middle = kFront) {
  const double radius = std::asin(2 * std::sin(radians(angle) / 2) / std::sqrt(3.0));
  const Vec3 side = normalised(cross(middle, std::abs(middle.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
  const Vec3 other = cross(middle, side);
  std::array<Vec3, 3> normals;
  for (std::size_t i = 0; i < 3; ++i) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(i) / 3;
    normals[i] =
        std::cos(radius) * middle + std::sin(radius) * (std::cos(turn) * side + std::sin(turn) * other);
  }
  return normals;
}

SurfaceChoice choice_of(const Light& light, const std::array<Vec3, 3>& normals, bool may_bend = true) {
  std::array<Vertex, 3> v;
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] = Arc<Light>::shade_vertex(light, to_direction(normals[i]));
  }
  return choose_order(light, v[0], v[1], v[2], may_bend);
}
SurfaceOrder order_of(const Light& light, const std::array<Vec3, 3>& normals, bool may_bend = true) {
  return choice_of(light, normals, may_bend).order;
}

/// The widest angle of an equilateral triangle that is drawn by an order of at most `order`.
double widest(const Light& light, SurfaceOrder order) {
  double angle = 0;
  while (angle < 90 && order_of(light, equilateral(angle + 0.05)) <= order) angle += 0.05;
  return angle;
}

}  // namespace

TEST_CASE("without highlight and tolerance triangles are linear up to 5.5 degrees and quadratic up to 17.8") {
  const Light light = make_light(kAside, 0, 0);
  // s/12 of full light is 6/32 of an 8-bit step.
  CHECK(widest(light, SurfaceOrder::kLinear) ==
        Approx(degrees(std::sqrt(12 * 6 / (32 * 255.0)))).margin(0.2));
  CHECK(widest(light, SurfaceOrder::kQuadratic) == Approx(17.8).margin(0.1));
}

TEST_CASE("with a tolerance orders without highlight reach as far as their errors allow") {
  // The error of planes grows with the square of the angle, that of quadratic surfaces with the cube.
  const Light light = make_light(kAside, 0, 1);
  const double more = (32 + 6) / 6.0;
  CHECK(widest(light, SurfaceOrder::kLinear) ==
        Approx(degrees(std::sqrt(12 * 6 * more / (32 * 255.0)))).margin(0.3));
  CHECK(widest(light, SurfaceOrder::kQuadratic) == Approx(17.8 * std::cbrt(more)).margin(0.7));
  CHECK(widest(make_light(kAside, 0, 64), SurfaceOrder::kQuadratic) == Approx(60).margin(0.2));
}

TEST_CASE("the highlight needs a better order than N·L") {
  for (const std::int32_t tolerance : {0, 1, 4}) {
    const Light with = make_light(kFront, 1, tolerance);
    const Light without = make_light(kFront, 0, tolerance);
    CAPTURE(tolerance);
    CHECK(widest(with, SurfaceOrder::kLinear) < widest(without, SurfaceOrder::kLinear));
    CHECK(widest(with, SurfaceOrder::kQuadratic) < widest(without, SurfaceOrder::kQuadratic));
    CHECK(choice_of(with, equilateral(10)).light.reach == LightReach::kHighlight);
    CHECK(choice_of(without, equilateral(10)).light.reach == LightReach::kDiffuse);
    CHECK(choice_of(make_light(kAside, 1, tolerance), equilateral(10)).light.reach == LightReach::kDiffuse);
  }
}

TEST_CASE("a larger tolerance never needs a better order or more of the light") {
  Random random(1);
  for (int i = 0; i < share_of(3000); ++i) {
    const Vec3 middle = random_unit(random);
    const double angle = random.real(0, 70);
    std::array<Vec3, 3> normals;
    for (Vec3& n : normals) n = tilted(random, middle, radians(random.real(0, 0.5) * angle));
    const Vec3 eye = tilted(random, kFront, radians(random.real(0, 90)));
    const double specular = random.unit();
    SurfaceChoice last = choice_of(make_light(eye, specular, 0), normals);
    for (const std::int32_t tolerance : {1, 2, 5, 16, 64}) {
      const SurfaceChoice next = choice_of(make_light(eye, specular, tolerance), normals);
      REQUIRE(next.order <= last.order);
      REQUIRE(next.light.reach <= last.light.reach);
      last = next;
    }
  }
}

TEST_CASE("triangles that no light reaches are linear and dark, whatever their normals, cut or not") {
  const Light light = make_light(kFront, 1, 0);
  for (const double angle : {5.0, 40.0, 80.0}) {
    const SurfaceChoice choice = choice_of(light, equilateral(angle, {0, 0, -1}));
    CHECK(choice.order == SurfaceOrder::kLinear);
    CHECK(choice.light.reach == LightReach::kNone);
  }
  const Vertex behind = Arc<Light>::shade_vertex(light, to_direction({0, 0, -1}));
  const Vertex cut =
      on_chord(behind, Arc<Light>::shade_vertex(light, to_direction({1, 0, 0})), Factor::of(0.5));
  CHECK(choose_order(light, behind, behind, cut, true).light.reach == LightReach::kNone);
}

TEST_CASE("cut triangles and those beyond 60 degrees are normalised with any tolerance") {
  for (const std::int32_t tolerance : {0, 1, 64}) {
    const Light light = make_light(kFront, 1, tolerance);
    CHECK(order_of(light, equilateral(60.5)) == SurfaceOrder::kNormalised);
    CHECK(choice_of(light, equilateral(60.5)).light.reach == LightReach::kHighlight);
    const Vertex a = Arc<Light>::shade_vertex(light, to_direction(equilateral(2)[0]));
    const Vertex b = Arc<Light>::shade_vertex(light, to_direction(equilateral(2)[1]));
    const Vertex cut = on_chord(a, b, Factor::of(0.5));
    REQUIRE(cut.deficit != 0);
    CHECK(choose_order(light, a, b, cut, true).order == SurfaceOrder::kNormalised);
  }
}

TEST_CASE("without quadratic surfaces those triangles are normalised") {
  const Light light = make_light(kAside, 0, 0);
  CHECK(order_of(light, equilateral(3), false) == SurfaceOrder::kLinear);
  CHECK(order_of(light, equilateral(10), false) == SurfaceOrder::kNormalised);
}

TEST_CASE("quadratic surfaces of triangles with a right angle are wider than equilateral ones") {
  const auto accurate = [](double a, double b, double c) {
    const std::array<std::uint32_t, 3> s{chord_of(a), chord_of(b), chord_of(c)};
    const std::uint32_t limit = chord_of(17);
    const bool found = is_accurate_quadratic({s[0], s[1], s[2]}, limit);
    CHECK(is_accurate_quadratic({s[2], s[0], s[1]}, limit) == found);
    CHECK(is_accurate_quadratic({s[1], s[2], s[0]}, limit) == found);
    return found;
  };
  CHECK(accurate(16.9, 16.9, 16.9));
  CHECK(!accurate(17.2, 17.2, 17.2));
  CHECK(accurate(14.9, 14.9, 21));   // a right angle
  CHECK(!accurate(15.9, 15.9, 21));  // sharper
  CHECK(!accurate(11, 11, 22));      // one great circle
  CHECK(!accurate(26, 26, 36));
}

TEST_CASE(
    "quadratic surfaces have the sagitta of the arc, 4 (1 / cos(psi/2) - 1), within 3e-4 up to 33 degrees") {
  for (double angle = 0; angle <= 33; angle += 0.25) {
    CAPTURE(angle);
    CHECK(sagitta_factor(chord_of(angle)) * 0x1p-18 ==
          Approx(4 * (1 / std::cos(radians(angle) / 2) - 1)).margin(3e-4));
  }
}
