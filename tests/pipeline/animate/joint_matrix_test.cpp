// SPDX-License-Identifier: MIT
// Places by a single joint against the same in double precision, to the bit.
#include <arcspan/animate/posed_bound.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>

#include <cmath>

using namespace arcspan;
using namespace arcspan::test;

namespace {

NodeMatrix identity() {
  NodeMatrix matrix{};
  for (std::size_t i = 0; i < 3; ++i) matrix.entries[i][i] = std::int32_t{1} << 24;
  return matrix;
}

}  // namespace

TEST_CASE("a place is the exact one and a half") {
  Random random(42);
  for (int n = 0; n < 2000; ++n) {
    // Entries with 12 fraction bits below 1/4 and offsets below 2048 are kept exactly.
    NodeMatrix matrix{};
    double exact = 0;
    const std::int32_t p[3] = {random.integer(-32768, 32767), random.integer(-32768, 32767),
                               random.integer(-32768, 32767)};
    for (std::size_t j = 0; j < 3; ++j) {
      const std::int32_t entry = random.integer(-1024, 1024);
      matrix.entries[1][j] = entry * (1 << 12);
      exact += std::ldexp(entry, -12) * p[j];
    }
    matrix.offset[1] = ObjectLength::from_raw(random.integer(-500'000, 500'000));
    exact += std::ldexp(matrix.offset[1].raw(), -8);
    CHECK(std::ldexp(JointMatrix(matrix).place(1, p[0], p[1], p[2]), -JointMatrix::kBits) == exact + 0.5);
  }
}

TEST_CASE("the bound of one joint at rest is the sphere around the box of its sphere") {
  const JointBound bound{0, 0, {{100, -200, 300}, 1000}};
  const JointMatrix joint(identity());
  CHECK(joint.reach(2, 1000) >= 1000);
  CHECK(joint.reach(2, 1000) <= 1003);
  const BoundingSphere sphere = posed_bound({&bound, 1}, {&joint, 1});
  CHECK(std::abs(sphere.middle.x - 100) <= 1);
  CHECK(std::abs(sphere.middle.y + 200) <= 1);
  CHECK(sphere.radius >= 1733);
  CHECK(sphere.radius <= 1745);
}
