// SPDX-License-Identifier: MIT
#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/numbers/root.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>

using namespace arcspan;
using namespace arcspan::test;

namespace {

/// Every argument up to 2^17, every power of two and its neighbours, the last 2^12, and two million others.
template <class Check>
void sweep(const Check& check) {
  for (std::uint32_t v = 1; v <= 1u << 17; ++v) check(v);
  for (int bit = 17; bit < 32; ++bit) {
    for (std::uint32_t d = 0; d <= 64; ++d) {
      check((1u << bit) + d);
      check((1u << bit) - d);
    }
  }
  for (std::uint32_t d = 0; d < 1u << 12; ++d) check(0xFFFFFFFFu - d);
  Random random(31);
  for (int i = 0; i < share_of(2000000); ++i) {
    const auto v = static_cast<std::uint32_t>(random.bits() >> random.integer(32, 56));
    if (v != 0) check(v);
  }
}

/// Largest magnitude of the relative error of mantissa * 2^-exponent, where `inverse` is the truth's
/// reciprocal.
struct Relative {
  double worst = 0;
  std::uint32_t lowest = 0xFFFFFFFFu;
  std::uint32_t highest = 0;

  template <class R>
  void add(const R& r, double inverse) {
    worst = std::max(worst, std::abs(std::ldexp(r.mantissa, -r.exponent) * inverse - 1));
    lowest = std::min(lowest, r.mantissa);
    highest = std::max(highest, r.mantissa);
  }
};

}  // namespace

TEST_CASE("reciprocal is within 3.8e-5 for every argument") {
  Relative r;
  sweep([&r](std::uint32_t v) { r.add(reciprocal(v), v); });
  CHECK(r.worst <= 3.8e-5);
  CHECK(r.worst > 0x1p-15);
  CHECK(r.lowest >= 1u << 15);
  CHECK(r.highest <= 1u << 16);
}

TEST_CASE("wide_reciprocal is within 2^-28 for every argument") {
  Relative r;
  sweep([&r](std::uint32_t v) { r.add(wide_reciprocal(v), v); });
  CHECK(r.worst <= 0x1p-28);
  CHECK(r.lowest >= 1u << 30);
  CHECK(r.highest <= 1u << 31);
}

TEST_CASE("reciprocal_root is within 2^-15 for every argument") {
  Relative r;
  sweep([&r](std::uint32_t v) { r.add(reciprocal_root(v), std::sqrt(v)); });
  CHECK(r.worst <= 0x1p-15);
  CHECK(r.lowest >= 1u << 15);
  CHECK(r.highest <= 1u << 16);
}

TEST_CASE("tabled_reciprocal_root is within 2^-13 between 1/4 and 1 + 1/128") {
  constexpr std::uint32_t kOne = 1u << 30;
  CHECK_FALSE(detail::has_tabled_root(kOne / 4 - 1));
  CHECK_FALSE(detail::has_tabled_root(kOne + kOne / 128));
  CHECK_FALSE(detail::has_tabled_root(0));
  CHECK_FALSE(detail::has_tabled_root(UINT32_MAX));
  double worst = 0;
  bool is_in = true;
  for (std::uint32_t v = kOne / 4; v < kOne + kOne / 128; v += v < kOne / 4 + 4096 ? 1 : 251) {
    is_in &= detail::has_tabled_root(v);
    worst = std::max(
        worst,
        std::abs(std::ldexp(detail::tabled_reciprocal_root(v), -15) * std::sqrt(std::ldexp(v, -30)) - 1));
  }
  CHECK(is_in);
  CHECK(worst <= 0x1p-13);
}

TEST_CASE("the reciprocals take 0 as 1 and are exact at powers of two") {
  CHECK(std::ldexp(reciprocal(0).mantissa, -reciprocal(0).exponent) == 1);
  CHECK(std::ldexp(wide_reciprocal(0).mantissa, -wide_reciprocal(0).exponent) == 1);
  CHECK(std::ldexp(reciprocal_root(0).mantissa, -reciprocal_root(0).exponent) == Approx(1).epsilon(0x1p-15));
  for (int bit = 0; bit < 32; ++bit) {
    const Reciprocal r = reciprocal(1u << bit);
    CHECK(std::ldexp(r.mantissa, -r.exponent) == std::ldexp(1, -bit));
    const WideReciprocal w = wide_reciprocal(1u << bit);
    CHECK(std::ldexp(w.mantissa, -w.exponent) == std::ldexp(1, -bit));
  }
}

TEST_CASE("integer_root is the exact floor") {
  CHECK(integer_root(0) == 0);
  CHECK(integer_root(0xFFFFFFFFu) == 65535);
  int wrong = 0;
  sweep([&wrong](std::uint32_t v) {
    const std::uint64_t root = integer_root(v);
    wrong += root * root <= v && (root + 1) * (root + 1) > v ? 0 : 1;
  });
  for (std::uint32_t root = 1; root <= 65535; ++root) {
    wrong += integer_root(root * root) == root ? 0 : 1;
    wrong += integer_root(root * root - 1) == root - 1 ? 0 : 1;
  }
  CHECK(wrong == 0);
}
