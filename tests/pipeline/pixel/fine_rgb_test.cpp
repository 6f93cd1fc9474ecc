// SPDX-License-Identifier: MIT
// Colours of a word a channel: every format gives them the code of their 8-bit levels.
#include <arcspan/pixel/fine_rgb.hpp>
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/pixel/mono.hpp>
#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/rgb888.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

using namespace arcspan;
using namespace arcspan::test;

namespace {

/// A word of any kind: black and white, both sides of where a level begins, anything.
std::uint32_t random_word(Random& random) {
  const auto level = static_cast<std::uint32_t>(random.integer(0, 255)) << FineRgb::kFraction;
  switch (random.integer(0, 3)) {
    case 0:
      return random.chance(0.5) ? 0u : 0x7FFFFFFFu;
    case 1:
      return level;
    case 2:
      return level | 0x7FFFFFu;
    default:
      return level | static_cast<std::uint32_t>(random.integer(0, 0x7FFFFF));
  }
}

}  // namespace

TEST_CASE("a fine colour's levels are its upper bits") {
  Random random(31);
  for (int i = 0; i < share_of(100000); ++i) {
    const FineRgb c = FineRgb::of(random_word(random), random_word(random), random_word(random));
    const Rgb8 levels{static_cast<std::uint8_t>(c.r() >> 23), static_cast<std::uint8_t>(c.g() >> 23),
                      static_cast<std::uint8_t>(c.b() >> 23)};
    REQUIRE(c.packed().rgb8() == levels);
  }
}

TEMPLATE_TEST_CASE("a fine colour is encoded like its levels", "", Rgb565, Rgb888, Gray8, Gray4, Mono,
                   Dithered<Rgb565>, Dithered<Gray4>) {
  Random random(32);
  for (int i = 0; i < share_of(100000); ++i) {
    const FineRgb c = FineRgb::of(random_word(random), random_word(random), random_word(random));
    const std::int32_t x = i & 3;
    const std::int32_t y = (i >> 2) & 3;
    REQUIRE(encode_at<TestType>(c, x, y) == encode_at<TestType>(c.packed(), x, y));
  }
}
