// SPDX-License-Identifier: MIT
// Every pixel of random triangles against the exact top-left rule.
#include <catch2/catch.hpp>
#include <tests/support/coverage.hpp>
#include <tests/support/random.hpp>
#include <tests/support/raster_stage.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <initializer_list>
#include <string>

using namespace arcspan;
using namespace arcspan::test;

namespace {

constexpr std::int32_t kLimit = 16 * kGuardBand;

struct Triangle {
  Point corner[3];
};

std::int64_t clamped(double v) {
  return std::clamp(static_cast<std::int64_t>(std::floor(v)), std::int64_t{-kLimit},
                    std::int64_t{kLimit - 1});
}

/// Half of the coordinates on pixel borders or centres, where ties are.
std::int64_t perhaps_on_edge(Random& random, std::int64_t v) {
  return random.chance(0.5) ? v : std::clamp<std::int64_t>(v & ~std::int64_t{7}, -kLimit, kLimit - 1);
}

Triangle random_triangle(Random& random, double smallest, double largest, double spread) {
  const double size = 16 * random.decades(smallest, largest);
  const double x = 16 * random.real(-spread, spread);
  const double y = 16 * random.real(-spread, spread);
  Triangle t;
  for (Point& p : t.corner) {
    p.x = perhaps_on_edge(random, clamped(x + random.real(-size, size)));
    p.y = perhaps_on_edge(random, clamped(y + random.real(-size, size)));
  }
  const int shape = random.integer(0, 15);
  if (shape == 0) t.corner[1].y = t.corner[0].y;
  if (shape == 1) t.corner[1].x = t.corner[0].x;
  if (shape == 2) t.corner[2] = t.corner[0];
  // A sliver: the third corner beside the line of the other two.
  if (shape == 3 || shape == 4) {
    const double along = random.real(-0.1, 1.1);
    const auto between = [along](std::int64_t p, std::int64_t q) {
      return clamped(static_cast<double>(p) + along * static_cast<double>(q - p));
    };
    t.corner[2] = {between(t.corner[0].x, t.corner[1].x) + random.integer(-1, 1),
                   between(t.corner[0].y, t.corner[1].y) + random.integer(-1, 1)};
    t.corner[2].x = std::clamp<std::int64_t>(t.corner[2].x, -kLimit, kLimit - 1);
    t.corner[2].y = std::clamp<std::int64_t>(t.corner[2].y, -kLimit, kLimit - 1);
  }
  return t;
}

/// Draws triangles into one picture and compares each with the reference.
class Comparison {
 public:
  Comparison(std::int32_t width, std::int32_t height)
      : sink_({0, 0, width, height}), stage_(sink_, width, height) {}

  /// The number of pixels that differ from the reference, or that the sink complains of.
  std::uint64_t faults(const Triangle& t) {
    const Rect area = box(t);
    sink_.clear(area);
    draw(t);
    const CoverageReference reference(t.corner[0], t.corner[1], t.corner[2]);
    const RasterOrigin origin = stage_.origin();
    std::uint64_t wrong = 0;
    for (std::int32_t y = area.top; y < area.bottom; ++y) {
      CoverageReference::Row row = reference.row_from(area.left - origin.x, y - origin.y);
      for (const StrictSink::Cell& cell : sink_.cells(area.left, area.right, y)) {
        const bool drawn = cell.count != 0;
        wrong += drawn != row.next() ? 1u : 0u;
        covered_ += drawn ? 1u : 0u;
      }
    }
    const SinkFaults f = sink_.faults();
    sink_.clear(area);
    return wrong + f.outside + f.twice + f.unpaired + f.empty_run + escaped();
  }
  [[nodiscard]] std::uint64_t covered() const { return covered_; }

  /// The triangle as text, a character per pixel: '#' where it is drawn and '.' where it is not, both
  /// rightly; 'x' drawn though the rule says no, and 'o' not drawn though it says yes.
  std::string picture(const Triangle& t) {
    constexpr std::int32_t kMost = 100;
    const Rect area = box(t);
    sink_.clear(area);
    draw(t);
    const CoverageReference reference(t.corner[0], t.corner[1], t.corner[2]);
    const RasterOrigin origin = stage_.origin();
    std::string text = "\n";
    for (std::int32_t y = area.top; y < std::min(area.bottom, area.top + kMost); ++y) {
      CoverageReference::Row row = reference.row_from(area.left - origin.x, y - origin.y);
      for (const StrictSink::Cell& cell :
           sink_.cells(area.left, std::min(area.right, area.left + kMost), y)) {
        const bool drawn = cell.count != 0;
        const bool right = drawn == row.next();
        text += right ? (drawn ? '#' : '.') : (drawn ? 'x' : 'o');
      }
      text += '\n';
    }
    static_cast<void>(sink_.faults());
    sink_.clear(area);
    return text;
  }

 private:
  void draw(const Triangle& t) {
    const auto vertex = [](Point p) {
      return at(static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y));
    };
    stage_.draw(vertex(t.corner[0]), vertex(t.corner[1]), vertex(t.corner[2]));
  }
  /// The pixels that the triangle could reach, with a margin of one, within the picture.
  [[nodiscard]] Rect box(const Triangle& t) const {
    const auto [left, right] =
        std::minmax({t.corner[0].x, t.corner[1].x, t.corner[2].x}, std::less<std::int64_t>{});
    const auto [top, bottom] =
        std::minmax({t.corner[0].y, t.corner[1].y, t.corner[2].y}, std::less<std::int64_t>{});
    const RasterOrigin o = stage_.origin();
    const Rect picture = sink_.bounds();
    const auto pixel = [](std::int64_t v) { return static_cast<std::int32_t>(v >> 4); };
    Rect r{std::max(pixel(left) - 1 + o.x, picture.left), std::max(pixel(top) - 1 + o.y, picture.top),
           std::min(pixel(right) + 2 + o.x, picture.right),
           std::min(pixel(bottom) + 2 + o.y, picture.bottom)};
    if (r.right < r.left) r.right = r.left;
    if (r.bottom < r.top) r.bottom = r.top;
    return r;
  }
  /// Pixels drawn outside the area that was looked at; the whole picture is looked over now and then.
  std::uint64_t escaped() {
    if (++count_ % 1024 != 0) return 0;
    return sink_.drawn();
  }

  StrictSink sink_;
  RasterStage<Silhouette, StrictSink> stage_;
  std::uint64_t covered_ = 0;
  std::uint64_t count_ = 0;
};

void compare(Comparison& comparison, Random& random, int count, double smallest, double largest,
             double spread) {
  std::uint64_t faults = 0;
  std::string first;
  for (int i = 0; i < share_of(count); ++i) {
    const Triangle t = random_triangle(random, smallest, largest, spread);
    const std::uint64_t wrong = comparison.faults(t);
    if (wrong != 0 && faults == 0) {
      for (const Point& p : t.corner) first += std::to_string(p.x) + ", " + std::to_string(p.y) + "; ";
      first += comparison.picture(t);
    }
    faults += wrong;
  }
  INFO("first wrong triangle in 16ths: " << first);
  CHECK(faults == 0);
}

/// Draws triangles, whose corners are in 16ths of a pixel from the middle of the picture, into a picture of
/// 16x12 pixels: as text with the number of triangles that cover each pixel, and '.' for none.
std::string raster(std::initializer_list<Triangle> triangles) {
  constexpr std::int32_t kWidth = 16;
  constexpr std::int32_t kHeight = 12;
  StrictSink sink({0, 0, kWidth, kHeight});
  RasterStage<Silhouette, StrictSink> stage(sink, kWidth, kHeight);
  std::string text(static_cast<std::size_t>((kWidth + 1) * kHeight), '.');
  for (const Triangle& t : triangles) {
    sink.clear(sink.bounds());
    const auto vertex = [](Point p) {
      return at(static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y));
    };
    stage.draw(vertex(t.corner[0]), vertex(t.corner[1]), vertex(t.corner[2]));
    for (std::int32_t y = 0; y < kHeight; ++y) {
      text[static_cast<std::size_t>(y * (kWidth + 1) + kWidth)] = '\n';
      for (std::int32_t x = 0; x < kWidth; ++x) {
        char& pixel = text[static_cast<std::size_t>(y * (kWidth + 1) + x)];
        if (sink.cell(x, y).count != 0) pixel = pixel == '.' ? '1' : static_cast<char>(pixel + 1);
      }
    }
  }
  return text;
}

}  // namespace

// The corners are pixel centres, so that every tie of the rule occurs: the upper and the left edge belong to
// the square, the lower and the right edge do not, and the diagonal belongs to one of the halves.
TEST_CASE("a square of two triangles covers every pixel once, without its lower and right edge") {
  constexpr std::int64_t kLow = -4 * 16 + 8;
  constexpr std::int64_t kHigh = 4 * 16 + 8;
  const std::string picture = raster(
      {{{{kLow, kLow}, {kLow, kHigh}, {kHigh, kHigh}}}, {{{kLow, kLow}, {kHigh, kHigh}, {kHigh, kLow}}}});
  CHECK(picture ==
        "................\n"
        "................\n"
        "....11111111....\n"
        "....11111111....\n"
        "....11111111....\n"
        "....11111111....\n"
        "....11111111....\n"
        "....11111111....\n"
        "....11111111....\n"
        "....11111111....\n"
        "................\n"
        "................\n");
}

TEST_CASE("a fan of triangles around a pixel centre covers that pixel once") {
  const Point middle{8, 8};
  const Point top{8, -70};
  const Point right{100, 8};
  const Point bottom{8, 80};
  const Point left{-100, 8};
  const std::string picture = raster(
      {{{middle, top, left}}, {{middle, left, bottom}}, {{middle, bottom, right}}, {{middle, right, top}}});
  CHECK(picture ==
        "................\n"
        "................\n"
        ".......111......\n"
        "......11111.....\n"
        ".....1111111....\n"
        "...1111111111...\n"
        "..111111111111..\n"
        "...1111111111...\n"
        ".....1111111....\n"
        "......1111......\n"
        "........1.......\n"
        "................\n");
}

TEST_CASE("coverage is the top-left rule: small triangles") {
  Random random(1);
  Comparison comparison(160, 120);
  compare(comparison, random, 400000, 0.05, 40, 70);
  CHECK(comparison.covered() > static_cast<std::uint64_t>(share_of(1000000)));
}

TEST_CASE("coverage is the top-left rule: triangles partly or wholly off the screen") {
  Random random(2);
  Comparison comparison(33, 47);
  compare(comparison, random, 50000, 1, 1024, 100);
  CHECK(comparison.covered() > static_cast<std::uint64_t>(share_of(1000000)));
}

TEST_CASE("coverage is the top-left rule: edges over the whole height") {
  // Their distance from a pixel centre gets as small as 2^-19 of a pixel: it takes millions of rows.
  Random random(4);
  Comparison comparison(40, 2048);
  std::uint64_t faults = 0;
  for (int i = 0; i < share_of(2500); ++i) {
    Triangle t;
    t.corner[0] = {random.integer(-400, 400), random.integer(-kLimit, -kLimit + 999)};
    t.corner[1] = {random.integer(-400, 400), random.integer(kLimit - 999, kLimit - 1)};
    t.corner[2] = {random.integer(-400, 400), random.integer(-kLimit, kLimit - 1)};
    faults += comparison.faults(t);
  }
  CHECK(faults == 0);
}

TEST_CASE("coverage is the top-left rule: the whole guard band") {
  Random random(3);
  Comparison comparison(2048, 2048);
  compare(comparison, random, 150, 100, 1024, 300);
  // The corners themselves.
  const std::int64_t low = -kLimit;
  const std::int64_t high = kLimit - 1;
  CHECK(comparison.faults({{{low, low}, {high, low}, {high, high}}}) == 0);
  CHECK(comparison.faults({{{low, low}, {high, high}, {low, high}}}) == 0);
  CHECK(comparison.faults({{{low, low}, {high, low + 1}, {low, low + 2}}}) == 0);
  CHECK(comparison.faults({{{low, high - 17}, {high, high - 16}, {high, high}}}) == 0);
  CHECK(comparison.covered() > static_cast<std::uint64_t>(share_of(10000000)));
}
