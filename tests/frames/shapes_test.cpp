// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <tests/frames/integer_shapes.hpp>

#include <cmath>
#include <cstdlib>

using namespace arcspan;

TEST_CASE("the compiler's sine is the sine") {
  for (std::uint32_t i = 0; i < 4096; ++i) {
    const std::uint32_t turn = i * 1048583u;
    const double exact = std::sin(turn * 6.283185307179586 / 4294967296.0);
    CHECK(std::abs(static_cast<double>(scenes::sine30(turn)) / 1073741824.0 - exact) < 1.0 / 134217728.0);
  }
}

TEST_CASE("normals packed by the compiler are those of pack_normal") {
  for (std::int32_t i = 0; i < 20000; ++i) {
    const std::int32_t x = (i * 7919) % 20011 - 10005;
    const std::int32_t y = (i * 5021) % 20021 - 10010;
    const std::int32_t z = (i * 3571) % 20023 - 10011;
    if (x == 0 && y == 0 && z == 0) continue;
    CHECK(scenes::packed(x, y, z) == pack_normal(x, y, z));
  }
}

TEST_CASE("a sphere's vertices lie on it and its faces look outwards") {
  const auto shape = scenes::make_sphere<32, 16>();
  CHECK(shape.positions.size() == 482);
  CHECK(shape.indices.size() == 3 * 960);
  for (const ObjectPosition& p : shape.positions) {
    CHECK(std::abs(std::sqrt(double(p.x) * p.x + double(p.y) * p.y + double(p.z) * p.z) - scenes::kRadius) <
          1.0);
  }
  for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
    const auto& a = shape.positions[shape.indices[i]];
    const auto& b = shape.positions[shape.indices[i + 1]];
    const auto& c = shape.positions[shape.indices[i + 2]];
    const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
    const double vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
    CHECK((uy * vz - uz * vy) * a.x + (uz * vx - ux * vz) * a.y + (ux * vy - uy * vx) * a.z > 0);
  }
}
