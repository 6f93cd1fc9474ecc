// SPDX-License-Identifier: MIT
// Adaptive chooses among its paths by bounds of the light. They hold for coloured lights and for highlights
// that fade, too: it stays within its tolerance of arc.
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb888.hpp>
#include <arcspan/shading/adaptive/adaptive.hpp>

#include <catch2/catch.hpp>
#include <tests/support/illumination_oracle.hpp>
#include <tests/support/method_accuracy.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

constexpr std::int32_t kSize = 128;
constexpr IlluminationFeatures kAll{.coloured_lights = true, .fading_highlights = true};

struct Picture {
  std::vector<Rgb888::Word> memory = std::vector<Rgb888::Word>(hal::Framebuffer<Rgb888>::words(kSize, kSize));
  hal::Framebuffer<Rgb888> frame{memory, kSize, kSize};
};

struct Triangle {
  std::array<RasterPosition, 3> points{};
  std::array<Direction, 3> normals{};
};

Triangle random_triangle(Random& random, double degrees) {
  constexpr std::int32_t kEdge = (kSize / 2) << Subpixel::kFraction;
  Triangle triangle;
  const Vec3 middle = random_unit(random);
  for (std::size_t i = 0; i < 3; ++i) {
    triangle.points[i].x = static_cast<std::int16_t>(random.integer(-kEdge, kEdge));
    triangle.points[i].y = static_cast<std::int16_t>(random.integer(-kEdge, kEdge));
    triangle.points[i].z = 1000;
    triangle.normals[i] =
        arcspan::test::detail::packed(tilted(random, middle, radians(random.real(0, degrees)) / 2));
  }
  return triangle;
}

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
  material.highlight_fade = Coefficient::from_raw(random.chance(0.2) ? 0 : random.integer(1024, 16384));
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

template <class Method>
Picture draw(const Triangle& triangle, const typename Method::Lighting& lighting) {
  Picture picture;
  RasterStage<Method, hal::Framebuffer<Rgb888>> stage(picture.frame, kSize, kSize, lighting);
  const auto vertex = [&](std::size_t i) {
    return RasterVertex<Method>{triangle.points[i], Method::shade_vertex(lighting, triangle.normals[i])};
  };
  stage.draw(vertex(0), vertex(1), vertex(2), {});
  return picture;
}

int most_different(const Picture& a, const Picture& b) {
  int most = 0;
  for (std::size_t i = 0; i < a.memory.size(); ++i) {
    const Rgb8 p = Rgb888::decode(a.memory[i]);
    const Rgb8 q = Rgb888::decode(b.memory[i]);
    most = std::max({most, std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
  }
  return most;
}

}  // namespace

TEMPLATE_TEST_CASE("adaptive stays within its tolerance of arc, coloured and fading", "",
                   (Illumination<1, Highlight::kPhong, kAll>), (Illumination<1, Highlight::kBlinn, kAll>),
                   (Illumination<2, Highlight::kBlinn, kAll>)) {
  Random random(197);
  constexpr std::int32_t kTolerance = 1;
  int most = 0;
  for (int i = 0; i < share_of(3000); ++i) {
    const Triangle triangle = random_triangle(random, random.decades(4, 30));
    const TestType lit = random_lit<TestType>(random, triangle.normals[0]);
    AdaptiveIllumination<TestType> lighting(lit);
    REQUIRE(ok(lighting.set_tolerance(kTolerance)));
    const int off =
        most_different(draw<Arc<TestType>>(triangle, lit), draw<Adaptive<TestType>>(triangle, lighting));
    if (off > most) UNSCOPED_INFO("triangle " << i << " is off by " << off);
    most = std::max(most, off);
  }
  // One step more for rounding, as colours of arc come in steps too.
  CHECK(most <= kTolerance + 1);
}
