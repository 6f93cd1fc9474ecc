// SPDX-License-Identifier: MIT
// The depth test of pixels beside outlines, against the exact depth of the edge.
#include <arcspan/outline/outline_depth.hpp>
#include <arcspan/prepare/edge.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cstdlib>

using namespace arcspan;
using namespace arcspan::test;

namespace {

constexpr std::int32_t kNearest = ClipTransform::kDepthMargin;
constexpr std::int32_t kFarthest = 65535 - ClipTransform::kDepthMargin;

RasterPosition random_end(Random& random, std::int32_t most, bool extreme) {
  const auto place = [&] {
    if (extreme) return static_cast<std::int16_t>(random.chance(0.5) ? most : -most);
    return static_cast<std::int16_t>(random.integer(-most, most));
  };
  const std::int32_t z = extreme ? (random.chance(0.5) ? kNearest : kFarthest)
                                 : random.integer(kNearest, random.chance(0.5) ? kNearest + 20 : kFarthest);
  const std::int16_t x = place();
  return {x, place(), static_cast<std::uint16_t>(z)};
}

/// The depth of an edge on the centre line of a row, rounded down; beyond the ends that of the end.
std::int64_t exact_depth(const RasterPosition& from, const RasterPosition& to, bool exchanged,
                         std::int32_t row) {
  const std::int64_t begin = exchanged ? from.x : from.y;
  const std::int64_t end = exchanged ? to.x : to.y;
  const std::int64_t centre =
      std::clamp<std::int64_t>(16 * row + 8, std::min(begin, end), std::max(begin, end));
  const std::int64_t part = std::abs(centre - begin);
  const std::int64_t whole = std::abs(end - begin);
  const std::int64_t product = (to.z - from.z) * part;
  return from.z + (product >= 0 ? product / whole : -((-product + whole - 1) / whole));
}

}  // namespace

TEST_CASE("Outline depth: a pixel is compared with the exact depth of the edge, rounded down") {
  Random random(50);
  for (int i = 0; i < share_of(200000); ++i) {
    const std::int32_t most = random.chance(0.3) ? 16383 : random.chance(0.5) ? 2000 : 60;
    const bool extreme = i % 50 == 0;
    OutlineEdge edge{random_end(random, most, extreme), random_end(random, most, extreme)};
    const std::int32_t dx = std::abs(edge.to.x - edge.from.x);
    const std::int32_t dy = std::abs(edge.to.y - edge.from.y);
    if (dx == 0 && dy == 0) continue;
    const bool exchanged = dy < dx;
    detail::OutlineDepth depth;
    depth.begin(edge, exchanged);
    const std::uint16_t farther = std::max(edge.from.z, edge.to.z);
    CHECK_FALSE(depth.may_hide(farther));
    CHECK(depth.may_hide(static_cast<std::uint16_t>(farther - 1)));
    const std::int32_t a = exchanged ? edge.from.x : edge.from.y;
    const std::int32_t b = exchanged ? edge.to.x : edge.to.y;
    const std::int32_t row =
        random.integer(first_row_at(std::min(a, b)) - 4, first_row_at(std::max(a, b)) + 4);
    const std::int64_t z = exact_depth(edge.from, edge.to, exchanged, row);
    const std::int64_t tested[] = {z - 1, z, z + 1, random.integer(0, 65535), 0, 65535};
    for (const std::int64_t pixel : tested)
      if (depth.is_behind(static_cast<std::uint16_t>(pixel), row) != (pixel < z)) FAIL(pixel << " " << z);
  }
}
