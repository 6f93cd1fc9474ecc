// SPDX-License-Identifier: MIT
// A face's normal has the same bits by products of 32 bits and of 64.
#include <arcspan/mesh/face_normal.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>
#include <tests/support/vec3.hpp>

#include <array>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Vectors = std::array<std::int32_t, 6>;

bool same(const Vectors& v) {
  const detail::ObjectVector a{v[0], v[1], v[2]};
  const detail::ObjectVector b{v[3], v[4], v[5]};
  return detail::normal_along(a, b) == detail::normal_along_wide(a, b);
}

}  // namespace

TEST_CASE("short and wide products make the same face normal") {
  Random random(131);
  int different = 0;
  for (int i = 0; i < share_of(200000); ++i) {
    const auto size = static_cast<std::int32_t>(random.decades(1, 65535));
    Vectors v;
    for (std::int32_t& component : v) component = random.integer(-size, size);
    different += same(v) ? 0 : 1;
  }
  // All that the limit of the short products lies between.
  const std::array<std::int32_t, 7> limits{-65535, -32768, -32767, 0, 32767, 32768, 65535};
  for (std::size_t i = 0; i < 7 * 7 * 7 * 7 * 7 * 7; ++i) {
    Vectors v;
    std::size_t digits = i;
    for (std::int32_t& component : v) {
      component = limits[digits % 7];
      digits /= 7;
    }
    different += same(v) ? 0 : 1;
  }
  CHECK(different == 0);
}

TEST_CASE("a face's normal points to where its vertices go round to the left") {
  const auto error = [](const Direction& normal, const Vec3& truth) {
    return length(to_vec3(normal) - truth);
  };
  CHECK(error(face_normal({0, 0, 7}, {10, 0, 7}, {0, 10, 7}), {0, 0, 1}) < 1e-4);
  CHECK(error(face_normal({0, 0, 7}, {0, 10, 7}, {10, 0, 7}), {0, 0, -1}) < 1e-4);
  CHECK(error(face_normal({-32768, 32767, -32768}, {-32768, -32768, -32768}, {-32768, -32768, 32767}),
              {-1, 0, 0}) < 1e-4);
  CHECK(face_normal({1, 2, 3}, {1, 2, 3}, {4, 5, 6}) == Direction{});
}
