// SPDX-License-Identifier: MIT
// The limits of docs/accuracy.md: Arc against classic Phong shading in double precision.
#include <catch2/catch.hpp>
#include <tests/support/surface_accuracy.hpp>
#include <tests/support/test_share.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

using namespace arcspan;
using namespace arcspan::test;

namespace {

/// Limits of a highlight's error in 8-bit steps.
struct HighlightLimits {
  std::int32_t shininess;
  double nearly_all;  ///< 99.9 % of the pixels
  double all;
};
constexpr HighlightLimits kBlunt{16, 3, 13};
constexpr HighlightLimits kSharp{64, 8, 40};

template <Highlight Model>
SurfaceErrors measure(const SurfaceShapes& shapes, const HighlightLimits& limits, std::int32_t tolerance,
                      int triangles, std::uint64_t seed) {
  SurfaceMeasurement<Model> measurement;
  measurement.errors.light_limit = 0.2 + tolerance;
  measurement.errors.highlight_limit = limits.nearly_all + tolerance;
  Random random(seed);
  for (int i = 0; i < share_of(triangles); ++i) {
    SurfaceCase c = random_surface(random, shapes);
    c.shininess = limits.shininess;
    c.tolerance = tolerance;
    measurement.measure(c);
  }
  return measurement.errors;
}

void check(const SurfaceErrors& errors, const HighlightLimits& limits, std::int32_t tolerance) {
  const double most_share = share_of(100) < 100 ? 0.004 : 0.001;  // few pixels say little
  CHECK(errors.missing == 0);
  CHECK(errors.pixels > 0);
  INFO("N·L: " << errors.light_case);
  INFO("highlight: " << errors.highlight_case);
  CHECK(errors.light <= 1 + tolerance);
  CHECK(errors.light_share() <= most_share);
  CHECK(errors.highlight <= limits.all + tolerance);
  CHECK(errors.highlight_share() <= most_share);
}

template <Highlight Model>
void check_limits(const SurfaceShapes& shapes, int triangles, std::uint64_t seed) {
  for (const HighlightLimits& limits : {kBlunt, kSharp}) {
    CAPTURE(limits.shininess);
    check(measure<Model>(shapes, limits, 0, triangles, seed), limits, 0);
  }
}

}  // namespace

TEST_CASE("without tolerance Arc is within the limits: any size up to 1,000 pixels") {
  check_limits<Highlight::kPhong>({}, 3000, 1);
  check_limits<Highlight::kBlinn>({}, 1500, 2);
}

TEST_CASE("without tolerance Arc is within the limits: the largest triangles") {
  check_limits<Highlight::kPhong>({.smallest = 300}, 1000, 3);
}

TEST_CASE("without tolerance Arc is within the limits: small triangles") {
  check_limits<Highlight::kPhong>({.smallest = 0.3, .largest = 36, .slivers = 0.1}, 6000, 4);
}

TEST_CASE("without tolerance Arc is within the limits: slivers") {
  check_limits<Highlight::kPhong>({.slivers = 1}, 3000, 5);
}

TEST_CASE("without tolerance Arc is within the limits: normals close together") {
  check_limits<Highlight::kPhong>({.to_degrees = 25}, 2000, 6);
}

TEST_CASE("with a tolerance Arc is within the limits and the tolerance") {
  for (const std::int32_t tolerance : {1, 4, 16, 64}) {
    for (const HighlightLimits& limits : {kBlunt, kSharp}) {
      CAPTURE(tolerance, limits.shininess);
      const auto seed = static_cast<std::uint64_t>(10 + tolerance);
      check(measure<Highlight::kPhong>({}, limits, tolerance, 800, seed), limits, tolerance);
      check(measure<Highlight::kBlinn>({}, limits, tolerance, 800, seed), limits, tolerance);
    }
  }
}

// Between such normals the linear one is the shortest, and planes are the furthest off.
TEST_CASE("N·L is within the tolerance between normals that are equally far from the light") {
  Random random(9);
  for (const std::int32_t tolerance : {0, 1, 4, 16, 64}) {
    CAPTURE(tolerance);
    SurfaceMeasurement<Highlight::kPhong> measurement;
    for (int i = 0; i < share_of(1000); ++i) {
      SurfaceCase c = random_surface(random, {.largest = 60, .slivers = 0});
      const Vec3 light = random_unit(random);
      const Vec3 side = normalised(cross(light, random_unit(random)));
      const Vec3 other = cross(light, side);
      const double tilt = radians(random.real(0, 34.5));
      const double turn = random.real(0, 2 * std::numbers::pi);
      for (std::size_t k = 0; k < 3; ++k) {
        const double at = turn + static_cast<double>(k) * 2 * std::numbers::pi / 3;
        c.normals[k] = arcspan::test::detail::packed(
            std::cos(tilt) * light + std::sin(tilt) * (std::cos(at) * side + std::sin(at) * other));
      }
      c.to_light = to_direction(light);
      c.to_eye = to_direction(tilted(random, light, radians(random.real(0, 120))));
      c.tolerance = tolerance;
      measurement.measure(c);
    }
    INFO("N·L: " << measurement.errors.light_case);
    CHECK(measurement.errors.pixels > 0);
    CHECK(measurement.errors.light <= 1 + tolerance);
  }
}

TEST_CASE("beyond 60 degrees N·L keeps its limits up to 97 degrees") {
  for (const HighlightLimits& limits : {kBlunt, kSharp}) {
    CAPTURE(limits.shininess);
    const SurfaceShapes shapes{.from_degrees = 60, .to_degrees = 97};
    const SurfaceErrors errors = measure<Highlight::kPhong>(shapes, limits, 0, 1500, 7);
    INFO("N·L: " << errors.light_case);
    INFO("highlight: " << errors.highlight_case);
    CHECK(errors.light <= 1);
    CHECK(errors.highlight <= limits.all);
  }
}

TEST_CASE("normals that are still further apart do not lengthen a scalar by more than twice") {
  Random random(8);
  SurfaceMeasurement<Highlight::kPhong> measurement;
  for (int i = 0; i < share_of(2000); ++i) {
    measurement.measure(random_surface(random, {.from_degrees = 97, .to_degrees = 180}));
  }
  CHECK(measurement.errors.missing == 0);
  CHECK(measurement.most_light < 2.01);
}
