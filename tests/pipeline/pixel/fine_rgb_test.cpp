// SPDX-License-Identifier: MIT
// Colours of a word a channel: every format gives them the code of their 8-bit levels.
#include <arcspan/pixel/fine_rgb.hpp>
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/pixel/mono.hpp>
#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/rgb888.hpp>
#include <arcspan/prepare/linear.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

#include <cstdlib>

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

using Plain = BasicFineRgb<false>;
using Joined = BasicFineRgb<true>;

/// A gradient that leads from one word to another in `count` pixels at most.
std::int32_t gradient(std::uint32_t from, std::uint32_t to, int count) {
  return (static_cast<std::int32_t>(to) - static_cast<std::int32_t>(from)) / count;
}

}  // namespace

TEMPLATE_TEST_CASE("a fine colour's levels are its upper bits", "", Plain, Joined) {
  Random random(31);
  for (int i = 0; i < share_of(100000); ++i) {
    const TestType c = TestType::of(random_word(random), random_word(random), random_word(random));
    const Rgb8 levels{static_cast<std::uint8_t>(c.r() >> 23), static_cast<std::uint8_t>(c.g() >> 23),
                      static_cast<std::uint8_t>(c.b() >> 23)};
    REQUIRE(c.packed().rgb8() == levels);
  }
}

TEMPLATE_TEST_CASE("a fine colour is encoded like its levels", "", Rgb565, Rgb888, Gray8, Gray4, Mono,
                   Dithered<Rgb565>, Dithered<Gray4>) {
  Random random(32);
  for (int i = 0; i < share_of(100000); ++i) {
    const Plain c = Plain::of(random_word(random), random_word(random), random_word(random));
    const Joined same = Joined::of(c.r(), c.g(), c.b());
    const std::int32_t x = i & 3;
    const std::int32_t y = (i >> 2) & 3;
    REQUIRE(encode_at<TestType>(c, x, y) == encode_at<TestType>(c.packed(), x, y));
    REQUIRE(encode_at<TestType>(same, x, y) == encode_at<TestType>(c.packed(), x, y));
  }
}

TEST_CASE("both forms of a fine colour go the same way along a row") {
  Random random(33);
  for (int i = 0; i < 3000; ++i) {
    const int count = random.integer(1, 300);
    std::uint32_t from[3];
    std::int32_t by[3];
    for (int channel = 0; channel < 3; ++channel) {
      from[channel] = random_word(random);
      by[channel] = gradient(from[channel], random_word(random), count);
    }
    by[2] = by[2] / 32 * 32;  // as blue's are, and not beyond the end
    Plain plain = Plain::of(from[0], from[1], from[2]);
    Joined joined = Joined::of(from[0], from[1], from[2]);
    const Plain plain_step = Plain::step(by[0], by[1], by[2], Plain::keep_step(by[1], by[2]));
    const Joined joined_step = Joined::step(by[0], by[1], by[2], Joined::keep_step(by[1], by[2]));
    for (int x = 0; x < count; ++x) {
      REQUIRE(joined.r() == plain.r());
      REQUIRE(joined.g() == plain.g());
      REQUIRE(joined.b() == plain.b());
      REQUIRE(joined.rgb565() == plain.rgb565());
      plain.advance(plain_step);
      joined.advance(joined_step);
    }
  }
}

TEST_CASE("a step of blue is the nearest that it has bits for") {
  for (const std::int32_t step :
       {0, 1, 15, 16, 17, 31, 32, 48, -1, -15, -16, -17, -32, 12345678, -12345678}) {
    CAPTURE(step);
    const std::int32_t rounded = Plain::blue_step(step);
    CHECK(rounded % 32 == 0);
    CHECK(std::abs(rounded - step) <= 16);
  }
  CHECK(Plain::blue_step(kMaxGradient<FullLinear>) == kMaxGradient<FullLinear>);
  CHECK(Plain::blue_step(INT32_MIN) == INT32_MIN);
}
