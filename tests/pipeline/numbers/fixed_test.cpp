// SPDX-License-Identifier: MIT
#include <arcspan/numbers/fixed.hpp>
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/multiply_wide.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>
#include <type_traits>

using namespace arcspan;
using namespace arcspan::test;

namespace {

constexpr std::int32_t kMin = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t kMax = std::numeric_limits<std::int32_t>::max();

using Q4 = Fixed<std::int32_t, 4>;
using Q15 = Fixed<std::int32_t, 15>;
using Q30 = Fixed<std::int32_t, 30>;
using Narrow = Fixed<std::int16_t, 14>;

template <class A, class B>
concept Divides = requires(A a, B b) {
  a / b;
};
template <class A, class B>
concept Adds = requires(A a, B b) {
  a + b;
};
template <class A, class B>
concept Multiplies = requires(A a, B b) {
  a* b;
};

// What must not compile; tests/pipeline/numbers/misuse checks the messages.
static_assert(!Divides<Q15, Q15> && !Divides<Q15, int> && !Divides<int, Q15>);
static_assert(!Adds<Q15, Q4> && !Adds<Q15, int> && Adds<Q15, Q15>);
static_assert(!Multiplies<Q15, Q15>);
static_assert(!std::convertible_to<Q15, Q4> && !std::convertible_to<int, Q15> &&
              !std::convertible_to<Q15, int> && !std::constructible_from<Q15, int>);
static_assert(std::is_trivially_copyable_v<Q15> && sizeof(Narrow) == 2);

}  // namespace

TEST_CASE("constants are rounded to nearest, halves away from 0") {
  STATIC_REQUIRE(Q4::of(1.0).raw() == 16);
  STATIC_REQUIRE(Q4::of(0.03125).raw() == 1);
  STATIC_REQUIRE(Q4::of(-0.03125).raw() == -1);
  STATIC_REQUIRE(Q4::of(0.031).raw() == 0);
  STATIC_REQUIRE(Q30::of(-2.0).raw() == kMin);
  STATIC_REQUIRE(Q30::of(1.9999999990686774).raw() == kMax);
  STATIC_REQUIRE(Narrow::of(1.99993896484375).raw() == 32767);
}

TEST_CASE("sums wrap as two's complement does") {
  CHECK((Q15::from_raw(kMax) + Q15::from_raw(1)).raw() == kMin);
  CHECK((Q15::from_raw(kMin) - Q15::from_raw(1)).raw() == kMax);
  CHECK((-Q15::from_raw(kMin)).raw() == kMin);
  CHECK((Narrow::from_raw(32767) + Narrow::from_raw(1)).raw() == -32768);
  CHECK(wrap_mul(kMin, -1) == kMin);
  CHECK(wrap_shl(3, 31) == kMin);
}

TEST_CASE("a value-initialised number is 0, and declaring one costs nothing") {
  alignas(Q15) unsigned char memory[sizeof(Q15)];
  std::memset(memory, 0xAA, sizeof memory);
  CHECK((::new (memory) Q15{})->raw() == 0);
  STATIC_REQUIRE(std::is_trivially_default_constructible_v<Q15>);
}

TEST_CASE("numbers are ordered by value") {
  CHECK(Q15::from_raw(-1) < Q15::from_raw(0));
  CHECK(Q15::from_raw(kMin) < Q15::from_raw(kMax));
  CHECK(Q15::from_raw(5) == Q15::from_raw(5));
}

TEST_CASE("round_shift is floor(a / 2^bits + 1/2)") {
  CHECK(round_shift(3, 1) == 2);
  CHECK(round_shift(-3, 1) == -1);
  CHECK(round_shift(-5, 1) == -2);
  CHECK(round_shift(kMin, 31) == -1);
  Random random(41);
  int wrong = 0;
  for (int i = 0; i < share_of(1000000); ++i) {
    const int bits = random.integer(1, 31);
    const std::int32_t half = std::int32_t{1} << (bits - 1);
    const std::int32_t a = random.integer(kMin, kMax - half);
    wrong += round_shift(a, bits) == std::floor(std::ldexp(a, -bits) + 0.5) ? 0 : 1;
  }
  CHECK(wrong == 0);
}

TEST_CASE("products are rounded to nearest within the stated range") {
  Random random(42);
  double worst = 0;
  for (int i = 0; i < share_of(1000000); ++i) {
    const Q15 a = Q15::from_raw(random.integer(-46340, 46340));
    const Q15 b = Q15::from_raw(random.integer(-46000, 46000));
    const double truth = std::ldexp(a.raw(), -15) * std::ldexp(b.raw(), -15);
    worst = std::max(worst, std::abs(multiply<Q15>(a, b).raw() - std::ldexp(truth, 15)));
  }
  CHECK(worst <= 0.5);
  CHECK(multiply<Q30>(Q15::of(1.0), Q15::of(-1.0)).raw() == -(1 << 30));
}

TEST_CASE("wide products are rounded to nearest, and saturate") {
  Random random(4711);
  const auto check = [](std::int32_t a, std::int32_t b) {
    const auto wanted = [&](int shift) {
      const double exact = static_cast<double>(std::int64_t{a} * b / (1 << 10)) * 1024;  // within 2^10 of it
      return std::ldexp(exact, -shift);
    };
    const double length = std::clamp(wanted(30), static_cast<double>(kMin), static_cast<double>(kMax));
    const std::int32_t made = multiply_wide<WorldLength>(WorldLength::from_raw(a), Q30::from_raw(b)).raw();
    REQUIRE(std::abs(made - length) <= 0.51);
    const std::int16_t narrow = multiply_wide<Narrow>(WorldLength::from_raw(a), Q30::from_raw(b)).raw();
    REQUIRE(std::abs(narrow - std::clamp(wanted(32), -32768.0, 32767.0)) <= 0.51);
  };
  for (const std::int32_t a : {kMin, kMin + 1, -1, 0, 1, kMax})
    for (const std::int32_t b : {kMin, kMin + 1, -1, 0, 1, kMax}) check(a, b);
  for (int i = 0; i < share_of(20000); ++i)
    check(random.integer(kMin, kMax) >> (i % 31), random.integer(kMin, kMax));
  // A step of 2 world units along an axis that is turned by 30 degrees.
  CHECK(multiply_wide<WorldLength>(WorldLength::of(2), Q30::of(0.5)) == WorldLength::of(1));
  CHECK(multiply_wide<Q4>(Q4::of(3.5), Q4::of(2)) == Q4::of(7));
  CHECK(multiply_wide<Q15>(Q15::from_raw(-1), Q15::of(0.5)) == Q15{});  // halves upwards, as multiply()
}

TEST_CASE("conversion rounds to fewer bits and is exact to more") {
  CHECK(convert<Q4>(Q15::of(1.0)).raw() == 16);
  CHECK(convert<Q4>(Q15::from_raw(1024)).raw() == 1);  // half of 1/16
  CHECK(convert<Q4>(Q15::from_raw(1023)).raw() == 0);
  CHECK(convert<Q4>(Q15::from_raw(-1024)).raw() == 0);  // floor(x + 1/2)
  CHECK(convert<Q15>(Q4::from_raw(-3)).raw() == -3 * 2048);
  CHECK(convert<Q15>(convert<Q30>(Q15::from_raw(-12345))).raw() == -12345);
}
