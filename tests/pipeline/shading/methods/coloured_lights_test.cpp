// SPDX-License-Identifier: MIT
// Arc chooses orders by bounds of the light. They hold for coloured lights and for highlights that fade, too:
// it stays within its tolerance.
#include <arcspan/shading/surface/arc.hpp>

#include <catch2/catch.hpp>
#include <tests/support/test_share.hpp>
#include <tests/support/triangle_picture.hpp>

#include <algorithm>
#include <array>
#include <tuple>

using namespace arcspan;
using namespace arcspan::test;

namespace {

constexpr std::int32_t kSize = 128;
constexpr IlluminationFeatures kAll{.coloured_lights = true, .fading_highlights = true};
using Lits = std::tuple<Illumination<1, Highlight::kPhong, kAll>, Illumination<1, Highlight::kBlinn, kAll>,
                        Illumination<2, Highlight::kBlinn, kAll>>;

/// Lights of any colour, most of them low over the surface, where highlights fade; the eye is near the first
/// one's reflection.
template <class Lit>
Lit random_lit(Random& random, const Direction& near) {
  const auto share = [&random](double most) {
    return Coefficient::from_raw(static_cast<std::int32_t>(random.real(0, most) * 32768));
  };
  // Colours that may be clamped have short segments, so that half of them may not.
  const double most = random.chance(0.5) ? 1 : 0.45;
  Material material;
  material.diffuse = {share(most), share(most), share(most)};
  material.specular = {share(most), share(most), share(most)};
  material.shininess = static_cast<std::int32_t>(random.decades(1, 12));
  material.highlight_fade = Coefficient::from_raw(random.integer(1024, 16384));
  std::array<DirectionalLight, Lit::kLights> lights;
  for (DirectionalLight& light : lights) {
    light.towards = to_direction(tilted(random, to_vec3(near), radians(random.real(40, 95))));
    light.strength = Coefficient::from_raw(static_cast<std::int32_t>(32768 / Lit::kLights));
    light.colour = {share(1), share(1), share(1)};
  }
  Lit lit;
  const Vec3 normal = to_vec3(near);
  const Vec3 light = to_vec3(lights[0].towards);
  const Vec3 eye = tilted(random, 2 * dot(normal, light) * normal - light, random.real(0, 0.6));
  REQUIRE(ok(Lit::make(material, lights, to_direction(normalised(eye)), lit)));
  return lit;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("Arc stays within its tolerance, coloured and fading", "", Lits) {
  Random random(197);
  constexpr std::int32_t kTolerance = 1;
  int most = 0;
  for (int i = 0; i < share_of(3000); ++i) {
    const ScreenTriangle triangle = random_screen_triangle(random, kSize, random.decades(4, 30));
    const TestType lit = random_lit<TestType>(random, triangle.normals[0]);
    TestType lighting = lit;
    REQUIRE(ok(lighting.set_tolerance(kTolerance)));
    const int off = most_different(picture_of<Arc<TestType>>(triangle, lit, kSize),
                                   picture_of<Arc<TestType>>(triangle, lighting, kSize));
    if (off > most) UNSCOPED_INFO("triangle " << i << " is off by " << off);
    most = std::max(most, off);
  }
  // Both pictures are rounded, and that without tolerance is off, too.
  CHECK(most <= kTolerance + 2);
}
