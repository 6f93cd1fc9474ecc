// SPDX-License-Identifier: MIT
// What is linear on the screen, depth and Gouraud's colours, against the plane through the three corners.
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>

#include <catch2/catch.hpp>
#include <tests/support/coverage.hpp>
#include <tests/support/random.hpp>
#include <tests/support/raster_stage.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;
using Method = Gouraud<Illumination<1, Highlight::kBlinn>>;
using Vertex = RasterVertex<Method>;

namespace {

constexpr std::int32_t kSize = 256;

/// Value at a pixel centre by barycentric coordinates.
double plane_at(const Vertex (&v)[3], const double (&value)[3], std::int32_t column, std::int32_t row) {
  const double x = 16.0 * column + 8;
  const double y = 16.0 * row + 8;
  double sum = 0;
  double area = 0;
  for (int i = 0; i < 3; ++i) {
    const RasterPosition& p = v[(i + 1) % 3].position;
    const RasterPosition& q = v[(i + 2) % 3].position;
    const double weight = (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
    sum += weight * value[i];
    area += weight;
  }
  return sum / area;
}

enum class Shape { kAny, kSliver, kThinnest, kHuge };

std::int16_t snapped(double c) {
  return static_cast<std::int16_t>(std::clamp(std::lround(c), -16384l, 16383l));
}

/// A long line through the centre of a pixel, and of some points beside it the nearest.
void thinnest_corners(Random& random, Vertex (&v)[3]) {
  const double dx = random.chance(0.3) ? random.integer(-200, 200) : random.integer(-8000, 8000);
  const double dy = random.integer(200, 16000);
  const double above = random.unit();
  v[0].position.x = snapped(8 - above * dx);
  v[0].position.y = snapped(8 - above * dy);
  v[1].position.x = snapped(v[0].position.x + dx);
  v[1].position.y = snapped(v[0].position.y + dy);
  std::int32_t least = INT32_MAX;
  for (int k = 0; k < 6; ++k) {
    const double t = random.real(-0.1, 1.1);
    const RasterPosition beside{snapped(v[0].position.x + t * dx + random.integer(0, 1)),
                                snapped(v[0].position.y + t * dy), 0};
    const std::int32_t area = std::abs(doubled_area(v[0].position, v[1].position, beside));
    if (area == 0 || area >= least) continue;
    least = area;
    v[2].position = beside;
  }
}

void random_corners(Random& random, Shape shape, Vertex (&v)[3]) {
  const double size = shape == Shape::kHuge ? 16000 : 16 * random.decades(0.5, 120);
  const double x = shape == Shape::kHuge ? 0 : random.real(-1500, 1500);
  const double y = shape == Shape::kHuge ? 0 : random.real(-1500, 1500);
  if (shape == Shape::kThinnest) return thinnest_corners(random, v);
  for (Vertex& vertex : v) {
    vertex.position.x = snapped(x + random.real(-size, size));
    vertex.position.y = snapped(y + random.real(-size, size));
  }
  if (shape == Shape::kSliver) {
    const double t = random.unit();
    v[2].position.x =
        snapped(v[0].position.x + t * (v[1].position.x - v[0].position.x) + random.real(-12, 12));
    v[2].position.y =
        snapped(v[0].position.y + t * (v[1].position.y - v[0].position.y) + random.real(-12, 12));
  }
}

struct Figures {
  std::uint64_t pixels = 0;
  double colour = 0;   ///< largest error in 8-bit steps, unrounded truth
  double depth = 0;    ///< largest error of the depth buffer, in its units
  double outside = 0;  ///< how far depths leave the range of the corners'
};

double outside(double value, const double (&corner)[3]) {
  const auto [low, high] = std::minmax({corner[0], corner[1], corner[2]});
  return std::max({0.0, low - value, value - high});
}

Figures measure(Shape shape, int triangles, std::uint64_t seed, std::int32_t margin) {
  Random random(seed);
  Figures figures;
  StrictSink sink({0, 0, kSize, kSize});
  std::vector<std::uint16_t> memory(DepthBuffer::words(kSize, kSize));
  DepthBuffer depth(memory, kSize, kSize);
  RasterStage<Method, StrictSink, DepthBuffer> stage(sink, kSize, kSize, {}, depth);
  for (int i = 0; i < triangles; ++i) {
    Vertex v[3];
    random_corners(random, shape, v);
    double red[3];
    double z[3];
    for (int k = 0; k < 3; ++k) {
      // The extremes are as frequent as all that is between them.
      const auto level = [&] {
        return random.chance(0.5) ? 65280 * random.integer(0, 1) : random.integer(0, 65280);
      };
      v[k].shade = {level(), level(), level()};
      v[k].position.z =
          static_cast<std::uint16_t>(random.chance(0.5) ? (random.chance(0.5) ? margin : 65535 - margin)
                                                        : random.integer(margin, 65535 - margin));
      red[k] = v[k].shade.r / 256.0;
      z[k] = v[k].position.z;
    }
    sink.clear();
    depth.clear();
    stage.draw(v[0], v[1], v[2]);
    for (std::int32_t y = 0; y < kSize; ++y) {
      for (std::int32_t x = 0; x < kSize; ++x) {
        if (sink.cell(x, y).count == 0) continue;
        ++figures.pixels;
        const double r = plane_at(v, red, x - kSize / 2, y - kSize / 2);
        const double d = plane_at(v, z, x - kSize / 2, y - kSize / 2);
        figures.colour = std::max(figures.colour, std::abs(sink.cell(x, y).colour.r - r));
        figures.depth = std::max(figures.depth, std::abs(depth.row(y)[x] - d));
        figures.outside = std::max(figures.outside, outside(depth.row(y)[x], z));
      }
    }
  }
  return figures;
}

}  // namespace

TEST_CASE("Gouraud's colours and the depth are the plane through the corners") {
  const Figures f = measure(Shape::kAny, share_of(4000), 71, 256);
  INFO("colour " << f.colour << ", depth " << f.depth);
  CHECK(f.pixels > static_cast<std::uint64_t>(share_of(700000)));
  CHECK(f.colour < 0.6);
  CHECK(f.depth < 12);
}

TEST_CASE("slivers have the colours and depths of the plane, too") {
  const Figures f = measure(Shape::kSliver, share_of(12000), 72, 256);
  INFO("colour " << f.colour << ", depth " << f.depth);
  CHECK(f.pixels > static_cast<std::uint64_t>(share_of(40000)));
  CHECK(f.colour < 0.6);
  CHECK(f.depth < 12);
}

TEST_CASE("the thinnest slivers stay in the corners' range") {
  const Figures f = measure(Shape::kThinnest, share_of(4000), 74, 0);
  INFO("colour " << f.colour << ", depth " << f.depth);
  CHECK(f.pixels > static_cast<std::uint64_t>(share_of(3000)));
  CHECK(f.colour < 1.5);
  CHECK(f.depth < 320);  // widths of 2^-16 pixels, whose edges are off by 2^-21
  CHECK(f.outside == 0);
}

TEST_CASE("over the whole guard band the plane holds too") {
  const Figures f = measure(Shape::kHuge, 60, 73, 256);
  INFO("colour " << f.colour << ", depth " << f.depth);
  CHECK(f.pixels > 1000000);
  CHECK(f.colour < 0.7);
  CHECK(f.depth < 16);
}

TEST_CASE("a flat colour and a level depth are exact") {
  Random random(74);
  StrictSink sink({0, 0, kSize, kSize});
  std::vector<std::uint16_t> memory(DepthBuffer::words(kSize, kSize));
  DepthBuffer depth(memory, kSize, kSize);
  RasterStage<Method, StrictSink, DepthBuffer> stage(sink, kSize, kSize, {}, depth);
  std::uint64_t wrong = 0;
  std::uint64_t pixels = 0;
  for (int i = 0; i < share_of(500); ++i) {
    Vertex v[3];
    random_corners(random, Shape::kAny, v);
    const auto level = static_cast<std::uint8_t>(random.integer(0, 255));
    for (Vertex& vertex : v) {
      vertex.shade = {level * 256, 65280, 0};
      vertex.position.z = 12345;
    }
    sink.clear();
    depth.clear();
    stage.draw(v[0], v[1], v[2]);
    for (std::int32_t y = 0; y < kSize; ++y) {
      for (std::int32_t x = 0; x < kSize; ++x) {
        if (sink.cell(x, y).count == 0) continue;
        ++pixels;
        wrong += sink.cell(x, y).colour == Rgb8{level, 255, 0} && depth.row(y)[x] == 12345 ? 0u : 1u;
      }
    }
  }
  CHECK(pixels > static_cast<std::uint64_t>(share_of(100000)));
  CHECK(wrong == 0);
}

TEST_CASE("flat shading gives every pixel the face's colour") {
  using Flat1 = Flat<Illumination<1, Highlight::kBlinn>>;
  StrictSink sink({0, 0, 32, 32});
  RasterStage<Flat1, StrictSink> stage(sink, 32, 32);
  stage.draw(at(-200, -150), at(-100, 220), at(230, 90), PackedRgb::of(4 * 10 + 2, 4 * 20 + 2, 4 * 30 + 2));
  std::uint64_t wrong = 0;
  for (std::int32_t y = 0; y < 32; ++y) {
    for (std::int32_t x = 0; x < 32; ++x) {
      const StrictSink::Cell& cell = sink.cell(x, y);
      wrong += cell.count == 0 || cell.colour == Rgb8{10, 20, 30} ? 0u : 1u;
    }
  }
  CHECK(sink.drawn() > 200);
  CHECK(wrong == 0);
}
