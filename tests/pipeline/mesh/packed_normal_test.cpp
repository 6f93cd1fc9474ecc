// SPDX-License-Identifier: MIT
#include <arcspan/mesh/packed_normal.hpp>

#include <catch2/catch.hpp>
#include <tests/support/test_share.hpp>
#include <tests/support/vec3.hpp>

#include <algorithm>

using namespace arcspan;
using namespace arcspan::test;

namespace {

PackedNormal pack(Vec3 v, double scale) {
  const auto whole = [scale](double c) { return static_cast<std::int32_t>(std::lround(c * scale)); };
  return pack_normal(whole(v.x), whole(v.y), whole(v.z));
}

struct Worst {
  double angle = 0;
  double length = 0;
  void add(Vec3 truth, const Direction& got) {
    const Vec3 v = to_vec3(got);
    angle = std::max(angle, angle_between(truth, v));
    length = std::max(length, std::abs(test::length(v) - 1));
  }
};

}  // namespace

TEST_CASE("the point of a packed normal lies on the octahedron, on the side of the normal") {
  for (std::int32_t u = -32767; u <= 32767; u += 1213) {
    for (std::int32_t v = -32767; v <= 32767; v += 1213) {
      const PackedNormal packed{static_cast<std::int16_t>(u), static_cast<std::int16_t>(v)};
      const detail::OctahedralPoint p = detail::octahedral_point(packed);
      REQUIRE(std::abs(p.x) + std::abs(p.y) + std::abs(p.z) == 32767);
      REQUIRE(angle_between({double(p.x), double(p.y), double(p.z)}, to_vec3(unpack_normal(packed))) < 1e-4);
    }
  }
}

TEST_CASE("a packed normal comes back within 0.006 degrees and of unit length") {
  Worst worst;
  // A dense spiral over the sphere.
  const int count = std::max(share_of(2000000), 200000);
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count;
    const double phi = i * 2.399963229728653;
    const double r = std::sqrt(1 - z * z);
    const Vec3 v{r * std::cos(phi), r * std::sin(phi), z};
    worst.add(v, unpack_normal(pack(v, 1 << 30)));
  }
  CHECK(degrees(worst.angle) < 0.006);
  CHECK(degrees(worst.angle) > 0.003);
  CHECK(worst.length < 0x1p-14);
}

TEST_CASE("the axes and the octahedron's edges and folds pack as well") {
  Worst worst;
  for (int x = -8; x <= 8; ++x) {
    for (int y = -8; y <= 8; ++y) {
      for (int z = -8; z <= 8; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        const Vec3 v = normalised(Vec3{double(x), double(y), double(z)});
        worst.add(v, unpack_normal(pack_normal(x, y, z)));
        worst.add(v, unpack_normal(pack_normal(x << 26, y << 26, z << 26)));
      }
    }
  }
  CHECK(degrees(worst.angle) < 0.006);
  CHECK(worst.length < 0x1p-14);
}

TEST_CASE("the zero vector packs as +z") {
  CHECK(pack_normal(0, 0, 0) == PackedNormal{});
  CHECK(unpack_normal(PackedNormal{}).z.raw() == Approx(32768).margin(1));
}

TEST_CASE("every bit pattern is a unit vector and packs to the same direction again") {
  double worst_length = 0;
  double worst_angle = 0;
  for (std::int32_t u = -32768; u <= 32767; u += 31) {
    for (std::int32_t v = -32768; v <= 32767; v += stride_of(37)) {
      const PackedNormal packed{static_cast<std::int16_t>(u), static_cast<std::int16_t>(v)};
      const Direction n = unpack_normal(packed);
      worst_length = std::max(worst_length, std::abs(length(to_vec3(n)) - 1));
      const Direction again = unpack_normal(pack_normal(n.x.raw(), n.y.raw(), n.z.raw()));
      worst_angle = std::max(worst_angle, angle_between(to_vec3(n), to_vec3(again)));
    }
  }
  CHECK(worst_length < 0x1p-14);
  CHECK(degrees(worst_angle) < 0.006);
}

TEST_CASE("the extreme patterns are unit vectors") {
  for (const int u : {-32768, -32767, 0, 32767}) {
    for (const int v : {-32768, -32767, 0, 32767}) {
      const Direction n = unpack_normal({static_cast<std::int16_t>(u), static_cast<std::int16_t>(v)});
      CHECK(length(to_vec3(n)) == Approx(1).margin(0x1p-14));
    }
  }
}
