// SPDX-License-Identifier: MIT
#include <arcspan/lighting/make_illumination.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/adaptive/adaptive.hpp>
#include <arcspan/shading/arc/arc.hpp>
#include <arcspan/shading/patch/patch_limits.hpp>

#include <catch2/catch.hpp>
#include <tests/support/vec3.hpp>

#include <array>
#include <cmath>
#include <cstdint>

using namespace arcspan;
using namespace arcspan::test;

namespace {

/// The squared chord of an angle in degrees, 28 fraction bits.
std::uint32_t chord_of(double degrees) {
  const double chord = 2 * std::sin(degrees * 3.14159265358979 / 360);
  return static_cast<std::uint32_t>(std::lround(chord * chord * (1 << 28)));
}

/// Whether a triangle with these angles between its normals is a patch if equilateral ones are up to 17
/// degrees, in any order of the edges.
bool is_patch(double a, double b, double c) {
  const std::array<std::uint32_t, 3> s{chord_of(a), chord_of(b), chord_of(c)};
  const std::uint32_t limit = chord_of(17);
  const TriangleChords chords{s[0], s[1], s[2]};
  const bool found = is_accurate_patch(chords, chords.widest(), limit);
  CHECK(is_accurate_patch({s[2], s[0], s[1]}, chords.widest(), limit) == found);
  CHECK(is_accurate_patch({s[1], s[2], s[0]}, chords.widest(), limit) == found);
  return found;
}

}  // namespace

TEST_CASE(
    "patches with a right angle may be a quarter wider than equilateral ones, slender ones still more") {
  CHECK(is_patch(16.9, 16.9, 16.9));
  CHECK_FALSE(is_patch(17.1, 17.1, 17.1));
  CHECK(is_patch(21.4 / std::sqrt(2), 21.4 / std::sqrt(2), 21.4));
  CHECK_FALSE(is_patch(22.2 / std::sqrt(2), 22.2 / std::sqrt(2), 22.2));
  CHECK(is_patch(11.8, 11.8, 23.5));
  CHECK_FALSE(is_patch(12.3, 12.3, 24.4));
  CHECK_FALSE(is_patch(1, 22, 22));
}

TEST_CASE("no triangle with a highlight beyond 30 degrees is a patch, whatever the highlight allows") {
  const auto at = [](double degrees) {
    const std::uint32_t widest = chord_of(degrees);
    return is_accurate_patch({widest / 4, widest / 4, widest}, widest, chord_of(23));
  };
  CHECK(at(29.9));
  CHECK_FALSE(at(30.1));
}

TEST_CASE(
    "the limit of patches falls with the exponent times the height of the highlight, without steps up to "
    "16") {
  constexpr std::uint32_t kWhite = 255u << 5;
  const auto limit = [](std::int32_t n, std::uint32_t height) {
    return widest_patch(Highlight::kPhong, n, height);
  };
  CHECK(limit(4, kWhite) == chord_of(23));
  CHECK(limit(8, kWhite) == chord_of(20));
  CHECK(limit(16, kWhite) == chord_of(17));
  CHECK(limit(1, 1) == chord_of(23));
  CHECK(limit(17, kWhite) == limit(32, kWhite));
  CHECK(limit(256, 4 * kWhite) == limit(256, 3 * kWhite));
  for (const std::int32_t n : {5, 11, 16}) {
    INFO("n = " << n);
    std::uint32_t last = limit(n, 0);
    for (std::uint32_t height = 1; height <= kWhite; ++height) {
      const std::uint32_t next = limit(n, height);
      REQUIRE(next <= last);
      REQUIRE(last - next < last / 100);
      last = next;
    }
  }
  for (std::int32_t n = 1; n <= 64; ++n) {
    CHECK(limit(n, kWhite / 2 * 2) == limit(2 * n, kWhite / 2));
    CHECK(widest_patch(Highlight::kBlinn, 4 * n, kWhite) == limit(n, kWhite));
  }
}

namespace {

/// A triangle with normals 22 degrees apart and 20 pixels times `size`, under a highlight of n = 64 by N·H
/// that is brightest `away` degrees from its middle.
template <class Method, class Lit>
struct TriangleInHighlight {
  explicit TriangleInHighlight(double away, double size = 1) {
    const Direction towards = to_direction({std::sin(radians(away)), 0, std::cos(radians(away))});
    Material material;
    material.specular = {Coefficient::of(1), Coefficient::of(1), Coefficient::of(1)};
    material.shininess = 64;
    std::array<DirectionalLight, Lit::kLights> lights;
    for (DirectionalLight& light : lights) light.towards = towards;
    Lit lit;
    REQUIRE(ok(Lit::make(material, lights, towards, lit)));
    lighting = lit;
    constexpr std::array<std::array<double, 2>, 3> kPlaces{{{-160, 150}, {170, 140}, {10, -180}}};
    const double lean = std::asin(2 / std::sqrt(3) * std::sin(radians(11)));
    for (std::size_t i = 0; i < 3; ++i) {
      const double turn = radians(120.0 * static_cast<double>(i) + 60);
      corners[i].position = {static_cast<std::int16_t>(kPlaces[i][0] * size),
                             static_cast<std::int16_t>(kPlaces[i][1] * size), 1000};
      corners[i].shade = Method::shade_vertex(
          lighting,
          to_direction({std::sin(lean) * std::cos(turn), std::sin(lean) * std::sin(turn), std::cos(lean)}));
    }
  }

  [[nodiscard]] typename Method::Prepared prepared() const {
    TriangleCommand<Method> command;
    REQUIRE(prepare_triangle<Method>(lighting, corners[0], corners[1], corners[2], {}, {-80, 80}, command));
    return command.shade;
  }

  typename Method::Lighting lighting;
  std::array<RasterVertex<Method>, 3> corners;
};

using OneLight = Illumination<1, Highlight::kBlinn>;
using Any = Arc<OneLight>;
using Fine = ArcUpTo<OneLight, WidestNormals::kWithinPatches>;

template <class Method>
typename Method::Path path_of(double away) {
  return TriangleInHighlight<Method, OneLight>(away).prepared().path;
}

}  // namespace

TEST_CASE(
    "a triangle with a faint highlight is a patch beyond the limit, but not in programs for fine meshes") {
  REQUIRE(widest_patch(Highlight::kBlinn, 64, 255u << 5) < chord_of(22));
  CHECK(path_of<Any>(0) == Any::Path::kWide);
  CHECK(path_of<Any>(8) == Any::Path::kWide);
  CHECK(path_of<Any>(31) == Any::Path::kSteppedDistance);
  CHECK(path_of<Any>(45) == Any::Path::kDiffusePatch);
  CHECK(path_of<Any>(170) == Any::Path::kDark);
  CHECK(path_of<Fine>(31) == Fine::Path::kWide);
  using TwoLights = Illumination<2, Highlight::kBlinn>;
  using Two = Arc<TwoLights>;
  CHECK(TriangleInHighlight<Two, TwoLights>(8).prepared().path == Two::Path::kWide);
  CHECK(TriangleInHighlight<Two, TwoLights>(31).prepared().path == Two::Path::kPatch);
  // The lights' horizon runs through it.
  CHECK(TriangleInHighlight<Two, TwoLights>(90).prepared().path == Two::Path::kDiffuseSumPatch);
  CHECK(TriangleInHighlight<Adaptive<OneLight>, OneLight>(8).prepared().highlight_path !=
        HighlightPath::kDistance);
  CHECK(TriangleInHighlight<Adaptive<OneLight>, OneLight>(31).prepared().highlight_path ==
        HighlightPath::kDistance);
}
