// SPDX-License-Identifier: MIT
#include <arcspan/shading/surface/normalise.hpp>

#include <catch2/catch.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

using namespace arcspan;

namespace {

/// The factor of lengthening() - 1, of an e with 30 fraction bits.
double exact_lengthening(std::int64_t e) { return 1 / std::sqrt(1 - std::ldexp(double(e), -30)) - 1; }

constexpr std::int64_t kOne = std::int64_t{1} << 30;

}  // namespace

TEST_CASE("the inverse of a length is as accurate as stated") {
  struct Range {
    std::int64_t first;
    std::int64_t end;
    double error;
  };
  // e is at most 1/3 if the normals are up to 60 degrees apart. Slightly below 0 it is an error of rounding.
  for (const Range& range :
       {Range{-kOne / 64, 0, 2.2e-4}, Range{0, kOne / 3, 1.5e-4}, Range{kOne / 3, kOne / 4 * 3, 8e-4}}) {
    double worst = 0;
    for (std::int64_t e = range.first; e < range.end; e += test::stride_of(7919)) {
      const double k = std::ldexp(lengthening(static_cast<std::int32_t>(e)), -15);
      worst = std::max(worst, std::abs(k - exact_lengthening(e)));
    }
    CHECK(worst < range.error);
  }
}

TEST_CASE("the inverse of a length is 2 from e = 3/4 to 63/64") {
  for (std::int64_t e = kOne / 4 * 3; e < kOne / 64 * 63; e += test::stride_of(104729)) {
    REQUIRE(lengthening(static_cast<std::int32_t>(e)) == 1 << 15);
  }
}

TEST_CASE("the inverse of a length does not fall with e by more than its rounding") {
  std::int32_t last = 0;
  for (std::int64_t e = 0; e < kOne / 64 * 63; e += test::stride_of(4093)) {
    const std::int32_t k = lengthening(static_cast<std::int32_t>(e));
    REQUIRE(k >= last - 3);
    last = k;
  }
}

TEST_CASE("any argument gives a lengthening of a magnitude below 4") {
  const auto stride = static_cast<std::uint32_t>(test::stride_of(65521));
  std::uint32_t e = 0;
  do {
    REQUIRE(std::abs(lengthening(static_cast<std::int32_t>(e))) < 4 << 15);
    e += stride;
  } while (e >= stride);
}

TEST_CASE("a scalar is lengthened with its sign") {
  CHECK(lengthened(Cosine::of(0.5), 0) == Cosine::of(0.5));
  CHECK(lengthened(Cosine::of(0.5), 1 << 15) == Cosine::of(1.0));
  CHECK(lengthened(Cosine::of(-0.5), 1 << 14) == Cosine::of(-0.75));
}
