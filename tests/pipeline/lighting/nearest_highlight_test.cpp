// SPDX-License-Identifier: MIT
// Lower bounds of a highlight's distance over a triangle.
#include <arcspan/lighting/illumination.hpp>
#include <arcspan/shading/patch/patch_limits.hpp>

#include <catch2/catch.hpp>
#include <tests/support/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace arcspan;
using namespace arcspan::test;

TEST_CASE(
    "no normal of a triangle is nearer to the highlight than its bounds, and the sharper one is often "
    "sharper") {
  using Lit = Illumination<1, Highlight::kPhong>;
  Random random(51);
  int sharper = 0;
  double slack = 0;
  constexpr int kTriangles = 3000;
  for (int i = 0; i < kTriangles; ++i) {
    const Vec3 middle = random_unit(random);
    const double widest = radians(random.real(5, 34));
    std::array<Vec3, 3> normals;
    for (Vec3& normal : normals) normal = tilted(random, middle, random.real(0, 1) * widest);
    const Direction towards = to_direction(tilted(random, middle, random.real(0, 1.2)));
    const Direction to_eye = to_direction(tilted(random, middle, random.real(0, 1.2)));
    Lit lit;
    REQUIRE(ok(Lit::make({}, {DirectionalLight{towards}}, to_eye, lit)));
    std::array<Lit::Scalars, 3> at;
    std::array<Normal, 3> packed;
    for (std::size_t k = 0; k < 3; ++k) {
      const Direction normal = to_direction(normals[k]);
      at[k] = lit.scalars(normal);
      packed[k] = to_normal(normal);
    }
    const std::array<std::uint32_t, 3> chords{squared_chord(packed[0], packed[1]),
                                              squared_chord(packed[0], packed[2]),
                                              squared_chord(packed[1], packed[2])};
    const std::uint32_t longest = *std::max_element(chords.begin(), chords.end());
    if (longest > std::uint32_t{1} << 28) continue;
    const double bound =
        lit.nearest_highlight_between(INT32_MIN, at[0], at[1], at[2], chords[0], chords[1], chords[2]) *
        0x1p-30;
    const double rough = lit.nearest_highlight(at[0], at[1], at[2], arc_headroom(longest)) * 0x1p-30;
    double nearest = 1;
    for (int sample = 0; sample < 100; ++sample) {
      const double a = random.unit();
      const double b = random.unit() * (1 - a);
      const Vec3 n = normalised(a * normals[0] + b * normals[1] + (1 - a - b) * normals[2]);
      const Vec3 l = to_vec3(towards);
      const Vec3 v = to_vec3(to_eye);
      nearest = std::min(nearest, (1 - (2 * dot(n, l) * dot(n, v) - dot(l, v))) / 2);
    }
    REQUIRE(bound <= nearest);
    sharper += bound > rough ? 1 : 0;
    slack = std::max(slack, nearest - bound);
  }
  CAPTURE(sharper, slack);
  CHECK(sharper > kTriangles / 2);
}

TEST_CASE("the sharper bound is for R·V of one light") {
  const Illumination<1, Highlight::kBlinn> blinn{};
  CHECK(blinn.nearest_highlight_between(0, {}, {}, {}, 0, 0, 0) == INT32_MIN);
  const Illumination<2, Highlight::kPhong> two{};
  CHECK(two.nearest_highlight_between(0, {}, {}, {}, 0, 0, 0) == INT32_MIN);
}
