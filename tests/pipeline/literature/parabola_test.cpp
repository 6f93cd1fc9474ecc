// SPDX-License-Identifier: MIT
#include <arcspan/literature/parabola.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

using namespace arcspan;
using namespace arcspan::test;
using literature::Parabola;

TEST_CASE("strides and skipped pixels of a parabola are its single steps, to the last bit") {
  Random random(2);
  const auto difference = [&random](int least) {
    return Cosine::from_raw(static_cast<std::int32_t>(random.bits()) >> random.integer(least, 20));
  };
  for (int i = 0; i < share_of(5000); ++i) {
    Parabola single{Cosine::from_raw(static_cast<std::int32_t>(random.bits()) >> 2), difference(6),
                    difference(10)};
    Parabola stride = single;
    Parabola skipped = single;
    const int bits = static_cast<int>(random.integer(0, 4));
    stride.stride(bits);
    for (int k = 0; k < 5; ++k) {
      REQUIRE(stride.x == single.x);
      stride.next();
      for (int n = 0; n < 1 << bits; ++n) single.next();
    }
    skipped.skip(5 << bits);
    REQUIRE(skipped.x == single.x);
    REQUIRE(skipped.d == single.d);
  }
}
