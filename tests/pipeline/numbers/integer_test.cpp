// SPDX-License-Identifier: MIT
// The short products that stand in for long ones, the quotient without a divide, and leading zeros by a table
// are exact.
#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/reciprocal.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

#include <bit>

using namespace arcspan;
using namespace arcspan::test;

TEST_CASE("short products give the bits of long ones") {
  Random random(21);
  int wrong = 0;
  for (int i = 0; i < share_of(1000000); ++i) {
    const auto a = static_cast<std::uint32_t>(random.bits() >> random.integer(32, 63));
    const auto b = static_cast<std::uint32_t>(random.bits() >> random.integer(32, 63));
    wrong += detail::short_multiply_high(a, b) == (std::uint64_t{a} * b) >> 32 ? 0 : 1;
    const auto c = static_cast<std::int32_t>(a);
    const auto d = static_cast<std::int32_t>(b);
    wrong += detail::short_multiply_high(c, d) == (std::int64_t{c} * d) >> 32 ? 0 : 1;
    const auto wide = static_cast<std::int64_t>(random.bits()) >> random.integer(17, 63);
    const std::uint32_t factor = b & 0xFFFFu;
    wrong += detail::short_scaled(wide, factor) == wide * static_cast<std::int64_t>(factor) ? 0 : 1;
  }
  CHECK(detail::short_multiply_high(0xFFFFFFFFu, 0xFFFFFFFFu) == 0xFFFFFFFEu);
  CHECK(wrong == 0);
}

TEST_CASE("multiply_high of signed numbers rounds down") {
  CHECK(multiply_high(-1, 1) == -1);
  CHECK(multiply_high(INT32_MIN, INT32_MIN) == 1 << 30);
  CHECK(multiply_high(INT32_MIN, INT32_MAX) == -(1 << 30));
}

TEST_CASE("unsigned numbers are clamped at both ends") {
  for (std::int32_t v = 0; v < 1024; ++v) {
    CHECK(clamped_unsigned<8, 2>(v) == static_cast<std::uint32_t>(v) >> 2);
    CHECK(clamped_unsigned<9, 1>(v) == static_cast<std::uint32_t>(v) >> 1);
  }
  for (const std::int32_t v : {-1, -4, -256, -65536, INT32_MIN}) {
    CHECK(clamped_unsigned<8, 2>(v) == 0);
    CHECK(clamped_unsigned<9, 1>(v) == 0);
  }
  for (const std::int32_t v : {1024, 1025, 65536, INT32_MAX}) {
    CHECK(clamped_unsigned<8, 2>(v) == 255);
    CHECK(clamped_unsigned<9, 1>(v) == 511);
  }
}

TEST_CASE("numbers are clamped to a range of bits at both ends") {
  for (const std::int32_t v : {-16384, -16383, -1, 0, 16382, 16383}) CHECK(clamped_to_bits<15>(v) == v);
  for (const std::int32_t v : {-16385, -32768, -65536, INT32_MIN}) CHECK(clamped_to_bits<15>(v) == -16384);
  for (const std::int32_t v : {16384, 32767, 65536, INT32_MAX}) CHECK(clamped_to_bits<15>(v) == 16383);
}

TEST_CASE("leading zeros are counted by the table as by an instruction") {
  int wrong = 0;
  const auto check = [&wrong](std::uint32_t v) {
    wrong += detail::leading_zeros_by_table(v) == std::countl_zero(v) ? 0 : 1;
  };
  check(0);
  for (int bit = 0; bit < 32; ++bit) {
    const std::uint32_t power = std::uint32_t{1} << bit;
    check(power - 1);
    check(power);
    check(power + 1);
  }
  check(UINT32_MAX);
  Random random(23);
  for (int i = 0; i < share_of(100000); ++i)
    check(static_cast<std::uint32_t>(random.bits() >> random.integer(32, 63)));
  CHECK(wrong == 0);
}

TEST_CASE("the quotient of an edge without a divide is the exact one") {
  const auto exact = [](std::int32_t dividend, std::int32_t divisor) {
    const std::int64_t whole = std::int64_t{dividend} << 32;
    const std::int64_t quotient = detail::divide(dividend, divisor);
    const Reciprocal reciprocal = nonzero_reciprocal(static_cast<std::uint32_t>(divisor));
    return quotient * divisor <= whole && (quotient + 1) * divisor > whole &&
           detail::divide_by_reciprocal(dividend, divisor, reciprocal) == quotient;
  };
  int wrong = 0;
  for (std::int32_t divisor = 1; divisor < 1 << 15; divisor += divisor < 300 ? 1 : 61) {
    for (std::int32_t dividend = 0; dividend < 1 << 15; dividend += dividend < 300 ? 1 : 59) {
      wrong += exact(dividend, divisor) && exact(-dividend, divisor) ? 0 : 1;
    }
  }
  CHECK(wrong == 0);
  for (const std::int32_t divisor : {1, 32766, 32767}) {
    for (const std::int32_t dividend : {-32767, -32766, -1, 1, 32766, 32767}) CHECK(exact(dividend, divisor));
  }
}

TEST_CASE("a value scaled down is rounded down to the last bit, in one product or in two halves") {
  Random random(9);
  for (int i = 0; i < share_of(100000); ++i) {
    const auto value = static_cast<std::int32_t>(random.bits());
    const auto factor = static_cast<std::uint32_t>(random.integer(0, 65536));
    for (const int bits : {15, 16}) {
      const std::int64_t product = std::int64_t{value} * static_cast<std::int64_t>(factor);
      REQUIRE(scaled_down(value, factor, bits) == static_cast<std::int32_t>(product >> bits));
    }
  }
}
