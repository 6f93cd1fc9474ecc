// SPDX-License-Identifier: MIT
// Smoothed pictures: pixels by area, the same in bands and rectangles, and nothing where nothing is to
// change.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/hal/framebuffer_window.hpp>
#include <arcspan/pixel/pixel_format_list.hpp>
#include <arcspan/pixel/sink_part.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/smooth_outlines.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/neighbours.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Light = Illumination<1, Highlight::kBlinn>;
using Method = Flat<Light>;

constexpr Rgb8 kBackground{200, 210, 220};

template <PixelFormat F>
struct PictureOf {
  explicit PictureOf(const Rect& held)
      : colours(hal::Framebuffer<F>::words(held.width(), held.height())),
        depths(DepthBuffer::words(held.width(), held.height())),
        frame(std::as_writable_bytes(std::span(colours)), held,
              hal::FramebufferWindow<F>::least_stride(held)),
        depth(depths, held) {
    frame.clear(kBackground);
    depth.clear();
  }
  std::vector<typename F::Word> colours;
  std::vector<std::uint16_t> depths;
  hal::FramebufferWindow<F> frame;
  DepthBuffer depth;
};
using Picture = PictureOf<Rgb565>;

TestCamera camera(Random& random, double radius) {
  TestCamera made;
  made.look_in_random_direction(random);
  made.translation = {0, 0, -4 * radius};
  made.near_plane = radius / 10;
  made.far_plane = 10 * radius;
  return made;
}

/// Two spheres, one before the other, with their outlines.
struct Scene {
  explicit Scene(Random& random)
      : sphere(make_sphere(9, 14, 9000, 0.3, random)),
        neighbours(sphere.view()),
        memory(2 * sphere.view().triangle_count()),
        outlines(memory) {
    for (const double x : {-4000.0, 5000.0}) {
      TestCamera from = camera(random, 9000);
      from.translation.x += x;
      from.translation.z += x;
      cameras.push_back(from);
      transforms.push_back(from.transform());
    }
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      std::vector<TriangleSide> sides(sphere.view().triangle_count());
      const auto light = make_light<1, Highlight::kBlinn>(cameras[i]);
      REQUIRE(ok(find_sides<Method>(sphere.view(), transforms[i], light, NoCache{}, sides)));
      REQUIRE(ok(outlines.add(sphere.view(), neighbours.view, VertexPositions(transforms[i]), sides)));
    }
  }

  template <PixelFormat F>
  void draw(PictureOf<F>& picture) const {
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      const auto light = make_light<1, Highlight::kBlinn>(cameras[i]);
      REQUIRE(
          ok(draw_mesh<Method>(sphere.view(), transforms[i], light, picture.frame, picture.depth).status));
    }
  }
  [[nodiscard]] Rect bounds() const { return {0, 0, cameras[0].width, cameras[0].height}; }

  TestMesh sphere;
  TestNeighbours neighbours;
  std::vector<TestCamera> cameras;
  std::vector<ClipTransform> transforms;
  std::vector<OutlineEdge> memory;
  OutlineList outlines;
};

template <PixelFormat F>
Status smooth(const OutlineList& outlines, PictureOf<F>& picture, std::size_t gaps = 4000) {
  std::vector<OutlineGap<F>> memory(gaps);
  return smooth_outlines(outlines, picture.frame, picture.depth, std::span(memory));
}

template <PixelFormat F>
bool same_pixels(const PictureOf<F>& a, const PictureOf<F>& b, const Rect& rect) {
  for (std::int32_t y = rect.top; y < rect.bottom; ++y) {
    for (std::int32_t x = rect.left; x < rect.right; ++x)
      if (!(a.frame.pixel(x, y) == b.frame.pixel(x, y))) return false;
  }
  return true;
}

/// Edges that were made without a mesh, for a picture of 32x32.
struct Drawing {
  explicit Drawing(const std::vector<OutlineEdge>& edges) : memory(edges.size()), outlines(memory) {
    // A square gives the memory its count and viewport; then the edges replace its own.
    TestMesh mesh;
    const std::size_t triangles = (edges.size() + 2) / 3;
    for (std::size_t i = 0; i < 3; ++i) mesh.add({9000.0 * (i == 1), 9000.0 * (i == 2), 0}, {0, 0, 1});
    for (std::size_t i = 0; i < triangles; ++i) mesh.triangle(0, 1, 2);
    memory.resize(3 * triangles);
    outlines = OutlineList(memory);
    TestCamera from;
    from.width = 32;
    from.height = 32;
    from.translation = {0, 0, -40000};
    transform = from.transform();
    std::vector<std::uint8_t> borders(triangles);
    MeshNeighbours none;
    REQUIRE(ok(MeshNeighbours::make(mesh.view(), borders, none)));
    const std::vector<TriangleSide> sides(triangles, TriangleSide::kFront);
    REQUIRE(ok(outlines.add(mesh.view(), none, VertexPositions(transform), sides)));
    std::fill(memory.begin(), memory.end(), OutlineEdge{});
    std::copy(edges.begin(), edges.end(), memory.begin());
  }
  ClipTransform transform;
  std::vector<OutlineEdge> memory;
  OutlineList outlines;
};

/// The raster position of a point of the picture, in sixteenths of a pixel.
RasterPosition at(std::int32_t x, std::int32_t y, std::uint16_t z = 1000) {
  return {static_cast<std::int16_t>(x - 256), static_cast<std::int16_t>(y - 256), z};
}

/// The outline of a polygon whose corners run counter-clockwise on the screen.
std::vector<OutlineEdge> polygon(const std::vector<RasterPosition>& corners) {
  std::vector<OutlineEdge> edges;
  for (std::size_t i = 0; i < corners.size(); ++i)
    edges.push_back({corners[i], corners[(i + 1) % corners.size()]});
  return edges;
}

/// True if the centre of a pixel belongs to a convex polygon, by the top-left rule.
bool covers(const std::vector<OutlineEdge>& edges, std::int32_t x, std::int32_t y) {
  for (const OutlineEdge& e : edges) {
    const std::int32_t dx = e.to.x - e.from.x;
    const std::int32_t dy = e.to.y - e.from.y;
    const std::int32_t px = 16 * x + 8 - 256 - e.from.x;
    const std::int32_t py = 16 * y + 8 - 256 - e.from.y;
    const std::int32_t cross = dx * py - dy * px;  // negative inside
    const bool left_or_top = dy > 0 || (dy == 0 && dx < 0);
    if (cross > 0 || (cross == 0 && !left_or_top)) return false;
  }
  return true;
}

/// The share of a pixel that a convex polygon covers, by 64x64 samples.
double coverage(const std::vector<OutlineEdge>& edges, std::int32_t x, std::int32_t y) {
  int inside = 0;
  for (int j = 0; j < 64; ++j) {
    for (int i = 0; i < 64; ++i) {
      const double sx = 16 * (x + (i + 0.5) / 64) - 256;
      const double sy = 16 * (y + (j + 0.5) / 64) - 256;
      bool in = true;
      for (const OutlineEdge& e : edges)
        in = in && (e.to.x - e.from.x) * (sy - e.from.y) - (e.to.y - e.from.y) * (sx - e.from.x) <= 0;
      inside += in ? 1 : 0;
    }
  }
  return inside / 4096.0;
}

/// How many edges, prolonged, pass within two pixels of a pixel's centre.
int edges_near(const std::vector<OutlineEdge>& edges, std::int32_t x, std::int32_t y) {
  int found = 0;
  for (const OutlineEdge& e : edges) {
    const double dx = e.to.x - e.from.x;
    const double dy = e.to.y - e.from.y;
    const double cross = dx * (16 * y + 8 - 256 - e.from.y) - dy * (16 * x + 8 - 256 - e.from.x);
    if (std::abs(cross) < 32 * std::hypot(dx, dy)) ++found;
  }
  return found;
}

/// A picture of 32x32 with a white polygon on black, as the raster draws it.
template <PixelFormat F>
PictureOf<F> drawn(const std::vector<OutlineEdge>& edges, std::uint16_t z = 1000) {
  PictureOf<F> picture({0, 0, 32, 32});
  picture.frame.clear({0, 0, 0});
  for (std::int32_t y = 0; y < 32; ++y) {
    for (std::int32_t x = 0; x < 32; ++x) {
      if (!covers(edges, x, y)) continue;
      typename F::Cursor(picture.frame.row(y), x).write(F::encode(Rgb8{255, 255, 255}));
      picture.depth.row(y)[x] = z;
    }
  }
  return picture;
}

std::vector<OutlineEdge> random_triangle(Random& random, std::int32_t step) {
  for (;;) {
    const auto corner = [&] {
      return at(step * random.integer(16 / step, 496 / step), step * random.integer(16 / step, 496 / step));
    };
    const std::vector<OutlineEdge> edges = polygon({corner(), corner(), corner()});
    if (doubled_area(edges[0].from, edges[1].from, edges[2].from) < -4000) return edges;
  }
}

}  // namespace

TEST_CASE("Smooth outlines: a band with a row more on both sides gives the pixels of the whole picture") {
  Random random(46);
  for (int i = 0; i < share_of(20); ++i) {
    const Scene scene(random);
    Picture whole(scene.bounds());
    scene.draw(whole);
    REQUIRE(ok(smooth(scene.outlines, whole)));
    const std::int32_t rows = random.integer(1, 30);
    const Rect& all = scene.bounds();
    for (std::int32_t top = 0; top < all.bottom; top += rows) {
      const Rect sent{0, top, all.right, std::min(all.bottom, top + rows)};
      Picture band({0, std::max(0, top - 1), all.right, std::min(all.bottom, sent.bottom + 1)});
      scene.draw(band);
      REQUIRE(ok(smooth(scene.outlines, band)));
      CHECK(same_pixels(whole, band, sent));
    }
  }
}

TEST_CASE(
    "Smooth outlines: a rectangle with a pixel more on all sides gives the pixels of the whole picture") {
  Random random(47);
  for (int i = 0; i < share_of(60); ++i) {
    const Scene scene(random);
    Picture whole(scene.bounds());
    scene.draw(whole);
    REQUIRE(ok(smooth(scene.outlines, whole)));
    Rect shown{random.integer(1, 80), random.integer(1, 60), 0, 0};
    shown.right = random.integer(shown.left + 1, scene.bounds().right - 1);
    shown.bottom = random.integer(shown.top + 1, scene.bounds().bottom - 1);
    Picture part({shown.left - 1, shown.top - 1, shown.right + 1, shown.bottom + 1});
    scene.draw(part);
    REQUIRE(ok(smooth(scene.outlines, part)));
    CHECK(same_pixels(whole, part, shown));
  }
}

TEST_CASE("Smooth outlines: the depths are those before, and pixels change next to outlines only") {
  Random random(48);
  for (int i = 0; i < share_of(20); ++i) {
    const Scene scene(random);
    Picture before(scene.bounds());
    scene.draw(before);
    Picture after = before;
    after.frame = hal::FramebufferWindow<Rgb565>(std::as_writable_bytes(std::span(after.colours)),
                                                 scene.bounds(), scene.bounds().width() * 2);
    after.depth = DepthBuffer(after.depths, scene.bounds());
    REQUIRE(ok(smooth(scene.outlines, after)));
    CHECK(after.depths == before.depths);
    std::size_t changed = 0;
    bool is_near = true;
    for (std::int32_t y = 0; y < scene.bounds().bottom; ++y) {
      for (std::int32_t x = 0; x < scene.bounds().right; ++x) {
        if (before.frame.pixel(x, y) == after.frame.pixel(x, y)) continue;
        ++changed;
        double nearest = 1e9;
        const double px = 16 * (x - scene.bounds().right / 2) + 8;
        const double py = 16 * (y - scene.bounds().bottom / 2) + 8;
        for (const OutlineEdge& e : scene.outlines.edges()) {
          const double dx = e.to.x - e.from.x;
          const double dy = e.to.y - e.from.y;
          const double along = dx * dx + dy * dy;
          const double t =
              along == 0 ? 0 : std::clamp(((px - e.from.x) * dx + (py - e.from.y) * dy) / along, 0.0, 1.0);
          nearest = std::min(nearest, std::hypot(e.from.x + t * dx - px, e.from.y + t * dy - py));
        }
        is_near = is_near && nearest <= 16 * 1.01;
      }
    }
    CHECK(changed > 50);
    CHECK(is_near);
  }
}

TEST_CASE("Smooth outlines: pixels along an edge have the share of the area on its side") {
  Random random(49);
  double sum = 0;
  double worst = 0;
  int pixels = 0;
  // Corners on every sixteenth; on centres and borders of pixels, where the fill rule decides.
  const std::int32_t step = GENERATE(1, 8, 16);
  for (int i = 0; i < share_of(200); ++i) {
    const std::vector<OutlineEdge> edges = random_triangle(random, step);
    PictureOf<Xrgb8888> picture = drawn<Xrgb8888>(edges);
    const Drawing drawing(edges);
    REQUIRE(ok(smooth(drawing.outlines, picture)));
    for (std::int32_t y = 0; y < 32; ++y) {
      for (std::int32_t x = 0; x < 32; ++x) {
        if (edges_near(edges, x, y) > 1) continue;  // at a corner two edges cut one pixel
        const double share = coverage(edges, x, y);
        const double error = std::abs(picture.frame.pixel(x, y).g / 255.0 - share);
        if (share > 0 && share < 1) {
          sum += error * error;
          ++pixels;
        }
        worst = std::max(worst, error);
      }
    }
  }
  REQUIRE(pixels > 5 * share_of(200));
  CHECK(std::sqrt(sum / pixels) < 0.012);  // shares are in 32nds
  CHECK(worst < 0.05);
}

TEST_CASE("Smooth outlines: an upright edge gives the pixel that it cuts its exact share") {
  for (std::int32_t x = 160; x < 176; ++x) {  // column 10
    const std::vector<OutlineEdge> edges = polygon({at(x, 0), at(x, 512), at(512, 512), at(512, 0)});
    Picture picture = drawn<Rgb565>(edges);
    const Drawing drawing({edges[0]});
    REQUIRE(ok(smooth(drawing.outlines, picture)));
    const auto white = static_cast<std::uint32_t>(176 - x);  // sixteenths
    CHECK(picture.colours[7 * 32 + 9] == 0);
    CHECK(picture.colours[7 * 32 + 10] == detail::blended<Rgb565>(0, 0xFFFF, 2 * white));
    CHECK(picture.colours[7 * 32 + 11] == 0xFFFF);
  }
}

TEST_CASE("Smooth outlines: what is nearer hides them") {
  Random random(50);
  const std::vector<OutlineEdge> edges = random_triangle(random, 1);
  const Drawing drawing(edges);
  Picture plain = drawn<Rgb565>(edges);
  const auto changes = [&](std::uint16_t depth_around) {
    Picture picture = drawn<Rgb565>(edges);
    for (std::uint16_t& z : picture.depths)
      if (z == DepthBuffer::kFarthest) z = depth_around;
    REQUIRE(ok(smooth(drawing.outlines, picture)));
    return picture.colours != plain.colours;
  };
  CHECK_FALSE(changes(999));
  CHECK(changes(1000));
  CHECK(changes(1001));
}

TEST_CASE("Smooth outlines: two surfaces that meet in an edge are blended once") {
  const std::vector<OutlineEdge> left = polygon({at(0, 0), at(0, 512), at(165, 512), at(165, 0)});
  const std::vector<OutlineEdge> right = polygon({at(165, 0), at(165, 512), at(512, 512), at(512, 0)});
  const Drawing once({right[0]});
  const Drawing twice({right[0], left[2]});
  Picture one = drawn<Rgb565>(right);
  for (std::uint16_t& z : one.depths) z = 1000;
  Picture both = drawn<Rgb565>(right);
  for (std::uint16_t& z : both.depths) z = 1000;
  REQUIRE(ok(smooth(once.outlines, one)));
  REQUIRE(ok(smooth(twice.outlines, both)));
  CHECK(one.colours == both.colours);
}

TEST_CASE("Smooth outlines: of several outlines in a gap the outermost counts, in any order") {
  const OutlineEdge inner{at(167, 0), at(167, 512)};
  const OutlineEdge outer{at(163, 0), at(163, 512)};
  const std::vector<OutlineEdge> surface = polygon({at(163, 0), at(163, 512), at(512, 512), at(512, 0)});
  Picture pictures[3] = {drawn<Rgb565>(surface), drawn<Rgb565>(surface), drawn<Rgb565>(surface)};
  const std::vector<OutlineEdge> orders[3] = {{outer}, {inner, outer}, {outer, inner}};
  for (std::size_t i = 0; i < 3; ++i) REQUIRE(ok(smooth(Drawing(orders[i]).outlines, pictures[i])));
  CHECK(pictures[1].colours == pictures[0].colours);
  CHECK(pictures[2].colours == pictures[0].colours);
}

TEST_CASE("Smooth outlines: a full list is applied and begun anew, and says so") {
  Random random(51);
  const Scene scene(random);
  Picture enough(scene.bounds());
  scene.draw(enough);
  REQUIRE(ok(smooth(scene.outlines, enough)));
  for (const std::size_t gaps : {1u, 2u, 40u}) {
    Picture picture(scene.bounds());
    scene.draw(picture);
    const std::vector<std::uint16_t> depths = picture.depths;
    CHECK(smooth(scene.outlines, picture, gaps) == Status::kBufferTooSmall);
    CHECK(picture.depths == depths);
    std::size_t differ = 0;
    for (std::size_t i = 0; i < picture.colours.size(); ++i)
      differ += picture.colours[i] != enough.colours[i] ? 1u : 0u;
    CHECK(differ < 200);  // where pixels were blended twice
  }
  Picture none(scene.bounds());
  scene.draw(none);
  const std::vector<std::uint16_t> plain = none.colours;
  CHECK(smooth(scene.outlines, none, 0) == Status::kBufferTooSmall);
  CHECK(none.colours == plain);
}

TEMPLATE_TEST_CASE("Smooth outlines: in every format a pixel is the mixture of both colours", "", Rgb565,
                   Rgb565Swapped, Xrgb8888, Argb8888, Bgr888, Rgb888, Gray8, Gray4) {
  const std::vector<OutlineEdge> edges =
      polygon({at(168 - 4, 0), at(168 - 4, 512), at(512, 512), at(512, 0)});
  PictureOf<TestType> picture = drawn<TestType>(edges);
  const Drawing drawing({edges[0]});
  REQUIRE(ok(smooth(drawing.outlines, picture)));
  // Three quarters of column 10 are white.
  const Rgb8 mixed = picture.frame.pixel(10, 5);
  const int tolerance = TestType::kBitsPerPixel < 8 ? 9 : 5;
  for (const int channel : {mixed.r, mixed.g, mixed.b}) CHECK(std::abs(channel - 191) <= tolerance);
  CHECK(picture.frame.pixel(9, 5) == Rgb8{0, 0, 0});
  CHECK(picture.frame.pixel(11, 5) == Rgb8{255, 255, 255});
  const auto encoded = typename TestType::Cursor(picture.frame.row(5), 10).read();
  CHECK(TestType::encode(TestType::decode(encoded)) == encoded);
}

namespace {

/// A sink that cannot be read.
struct Stream {
  using Format = Rgb565;
  [[nodiscard]] static Rect bounds() { return {0, 0, 32, 32}; }
  [[nodiscard]] Format::Cursor open(const Span& run) { return {line, run.x}; }
  [[nodiscard]] static Status close(const Span&) { return Status::kOk; }
  std::uint16_t line[32] = {};
};

/// Fails at the n-th run.
struct Failing {
  using Format = Rgb565;
  using RowsInMemory = Failing;
  [[nodiscard]] Rect bounds() const { return picture.frame.bounds(); }
  [[nodiscard]] Format::Cursor open(const Span& run) { return {row(run.y), run.x}; }
  [[nodiscard]] Status close(const Span& run) {
    inside = inside && run.count == 1 && run.x >= 0 && run.x < 32 && run.y >= 0 && run.y < 32;
    return --left == 0 ? Status::kTransferFailed : Status::kOk;
  }
  [[nodiscard]] std::uint16_t* row(std::int32_t y) const { return picture.frame.row(y); }
  [[nodiscard]] std::int32_t stride_bytes() const { return picture.frame.stride_bytes(); }
  Picture& picture;
  int left;
  bool inside = true;
};

}  // namespace

TEST_CASE("Smooth outlines: sinks that cannot be read or do not blend are refused") {
  const Drawing drawing(polygon({at(163, 0), at(163, 512), at(512, 512), at(512, 0)}));
  const Picture picture({0, 0, 32, 32});
  Stream stream;
  std::vector<OutlineGap<Rgb565>> gaps(50);
  CHECK(smooth_outlines(drawing.outlines, stream, picture.depth, std::span(gaps)) == Status::kUnsupported);
  PictureOf<Mono> mono({0, 0, 32, 32});
  CHECK(smooth(drawing.outlines, mono) == Status::kUnsupported);
  PictureOf<Gray2> gray({0, 0, 32, 32});
  CHECK(smooth(drawing.outlines, gray) == Status::kUnsupported);
  Picture small({0, 0, 32, 32});
  std::vector<std::uint16_t> few(31 * 32);
  CHECK(smooth_outlines(drawing.outlines, small.frame, DepthBuffer(few, 32, 31), std::span(gaps)) ==
        Status::kDepthMismatch);
  CHECK(smooth_outlines(drawing.outlines, small.frame, DepthBuffer(few, 32, 32), std::span(gaps)) ==
        Status::kBufferTooSmall);
}

TEST_CASE("Smooth outlines: the status of a sink ends blending, and the depths are restored") {
  const std::vector<OutlineEdge> edges = polygon({at(163, 0), at(163, 512), at(512, 512), at(512, 0)});
  const Drawing drawing(edges);
  std::vector<OutlineGap<Rgb565>> gaps(50);
  Picture picture = drawn<Rgb565>(edges);
  const std::vector<std::uint16_t> depths = picture.depths;
  Failing sink{picture, 5};
  CHECK(smooth_outlines(drawing.outlines, sink, picture.depth, std::span(gaps)) == Status::kTransferFailed);
  CHECK(sink.left == 0);
  CHECK(sink.inside);
  CHECK(picture.depths == depths);
}

TEST_CASE("Smooth outlines: any edges and depths are safe") {
  Random random(52);
  for (int i = 0; i < share_of(300); ++i) {
    std::vector<OutlineEdge> edges(30);
    const auto any = [&] {
      return static_cast<std::int16_t>(random.integer(-32768, 32767) >> random.integer(0, 8));
    };
    const auto anywhere = [&] {
      return RasterPosition{any(), any(), static_cast<std::uint16_t>(random.integer(0, 65535))};
    };
    for (OutlineEdge& edge : edges) edge = {anywhere(), anywhere()};
    const Drawing drawing(edges);
    Picture picture({0, 0, 32, 32});
    for (std::uint16_t& z : picture.depths)
      z = static_cast<std::uint16_t>(random.integer(0, random.chance(0.5) ? 40 : 65535));
    const std::vector<std::uint16_t> depths = picture.depths;
    const Status status = smooth(drawing.outlines, picture, static_cast<std::size_t>(random.integer(1, 300)));
    CHECK((ok(status) || status == Status::kBufferTooSmall));
    CHECK(picture.depths == depths);
  }
}
