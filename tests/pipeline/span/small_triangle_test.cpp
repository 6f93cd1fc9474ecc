// SPDX-License-Identifier: MIT
// Small triangles, drawn by columns stepped down their edges and by barycentric coordinates, against the
// exact rules and against the rows of a TriangleCommand.
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <catch2/catch.hpp>
#include <tests/support/coverage.hpp>
#include <tests/support/random.hpp>
#include <tests/support/raster_stage.hpp>
#include <tests/support/strict_sink.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Light = Illumination<1, Highlight::kPhong>;
using Method = Arc<Light>;
constexpr std::int32_t kWidth = 40;
constexpr std::int32_t kHeight = 30;

Light shiny() {
  Material material;
  material.ambient = {Coefficient::of(0.1), Coefficient::of(0.1), Coefficient::of(0.1)};
  material.diffuse = {Coefficient::of(0.7), Coefficient::of(0.5), Coefficient::of(0.3)};
  material.specular = {Coefficient::of(0.4), Coefficient::of(0.4), Coefficient::of(0.4)};
  material.shininess = 8;
  Light light;
  REQUIRE(ok(Light::make(material, {DirectionalLight{normalised(3, 4, 5)}}, normalised(0, 0, 1), light)));
  return light;
}

using Triangle = std::array<RasterVertex<Method>, 3>;

SortedVertices<Method> sorted(const Triangle& t) {
  const bool is_front = doubled_area(t[0].position, t[1].position, t[2].position) < 0;
  SortedVertices<Method> vertices{&t[0], &t[1], &t[2], is_front};
  arcspan::detail::sort_by_height(vertices);
  return vertices;
}

/// A triangle with area that is_small(), anywhere about the picture. Many have corners on pixel centres and
/// borders, horizontal or vertical edges, or are slivers. With a `widest` of 100 normals are up to 120
/// degrees apart.
Triangle random_triangle(Random& random, const Light& light, int widest) {
  while (true) {
    const std::int32_t x = random.integer(-16 * 26, 16 * 20);
    const std::int32_t y = random.integer(-16 * 21, 16 * 14);
    const std::int32_t size = random.chance(0.3) ? random.integer(1, 60) : kSmallSize * 16;
    const int grid = random.chance(0.5) ? ~7 : ~0;
    Triangle t;
    const std::int32_t nx = random.integer(-100, 100);
    const std::int32_t ny = random.integer(-100, 100);
    const int spread = random.integer(0, widest);
    for (RasterVertex<Method>& v : t) {
      v.position.x = static_cast<std::int16_t>((x + random.integer(0, size)) & grid);
      v.position.y = static_cast<std::int16_t>((y + random.integer(0, size)) & grid);
      v.position.z = static_cast<std::uint16_t>(random.chance(0.2) ? random.integer(0, 1) * 65535
                                                                   : random.integer(0, 65535));
      v.shade = Method::shade_vertex(
          light, normalised(nx + random.integer(-spread, spread), ny + random.integer(-spread, spread), 100));
    }
    const int shape = random.integer(0, 9);
    if (shape == 0) t[1].position.y = t[0].position.y;
    if (shape == 1) t[1].position.x = t[0].position.x;
    if (shape == 2) {  // a sliver beside the line of the other two
      t[2].position.x =
          static_cast<std::int16_t>((t[0].position.x + t[1].position.x) / 2 + random.integer(-1, 1));
      t[2].position.y =
          static_cast<std::int16_t>((t[0].position.y + t[1].position.y) / 2 + random.integer(-1, 1));
    }
    if (doubled_area(t[0].position, t[1].position, t[2].position) == 0) continue;
    if (is_small(sorted(t))) return t;
  }
}

std::vector<std::uint16_t> far_depths() {
  return std::vector<std::uint16_t>(kWidth * kHeight, DepthBuffer::kFarthest);
}

/// A grey picture with depths that triangles are drawn into.
struct Picture {
  struct Sink {
    using Format = Gray8;
    [[nodiscard]] Rect bounds() const { return {0, 0, kWidth, kHeight}; }
    [[nodiscard]] Format::Cursor open(const Span& run) { return {pixels.data() + run.y * kWidth, run.x}; }
    [[nodiscard]] Status close(const Span&) { return Status::kOk; }
    std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(kWidth * kHeight, 0);
  };

  explicit Picture(const Light& light)
      : stage(sink, kWidth, kHeight, light, DepthBuffer(depths, kWidth, kHeight)) {}

  void draw(const Triangle& t, const Rect& clip = {0, 0, kWidth, kHeight}) {
    stage.clip_to(clip);
    stage.draw(t[0], t[1], t[2]);
  }
  void clear() {
    std::fill(sink.pixels.begin(), sink.pixels.end(), std::uint8_t{0});
    std::fill(depths.begin(), depths.end(), DepthBuffer::kFarthest);
  }

  Sink sink;
  std::vector<std::uint16_t> depths = far_depths();
  RasterStage<Method, Sink, DepthBuffer> stage;
};

/// The depth of the plane through the vertices at a point in 16ths of a pixel.
double plane_depth(const Triangle& t, std::int32_t x, std::int32_t y) {
  const RasterPosition point{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), 0};
  const auto area = [](const RasterPosition& a, const RasterPosition& b, const RasterPosition& c) {
    return static_cast<double>(doubled_area(a, b, c));
  };
  const RasterPosition& a = t[0].position;
  const RasterPosition& b = t[1].position;
  const RasterPosition& c = t[2].position;
  return (area(point, b, c) * a.z + area(a, point, c) * b.z + area(a, b, point) * c.z) / area(a, b, c);
}

}  // namespace

TEST_CASE("columns of an edge are exact, with and without a division") {
  Random random(6);
  int wrong = 0;
  int edges = 0;
  for (int i = 0; i < share_of(100000); ++i) {
    constexpr std::int32_t kLongest = kSmallSize * 16;
    const std::int32_t dx = random.integer(-kLongest, kLongest);
    const std::int32_t dy = random.chance(0.3) ? random.integer(1, 20) : random.integer(1, kLongest);
    const std::int32_t x = random.integer(-16384 + kLongest, 16383 - kLongest);
    const std::int32_t y = random.integer(-16384, 16383 - kLongest);
    const RasterPosition p{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), 0};
    const RasterPosition q{static_cast<std::int16_t>(x + dx), static_cast<std::int16_t>(y + dy), 0};
    const std::int32_t end = first_row_at(q.y);
    std::int32_t row = first_row_at(p.y);
    if (row >= end) continue;
    if (random.chance(0.5)) row = random.integer(row, end - 1);
    arcspan::detail::SteppedColumn stepped(p, q, row * 16 + 8);
    arcspan::detail::SettledColumn settled(p, q, row * 16 + 8);
    while (true) {
      const std::int32_t column = stepped.column();
      // The edge function at the centre of this column; it is positive right of the edge.
      const std::int32_t apart = (column * 16 + 8 - p.x) * dy - (row * 16 + 8 - p.y) * dx;
      wrong += settled.column() == column && apart >= 0 && apart < 16 * dy ? 0 : 1;
      if (++row == end) break;  // below the edge's end its columns would not fit
      stepped.advance();
      settled.advance();
    }
    ++edges;
  }
  CHECK(wrong == 0);
  CHECK(edges > share_of(80000));
}

TEST_CASE("small triangles cover exactly the pixels of the top-left rule") {
  Random random(1);
  const Light light = shiny();
  StrictSink sink({0, 0, kWidth, kHeight});
  RasterStage<Method, StrictSink> stage(sink, kWidth, kHeight, light);
  std::uint64_t covered = 0;
  std::uint64_t wrong = 0;
  for (int i = 0; i < share_of(200000); ++i) {
    const Triangle t = random_triangle(random, light, 40);
    sink.clear(sink.bounds());
    stage.draw(t[0], t[1], t[2]);
    const auto point = [](const RasterVertex<Method>& v) { return Point{v.position.x, v.position.y}; };
    const CoverageReference reference(point(t[0]), point(t[1]), point(t[2]));
    const RasterOrigin origin = stage.origin();
    constexpr std::int32_t kAround = kSmallSize + 2;
    const std::int32_t left = std::max((t[0].position.x >> 4) - kAround + origin.x, 0);
    const std::int32_t top = std::max((t[0].position.y >> 4) - kAround + origin.y, 0);
    std::uint64_t inside = 0;
    for (std::int32_t y = top; y < std::min(top + 2 * kAround + 1, kHeight); ++y) {
      CoverageReference::Row row = reference.row_from(left - origin.x, y - origin.y);
      for (const StrictSink::Cell& cell : sink.cells(left, std::min(left + 2 * kAround + 1, kWidth), y)) {
        const bool drawn = cell.count != 0;
        wrong += drawn != row.next() ? 1u : 0u;
        inside += drawn ? 1u : 0u;
      }
    }
    covered += inside;
    const SinkFaults f = sink.faults();
    wrong += f.outside + f.twice + f.unpaired + f.empty_run + (sink.drawn() - inside);
  }
  CHECK(wrong == 0);
  CHECK(covered > static_cast<std::uint64_t>(share_of(350000)));
}

TEST_CASE("the depth of small triangles is within 7 of 65536 of their plane, and within 10 of that of rows") {
  Random random(2);
  const Light light = shiny();
  Picture small(light);
  Picture rows(light);
  rows.stage.leave_out_small_triangles();
  double lowest = 0;
  double highest = 0;
  double rows_apart = 0;
  for (int i = 0; i < share_of(60000); ++i) {
    const Triangle t = random_triangle(random, light, 40);
    small.clear();
    rows.clear();
    small.draw(t);
    rows.draw(t);
    // Larger ones without arcs are drawn by rows.
    const bool is_large = !is_small(sorted(t));
    if (is_large && small.depths == rows.depths) continue;
    const std::int32_t area = doubled_area(t[0].position, t[1].position, t[2].position);
    for (std::size_t p = 0; p < small.depths.size(); ++p) {
      const std::uint16_t depth = small.depths[p];
      // A pixel at the farthest depth is drawn by neither.
      if (depth == DepthBuffer::kFarthest && rows.depths[p] == DepthBuffer::kFarthest) continue;
      const auto column = static_cast<std::int32_t>(p) % kWidth - kWidth / 2;
      const auto row = static_cast<std::int32_t>(p) / kWidth - kHeight / 2;
      const double plane = plane_depth(t, column * 16 + 8, row * 16 + 8);
      const double above = depth - plane;
      lowest = std::min(lowest, above);
      highest = std::max(highest, above);
      // Rows lose bits in triangles thinner than a pixel.
      if (std::abs(area) > 16 * 16 * 16) {
        rows_apart = std::max(rows_apart, std::abs(depth - static_cast<double>(rows.depths[p])));
      }
    }
  }
  CHECK(lowest > -7);
  CHECK(highest < 7);
  CHECK(rows_apart <= 10);
}

TEST_CASE("triangles that no light reaches have the colour of darkness, however wide their normals are") {
  Random random(5);
  const Light light = shiny();
  Picture picture(light);
  const std::uint8_t dark = encode_at<Gray8>(light.diffuse_colour(Cosine{}), 0, 0);
  int faults = 0;
  std::uint64_t drawn = 0;
  for (int i = 0; i < share_of(100000); ++i) {
    const Triangle t = random_triangle(random, light, 100);
    if (std::any_of(t.begin(), t.end(), [](const auto& v) { return v.shade.scalars[0].raw() > 0; })) continue;
    picture.clear();
    picture.draw(t);
    for (std::size_t p = 0; p < picture.depths.size(); ++p) {
      if (picture.depths[p] == DepthBuffer::kFarthest) continue;
      ++drawn;
      faults += picture.sink.pixels[p] != dark ? 1 : 0;
    }
  }
  CHECK(faults == 0);
  CHECK(drawn > static_cast<std::uint64_t>(share_of(5000)));
}

TEST_CASE("the pixels of small triangles do not depend on the rows of the scissor") {
  Random random(3);
  const Light light = shiny();
  Picture whole(light);
  Picture cut(light);
  int faults = 0;
  for (int i = 0; i < share_of(20000); ++i) {
    const Triangle t = random_triangle(random, light, 100);
    whole.clear();
    cut.clear();
    whole.draw(t);
    const std::int32_t y = random.integer(0, kHeight);
    cut.draw(t, {0, 0, kWidth, y});
    cut.draw(t, {0, y, kWidth, kHeight});
    if (whole.sink.pixels != cut.sink.pixels || whole.depths != cut.depths) ++faults;
  }
  CHECK(faults == 0);
}

TEST_CASE("columns that are cut off change small triangles by rounding only") {
  Random random(4);
  const Light light = shiny();
  Picture whole(light);
  Picture cut(light);
  int furthest = 0;
  int deepest = 0;
  for (int i = 0; i < share_of(20000); ++i) {
    const Triangle t = random_triangle(random, light, 40);
    whole.clear();
    cut.clear();
    whole.draw(t);
    const std::int32_t x = random.integer(0, kWidth);
    cut.draw(t, {0, 0, x, kHeight});
    cut.draw(t, {x, 0, kWidth, kHeight});
    for (std::size_t p = 0; p < whole.depths.size(); ++p) {
      furthest = std::max(furthest, std::abs(whole.sink.pixels[p] - cut.sink.pixels[p]));
      deepest = std::max(deepest, std::abs(whole.depths[p] - cut.depths[p]));
    }
  }
  CHECK(furthest <= 1);
  CHECK(deepest <= 7);
}
