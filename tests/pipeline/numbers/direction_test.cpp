// SPDX-License-Identifier: MIT
#include <arcspan/numbers/direction.hpp>

#include <catch2/catch.hpp>
#include <tests/support/test_share.hpp>
#include <tests/support/vec3.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>

using namespace arcspan;
using namespace arcspan::test;

namespace {

constexpr std::int32_t kMin = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t kMax = std::numeric_limits<std::int32_t>::max();

}  // namespace

TEST_CASE("normalised vectors are unit vectors in the same direction, whatever the length") {
  Random random(51);
  double worst = 0;
  double worst_nearly = 0;
  for (int i = 0; i < share_of(500000); ++i) {
    const int shift = random.integer(0, 20);
    const auto component = [&] { return random.integer(kMin, kMax) >> shift >> random.integer(0, 3); };
    const std::int32_t x = component();
    const std::int32_t y = component();
    const std::int32_t z = component();
    if (x == 0 && y == 0 && z == 0) continue;
    const Vec3 truth = test::normalised(Vec3{double(x), double(y), double(z)});
    worst = std::max(worst, length(to_vec3(arcspan::normalised(x, y, z)) - truth));
    worst_nearly = std::max(worst_nearly, length(to_vec3(nearly_normalised(x, y, z)) - truth));
  }
  // 14 bits of the largest component, 15 of the result.
  CHECK(worst < 1.6e-4);
  CHECK(worst_nearly < 1.6e-4);
  CHECK(arcspan::normalised(0, 0, 0) == Direction{});
  CHECK(nearly_normalised(0, 0, 0) == Direction{});
  CHECK(length(to_vec3(nearly_normalised(kMin, kMin, kMin)) - test::normalised(Vec3{-1, -1, -1})) < 1e-4);
  CHECK(length(to_vec3(nearly_normalised(kMax, 0, -1)) - Vec3{1, 0, 0}) < 1e-4);
  CHECK(length(to_vec3(arcspan::normalised(kMin, kMin, kMin)) - test::normalised(Vec3{-1, -1, -1})) < 1e-4);
  CHECK(length(to_vec3(arcspan::normalised(0, 1, 0)) - Vec3{0, 1, 0}) < 4e-5);
  CHECK(length(to_vec3(arcspan::normalised(kMax, 0, -1)) - Vec3{1, 0, 0}) < 1e-4);
}

TEST_CASE("wide vectors are normalised likewise") {
  Random random(52);
  double worst = 0;
  for (int i = 0; i < share_of(200000); ++i) {
    const int shift = random.integer(2, 62);
    const auto component = [&] { return static_cast<std::int64_t>(random.bits()) >> shift; };
    const std::int64_t x = component();
    const std::int64_t y = component();
    const std::int64_t z = component();
    if (x == 0 && y == 0 && z == 0) continue;
    const Vec3 truth =
        test::normalised(Vec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
    worst = std::max(worst, length(to_vec3(normalised_wide(x, y, z)) - truth));
  }
  CHECK(worst < 1.6e-4);
}

TEST_CASE("dot products of unit vectors are exact up to rounding") {
  Random random(53);
  double worst = 0;
  for (int i = 0; i < share_of(500000); ++i) {
    const Vec3 a = random_unit(random);
    const Vec3 b = random.chance(0.5) ? random_unit(random) : tilted(random, a, random.decades(1e-5, 1e-2));
    worst = std::max(worst,
                     std::abs(to_double(arcspan::dot(to_direction(a), to_direction(b))) - test::dot(a, b)));
  }
  CHECK(worst < 0x1p-14);
}

TEST_CASE("the half-way vector lies between") {
  Random random(54);
  double worst = 0;
  for (int i = 0; i < share_of(100000); ++i) {
    const Vec3 a = random_unit(random);
    const Vec3 b = tilted(random, a, radians(random.real(0, 150)));
    const Vec3 truth = test::normalised(a + b);
    worst = std::max(worst, length(to_vec3(half_way(to_direction(a), to_direction(b))) - truth));
  }
  CHECK(worst < 2e-4);
  const Direction up = to_direction({0, 0, 1});
  CHECK(half_way(up, -up) == Direction{});
}
