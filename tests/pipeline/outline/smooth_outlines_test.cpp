// SPDX-License-Identifier: MIT
// Smoothed pictures: pixels by area, the same in bands and rectangles, and nothing where nothing is to
// change.
#include <arcspan/hal/panel/damage.hpp>
#include <arcspan/ink_outlines.hpp>
#include <arcspan/pixel/pixel_format_list.hpp>
#include <arcspan/pixel/sink_part.hpp>
#include <arcspan/smooth_outlines.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/outline/outline_pictures.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

TEST_CASE("Smooth outlines: a band with a row more on both sides gives the pixels of the whole picture") {
  Random random(46);
  for (int i = 0; i < share_of(100); ++i) {
    const OutlineScene scene(random, i % 2 != 0);
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
    "Smooth outlines: a band may begin with the last two rows of the one above, from before smoothing") {
  Random random(49);
  for (int i = 0; i < share_of(60); ++i) {
    const OutlineScene scene(random, i % 2 != 0);
    const Rect& all = scene.bounds();
    Picture whole(all);
    scene.draw(whole);
    REQUIRE(ok(smooth(scene.outlines, whole)));
    const std::int32_t rows = random.integer(1, 30);
    const std::ptrdiff_t two_rows = 2 * all.right;
    std::vector<std::uint16_t> colours;
    std::vector<std::uint16_t> depths;
    for (std::int32_t top = 0; top < all.bottom; top += rows) {
      const Rect sent{0, top, all.right, std::min(all.bottom, top + rows)};
      const std::int32_t end = std::min(all.bottom, sent.bottom + 1);
      Picture band({0, std::max(0, top - 1), all.right, end});
      if (const std::int32_t first = top == 0 ? 0 : top + 1; first < end) {
        Picture drawn({0, first, all.right, end});
        scene.draw(drawn);
        std::copy(drawn.colours.begin(), drawn.colours.end(),
                  band.colours.end() - static_cast<std::ptrdiff_t>(drawn.colours.size()));
        std::copy(drawn.depths.begin(), drawn.depths.end(),
                  band.depths.end() - static_cast<std::ptrdiff_t>(drawn.depths.size()));
      }
      std::copy(colours.begin(), colours.end(), band.colours.begin());
      std::copy(depths.begin(), depths.end(), band.depths.begin());
      colours.assign(band.colours.end() - two_rows, band.colours.end());
      REQUIRE(ok(smooth(scene.outlines, band)));
      depths.assign(band.depths.end() - two_rows, band.depths.end());
      CHECK(same_pixels(whole, band, sent));
    }
  }
}

TEST_CASE(
    "Smooth outlines: a rectangle with a pixel more on all sides gives the pixels of the whole picture") {
  Random random(47);
  for (int i = 0; i < share_of(60); ++i) {
    const OutlineScene scene(random, i % 2 != 0);
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
  for (int i = 0; i < share_of(100); ++i) {
    const OutlineScene scene(random, i % 2 != 0);
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
        const double px = 16 * (x - scene.bounds().right / 2) + 8;
        const double py = 16 * (y - scene.bounds().bottom / 2) + 8;
        is_near = is_near && distance_from(scene.outlines.edges(), px, py) <= 16 * 1.01;
      }
    }
    CHECK(changed > 50);
    CHECK(is_near);
  }
}

TEST_CASE("Smooth outlines: a crease is smoothed unless something nearer hides both of its sides") {
  Random random(52);
  for (int i = 0; i < share_of(60); ++i) {
    const LineAcross crease(random);
    const RasterPosition a = crease.a;
    const RasterPosition b = crease.b;
    const bool turned = random.chance(0.5);
    const Drawing drawing(turned ? std::vector<OutlineEdge>{{b, a}, {a, b}}
                                 : std::vector<OutlineEdge>{{a, b}, {b, a}});
    const auto side_of = [&](std::int32_t x, std::int32_t y) {  // of the crease: 0 or 1
      const std::int32_t px = 16 * x + 8 - 256 - a.x;
      const std::int32_t py = 16 * y + 8 - 256 - a.y;
      return (b.x - a.x) * py - (b.y - a.y) * px > 0 ? 1u : 0u;
    };
    const auto picture_of = [&](std::uint16_t one, std::uint16_t other, bool smoothed) {
      Picture picture({0, 0, 32, 32});
      for (std::int32_t y = 0; y < 32; ++y) {
        for (std::int32_t x = 0; x < 32; ++x) {
          const bool first = side_of(x, y) == 0;
          Rgb565::Cursor(picture.frame.row(y), x).write(Rgb565::encode(first ? Rgb8{} : Rgb8{255, 255, 255}));
          picture.depth.row(y)[x] = first ? one : other;
        }
      }
      if (smoothed) REQUIRE(ok(smooth(drawing.outlines, picture)));
      return picture.colours;
    };
    const auto plain = picture_of(1001, 1001, false);
    const auto both = picture_of(1001, 1001, true);
    CHECK(both != plain);
    CHECK(picture_of(999, 999, true) == plain);
    // The same edge is blended whichever side is nearer.
    CHECK(picture_of(1001, 999, true) == both);
    CHECK(picture_of(999, 1001, true) == both);
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

TEST_CASE("Smooth outlines: static memory needs no constructor that runs before main()") {
  static constinit OutlineGap<Rgb565> gaps[50];  // firmware has none
  const std::vector<OutlineEdge> edges = polygon({at(163, 0), at(163, 512), at(512, 512), at(512, 0)});
  Picture picture = drawn<Rgb565>(edges);
  CHECK(ok(smooth_outlines(Drawing(edges).outlines, picture.frame, picture.depth, std::span(gaps))));
}

TEST_CASE("Smooth outlines: a full list is applied and begun anew, and says so") {
  Random random(51);
  const OutlineScene scene(random);
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

TEST_CASE("Smooth outlines: a layer with alpha, laid over a colour, is the picture on that colour") {
  Random random(54);
  for (int i = 0; i < share_of(20); ++i) {
    const OutlineScene scene(random, i % 2 != 0);
    PictureOf<Argb8888> opaque(scene.bounds());
    PictureOf<Argb8888> layer(scene.bounds());
    // The colour of what is transparent does not matter.
    for (std::uint32_t& word : layer.colours) word = static_cast<std::uint32_t>(random.integer(0, 0xFFFFFF));
    for (PictureOf<Argb8888>* const picture : {&opaque, &layer}) {
      scene.draw(*picture);
      REQUIRE(ok(smooth(scene.outlines, *picture)));
    }
    int worst = 0;
    int partial = 0;
    for (std::size_t at = 0; at < layer.colours.size(); ++at) {
      const auto channel = [at](const PictureOf<Argb8888>& picture, int shift) {
        return static_cast<int>(picture.colours[at] >> shift & 255u);
      };
      const int alpha = channel(layer, 24);
      partial += alpha > 0 && alpha < 255;
      CHECK(channel(opaque, 24) == 255);
      const int below[] = {kBackground.b, kBackground.g, kBackground.r};
      for (int c = 0; c < 3; ++c) {
        const int laid = (channel(layer, 8 * c) * alpha + below[c] * (255 - alpha) + 127) / 255;
        worst = std::max(worst, std::abs(laid - channel(opaque, 8 * c)));
      }
    }
    CHECK(partial > 50);
    CHECK(worst <= 2);
  }
}

TEST_CASE("Smooth outlines: opaque pixels with alpha are mixed as those without") {
  Random random(55);
  for (int i = 0; i < share_of(2000); ++i) {
    const auto a = static_cast<std::uint32_t>(random.integer(0, 0xFFFFFF));
    const auto b = static_cast<std::uint32_t>(random.integer(0, 0xFFFFFF));
    const auto share = static_cast<std::uint32_t>(random.integer(0, 32));
    CHECK(detail::blended<Argb8888>(a | 0xFF000000u, b | 0xFF000000u, share) ==
          (detail::blended<Xrgb8888>(a, b, share) | 0xFF000000u));
  }
}

TEST_CASE("Smooth outlines: the damage of a frame has all pixels that they and ink change") {
  Random random(57);
  for (int i = 0; i < share_of(100); ++i) {
    const OutlineScene scene(random, i % 2 != 0);
    const Rect& all = scene.bounds();
    Picture plain(all);
    scene.draw(plain);
    Picture picture(all);
    scene.draw(picture);
    std::vector<hal::RowExtent> extents(hal::Damage::extents(all.height()));
    hal::Damage damage(extents, all.width(), all.height());
    for (int frame = 0; frame < 3; ++frame) damage.begin_frame();  // the first two are changed everywhere
    hal::DamageSink sink(picture.frame, damage);
    std::vector<OutlineGap<Rgb565>> gaps(9000);
    if (random.chance(0.5))
      REQUIRE(ok(ink_outlines(scene.outlines, {.width = 2}, sink, picture.depth, std::span(gaps))));
    REQUIRE(ok(smooth_outlines(scene.outlines, sink, picture.depth, std::span(gaps))));
    for (std::int32_t y = 0; y < all.bottom; ++y) {
      const Rect changed = damage.changed_area(y, y + 1);
      CHECK(same_pixels(plain, picture, {0, y, changed.empty() ? all.right : changed.left, y + 1}));
      if (!changed.empty()) CHECK(same_pixels(plain, picture, {changed.right, y, all.right, y + 1}));
    }
  }
}

TEST_CASE("Smooth outlines: sinks that cannot be read or do not blend are refused") {
  const Drawing drawing(polygon({at(163, 0), at(163, 512), at(512, 512), at(512, 0)}));
  const Picture picture({0, 0, 32, 32});
  StreamSink stream;
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
  FailingSink sink{picture, 5};
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
