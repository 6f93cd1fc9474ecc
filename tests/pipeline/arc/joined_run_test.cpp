// SPDX-License-Identifier: MIT
// Two scalars in one register have the bits of two scalars stepped apart.
#include <arcspan/shading/patch/patch_walker.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

#include <array>
#include <cstdint>

using namespace arcspan;
using namespace arcspan::test;

namespace {

Cosine any_cosine(Random& random) { return Cosine::from_raw(random.integer(INT32_MIN, INT32_MAX)); }

/// True if the scalar stays in the range of a Cosine over `count` pixels.
bool stays_in_range(const Parabola& f, std::int32_t count) {
  std::int64_t x = f.x.raw();
  std::int64_t d = f.d.raw();
  for (std::int32_t i = 0; i < count; ++i) {
    if (x != static_cast<std::int32_t>(x)) return false;
    x += d;
    d += f.second_difference.raw();
  }
  return true;
}

/// A lower scalar: its value is anything, and its differences are as large as the row allows.
Parabola lower_parabola(Random& random, std::int32_t count) {
  Parabola f{any_cosine(random), any_cosine(random), any_cosine(random)};
  if (random.chance(0.1)) f.x = Cosine::from_raw(random.chance(0.5) ? INT32_MIN : INT32_MAX);
  while (!stays_in_range(f, count)) {
    f.d = Cosine::from_raw(f.d.raw() / 2);
    f.second_difference = Cosine::from_raw(f.second_difference.raw() / 2);
  }
  return f;
}

struct Figures {
  int wrong = 0;
  int pixels_below_zero = 0;
};

template <std::size_t kUpper, bool kForProduct>
struct Pair {
  JoinedRun<kUpper, kForProduct> joined;
  SecondDifferenceRun<2> apart;

  void start(const Parabola& lower, const Parabola& upper) {
    const std::array<Parabola, 2> both = kUpper == 0 ? std::array{upper, lower} : std::array{lower, upper};
    for (std::size_t i = 0; i < 2; ++i) {
      joined.start_at(i, both[i]);
      apart.start_at(i, both[i]);
    }
  }
  void compare(Figures& figures) const {
    const Cosine lower = apart.scalars()[1 - kUpper];
    const Cosine upper = apart.scalars()[kUpper];
    figures.pixels_below_zero += lower.raw() < 0 ? 1 : 0;
    figures.wrong += joined.scalars() == apart.scalars() ? 0 : 1;
    figures.wrong += joined.lower() == lower && joined.upper() == upper ? 0 : 1;
    if constexpr (kForProduct) {
      constexpr std::int32_t kLeast =
          INT32_MIN + (1 << 14);  // rounding the upper scalar would overflow below
      if (upper.raw() < kLeast) return;
      const std::int32_t product = wrap_mul(round_shift(lower.raw(), 15), round_shift(upper.raw(), 15));
      figures.wrong += joined.minus_product() == wrap_sub(0, product) ? 0 : 1;
    }
  }
};

/// Steps a row of `count` pixels by 2^bits pixels from the pixel `skipped` on.
template <class Runs>
void compare_row(Runs runs, std::int32_t count, std::int32_t skipped, int bits, Figures& figures) {
  if (skipped != 0) {
    runs.joined.skip(skipped);
    runs.apart.skip(skipped);
  }
  if (bits != 0) figures.wrong += runs.joined.stride(bits) == runs.apart.stride(bits) ? 0 : 1;
  for (std::int32_t i = skipped; i < count; i += 1 << bits) {
    runs.compare(figures);
    runs.joined.next();
    runs.apart.next();
  }
}

template <std::size_t kUpper, bool kForProduct>
Figures compare_rows() {
  Random random(182);
  Figures figures;
  for (int i = 0; i < share_of(4000); ++i) {
    const std::int32_t count = random.integer(1, 128);
    const std::int32_t skipped = random.integer(0, count - 1);
    const int bits = random.integer(1, 4);
    Pair<kUpper, kForProduct> runs;
    const Parabola lower = lower_parabola(random, count);
    runs.start(lower, {any_cosine(random), any_cosine(random), any_cosine(random)});
    compare_row(runs, count, 0, 0, figures);
    compare_row(runs, count, skipped, 0, figures);
    compare_row(runs, count, skipped, bits, figures);
  }
  return figures;
}

}  // namespace

TEST_CASE("scalars in one register have the bits of scalars stepped apart") {
  const Figures figures = compare_rows<0, false>();
  CHECK(figures.wrong == 0);
  CHECK(figures.pixels_below_zero > share_of(4000));
}

TEST_CASE("scalars in one register for their product have the bits of scalars stepped apart") {
  const Figures figures = compare_rows<1, true>();
  CHECK(figures.wrong == 0);
  CHECK(figures.pixels_below_zero > share_of(4000));
}
