// SPDX-License-Identifier: MIT
#include <arcspan/pixel/colour.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <array>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Channels = std::array<std::uint32_t, 3>;  // 0...1023 each

PackedRgb packed(const Channels& c) { return PackedRgb::of(c[0], c[1], c[2]); }

Channels saturated_sum(const Channels& a, const Channels& b) {
  Channels sum{};
  for (std::size_t i = 0; i < 3; ++i) sum[i] = std::min<std::uint32_t>(a[i] + b[i], 1023);
  return sum;
}

/// Calls `check` with pairs of colours: extreme channels in many combinations, and random ones.
template <class Check>
void for_pairs(const Check& check) {
  constexpr std::array<std::uint32_t, 6> kLevels{0, 1, 511, 512, 1022, 1023};
  Random random(3);
  for (const std::uint32_t r : kLevels) {
    for (const std::uint32_t g : kLevels) {
      for (const std::uint32_t b : kLevels) {
        for (const std::uint32_t other : kLevels) check({r, g, b}, {other, 1023 - other, other / 2});
        check({r, g, b}, {1023 - r, 1023 - g, 1023 - b});
      }
    }
  }
  const auto level = [&random] { return static_cast<std::uint32_t>(random.integer(0, 1023)); };
  for (int i = 0; i < share_of(20000); ++i) check({level(), level(), level()}, {level(), level(), level()});
}

}  // namespace

TEST_CASE("a sum of packed colours saturates every channel by itself") {
  for_pairs([](const Channels& a, const Channels& b) {
    CAPTURE(a[0], a[1], a[2], b[0], b[1], b[2]);
    REQUIRE(packed(a).plus(packed(b)).lanes == packed(saturated_sum(a, b)).lanes);
  });
}

TEST_CASE("a grey has its level in every channel") {
  for (std::uint32_t v = 0; v < 1024; ++v) REQUIRE(PackedRgb::grey(v).lanes == packed({v, v, v}).lanes);
}
