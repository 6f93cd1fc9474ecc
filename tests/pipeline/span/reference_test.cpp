// SPDX-License-Identifier: MIT
// The rasterisation truths that others have published.
#include <catch2/catch.hpp>
#include <tests/support/raster_stage.hpp>

#include <cmath>
#include <numbers>

using namespace arcspan;
using namespace arcspan::test;

namespace {

struct Screen {
  Screen(std::int32_t width, std::int32_t height)
      : sink({0, 0, width, height}), stage(sink, width, height), origin(stage.origin()) {}

  /// A vertex at (x, y) pixels from the picture's corner; snapped to 28.4, to nearest.
  [[nodiscard]] RasterVertex<Silhouette> vertex(double x, double y) const {
    return at(static_cast<std::int32_t>(std::lround(16 * x)) - 16 * origin.x,
              static_cast<std::int32_t>(std::lround(16 * y)) - 16 * origin.y);
  }
  void triangle(const RasterVertex<Silhouette>& a, const RasterVertex<Silhouette>& b,
                const RasterVertex<Silhouette>& c) {
    stage.draw(a, b, c);
  }

  StrictSink sink;
  RasterStage<Silhouette, StrictSink> stage;
  RasterOrigin origin;
};

}  // namespace

TEST_CASE("a rectangle of 5 by 5 and its halves cover 25, 15 and 10 pixels") {
  // The source has pixel centres at integers; ours are half a pixel further.
  const double h = 0.5;
  SECTION("rectangle") {
    Screen s(8, 8);
    s.triangle(s.vertex(0 + h, 0 + h), s.vertex(5 + h, 0 + h), s.vertex(5 + h, 5 + h));
    s.triangle(s.vertex(0 + h, 5 + h), s.vertex(0 + h, 0 + h), s.vertex(5 + h, 5 + h));
    CHECK(s.sink.drawn() == 25);
    CHECK(s.sink.faults() == SinkFaults{});
  }
  SECTION("upper right half, with the diagonal: its left edge") {
    Screen s(6, 6);
    s.triangle(s.vertex(0 + h, 0 + h), s.vertex(5 + h, 0 + h), s.vertex(5 + h, 5 + h));
    CHECK(s.sink.text() == "#####\n ####\n  ###\n   ##\n    #\n\n");
    CHECK(s.sink.drawn() == 15);
  }
  SECTION("lower left half, without it") {
    Screen s(6, 6);
    s.triangle(s.vertex(0 + h, 5 + h), s.vertex(0 + h, 0 + h), s.vertex(5 + h, 5 + h));
    CHECK(s.sink.text() == "\n#\n##\n###\n####\n\n");
    CHECK(s.sink.drawn() == 10);
  }
}

TEST_CASE("two triangles on 8 by 8 leave no hole along the diagonal") {
  Screen s(8, 8);
  const auto v0 = s.vertex(0.5, 0.49993896484375);
  const auto v1 = s.vertex(0.5, 6.5);
  const auto v2 = s.vertex(6.50006103515625, 0.49993896484375);
  const auto v3 = s.vertex(6.50006103515625, 6.5);
  s.triangle(v0, v1, v2);
  s.triangle(v3, v2, v1);
  CHECK(s.sink.faults() == SinkFaults{});
  CHECK(s.sink.text() == "######\n######\n######\n######\n######\n######\n\n\n");
}

TEST_CASE("a grid of quads rotated through 90 degrees covers no pixel twice and misses none") {
  constexpr std::int32_t kSize = 96;
  for (int step = 0; step <= 32; ++step) {
    const double angle = step * std::numbers::pi / 64;
    Screen s(kSize, kSize);
    const auto corner = [&](int i, int j) {
      const double x = (i - 2) * 14.0;
      const double y = (j - 2) * 14.0;
      return s.vertex(kSize / 2 + x * std::cos(angle) - y * std::sin(angle),
                      kSize / 2 + x * std::sin(angle) + y * std::cos(angle));
    };
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        s.triangle(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1));
        s.triangle(corner(i, j), corner(i + 1, j + 1), corner(i, j + 1));
      }
    }
    INFO("step " << step << "\n" << s.sink.text());
    CHECK(s.sink.faults() == SinkFaults{});
    // Holes: the grid is convex, so a row that is not one run has one.
    int holes = 0;
    for (std::int32_t y = 0; y < kSize; ++y) {
      int ends = 0;
      for (std::int32_t x = 0; x < kSize; ++x) {
        const bool here = s.sink.cell(x, y).count != 0;
        const bool next = x + 1 < kSize && s.sink.cell(x + 1, y).count != 0;
        ends += here && !next ? 1 : 0;
      }
      holes += ends > 1 ? 1 : 0;
    }
    CHECK(holes == 0);
    CHECK(std::abs(static_cast<double>(s.sink.drawn()) - 56.0 * 56.0) < 60);
  }
}
