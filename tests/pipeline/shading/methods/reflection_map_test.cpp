// SPDX-License-Identifier: MIT
#include <arcspan/literature/reflection_map.hpp>

#include <catch2/catch.hpp>
#include <tests/support/vec3.hpp>

#include <algorithm>

using namespace arcspan;
using namespace arcspan::test;

namespace {

/// An illumination whose colour is the direction itself, 10 bits a component.
struct DirectionColours {
  [[nodiscard]] Direction scalars(const Direction& n) const { return n; }
  [[nodiscard]] PackedRgb colour(const Direction& n) const {
    const auto level = [](DirectionComponent c) {
      return static_cast<std::uint32_t>((c.raw() + 32768) * 511 >> 15);
    };
    return PackedRgb::of(level(n.x), level(n.y), level(n.z));
  }
};

Vec3 direction_of(PackedRgb c) {
  const auto component = [](std::uint32_t bits) { return (bits & 1023u) / 511.0 - 1; };
  return normalised(Vec3{component(c.lanes >> 11), component(c.lanes >> 22), component(c.lanes)});
}

}  // namespace

TEST_CASE("a direction of any length finds the cell that it is in") {
  const ReflectionTable<DirectionColours> table{DirectionColours{}};
  Random random(7);
  double worst = 0;
  for (int i = 0; i < 300000; ++i) {
    const Vec3 n = random_unit(random);
    const double size = random.real(0.1, 1) * 32767;
    const auto component = [size](double c) { return static_cast<std::int32_t>(std::lround(size * c)); };
    const Vec3 found = direction_of(table(component(n.x), component(n.y), component(n.z)));
    worst = std::max(worst, degrees(angle_between(n, found)));
  }
  INFO("farthest from a cell's centre: " << worst << " degrees");
  CHECK(worst < 3.9);
}

TEST_CASE("no direction misses the table") {
  const ReflectionTable<DirectionColours> table{DirectionColours{}};
  constexpr std::int32_t kMost = (1 << 17) - 1;
  for (const std::int32_t x : {-kMost, -1, 0, 1, kMost}) {
    for (const std::int32_t y : {-kMost, -1, 0, 1, kMost}) {
      for (const std::int32_t z : {-kMost, -1, 0, 1, kMost}) {
        if (x == 0 && y == 0 && z == 0) continue;
        const Vec3 n = normalised(Vec3{double(x), double(y), double(z)});
        CHECK(degrees(angle_between(n, direction_of(table(x, y, z)))) < 3.9);
      }
    }
  }
  static_cast<void>(table(0, 0, 0));
}
