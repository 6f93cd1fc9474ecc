// SPDX-License-Identifier: MIT
// Inked pictures: lines of the width that was asked for, the same in bands and rectangles, each pixel by its
// largest share.
#include <arcspan/ink_outlines.hpp>
#include <arcspan/pixel/pixel_format_list.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/outline/outline_pictures.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

constexpr Rgb8 kInk{20, 30, 60};

template <PixelFormat F>
Status ink(const OutlineList& outlines, const OutlineInk& style, PictureOf<F>& picture,
           std::size_t entries = 6000) {
  std::vector<OutlineGap<F>> memory(entries);
  return ink_outlines(outlines, style, picture.frame, picture.depth, std::span(memory));
}

OutlineInk random_ink(Random& random) {
  return {kInk, static_cast<std::uint8_t>(random.integer(1, 4)), random.chance(0.5)};
}

/// The share of a pixel that is at most `width` from a convex polygon, by 16x16 samples.
double ink_coverage(const std::vector<OutlineEdge>& edges, std::int32_t x, std::int32_t y, int width) {
  const double beyond = distance_from(edges, 16 * x + 8 - 256, 16 * y + 8 - 256) - 16 * width;
  constexpr double kFarthestSample = 10.7;  // 7.5 to the side and down
  if (std::abs(beyond) > kFarthestSample) return beyond > 0 ? 0 : 1;
  int inside = 0;
  for (int j = 0; j < 16; ++j) {
    for (int i = 0; i < 16; ++i)
      inside += distance_from(edges, 16 * x + i + 0.5 - 256, 16 * y + j + 0.5 - 256) <= 16 * width ? 1 : 0;
  }
  return inside / 256.0;
}

/// A white picture of 32x32 with the depths of a polygon that hides nothing.
template <PixelFormat F>
PictureOf<F> white_around(const std::vector<OutlineEdge>& edges) {
  PictureOf<F> picture = drawn<F>(edges);
  picture.frame.clear({255, 255, 255});
  for (std::uint16_t& z : picture.depths)
    if (z == 1000) z = 999;  // the surface is nearer than its outline
  return picture;
}

}  // namespace

TEST_CASE("Ink: a band or rectangle with its margin gives the pixels of the whole picture") {
  Random random(60);
  for (int i = 0; i < share_of(40); ++i) {
    const bool smooths = random.chance(0.5);
    const OutlineScene scene(random, !smooths && random.chance(0.5));
    const OutlineInk style = random_ink(random);
    const Rect& all = scene.bounds();
    const auto finish = [&](Picture& picture) {
      scene.draw(picture);
      REQUIRE(ok(ink(scene.outlines, style, picture)));
      if (smooths) REQUIRE(ok(smooth(scene.outlines, picture)));
    };
    Picture whole(all);
    finish(whole);
    const std::int32_t rows = random.integer(1, 30);
    const std::int32_t margin = (smooths ? 1 : 0) + (style.creases ? 1 : 0);
    for (std::int32_t top = 0; top < all.bottom; top += rows) {
      const Rect sent{0, top, all.right, std::min(all.bottom, top + rows)};
      Picture band({0, std::max(0, top - margin), all.right, std::min(all.bottom, sent.bottom + margin)});
      finish(band);
      CHECK(same_pixels(whole, band, sent));
    }
    Rect shown{random.integer(2, 80), random.integer(2, 60), 0, 0};
    shown.right = random.integer(shown.left + 1, all.right - 2);
    shown.bottom = random.integer(shown.top + 1, all.bottom - 2);
    Picture part({shown.left - margin, shown.top - margin, shown.right + margin, shown.bottom + margin});
    finish(part);
    CHECK(same_pixels(whole, part, shown));
  }
}

TEST_CASE("Ink: the depths are those before, and pixels change only as far from outlines as ink is wide") {
  Random random(61);
  for (int i = 0; i < share_of(20); ++i) {
    const OutlineScene scene(random);
    const OutlineInk style = random_ink(random);
    Picture before(scene.bounds());
    Picture after(scene.bounds());
    scene.draw(before);
    scene.draw(after);
    REQUIRE(ok(ink(scene.outlines, style, after)));
    CHECK(after.depths == before.depths);
    std::size_t changed = 0;
    bool is_near = true;
    for (std::int32_t y = 0; y < scene.bounds().bottom; ++y) {
      for (std::int32_t x = 0; x < scene.bounds().right; ++x) {
        if (before.frame.pixel(x, y) == after.frame.pixel(x, y)) continue;
        ++changed;
        const double px = 16 * (x - scene.bounds().right / 2) + 8;
        const double py = 16 * (y - scene.bounds().bottom / 2) + 8;
        // And half a pixel, of a share; the ends of a line of one pixel are not all round.
        const double most = 16 * (style.width * 1.05 + 0.7);
        is_near = is_near && distance_from(scene.outlines.edges(), px, py) <= most;
      }
    }
    CHECK(changed > 50);
    CHECK(is_near);
  }
}

TEST_CASE("Ink: around a surface pixels have the share of the line's area") {
  Random random(62);
  const int width = GENERATE(1, 2, 3, 4);
  double sum = 0;
  double worst = 0;
  int pixels = 0;
  const int cases = std::max(share_of(12), 4);  // fewer have no mean
  for (int i = 0; i < cases; ++i) {
    const std::vector<OutlineEdge> edges = random_triangle(random, 1);
    PictureOf<Xrgb8888> picture = white_around<Xrgb8888>(edges);
    const Drawing drawing(edges);
    REQUIRE(ok(ink(drawing.outlines, {{0, 0, 0}, static_cast<std::uint8_t>(width)}, picture)));
    for (std::int32_t y = 0; y < 32; ++y) {
      for (std::int32_t x = 0; x < 32; ++x) {
        const double share = 1 - picture.frame.pixel(x, y).g / 255.0;
        if (covers(edges, x, y)) {
          worst = std::max(worst, share);
          continue;
        }
        // The part of the surface in the pixel is smoothed afterwards.
        const double area = ink_coverage(edges, x, y, width) + coverage(edges, x, y);
        const double error = std::abs(share - std::min(area, 1.0));
        if (area > 0) ++pixels;
        sum += error * error;
        // The outer side of an acute corner is cut off.
        const bool at_corner = std::any_of(edges.begin(), edges.end(), [&](const OutlineEdge& e) {
          return std::hypot(e.from.x - (16 * x + 8 - 256), e.from.y - (16 * y + 8 - 256)) < 16 * (width + 1);
        });
        if (!at_corner) worst = std::max(worst, error);
      }
    }
  }
  REQUIRE(pixels > 5 * cases);
  CHECK(std::sqrt(sum / pixels) < 0.09);
  CHECK(worst < 0.2);
}

TEST_CASE("Ink: an upright outline has its exact width beside the surface") {
  for (std::int32_t x = 160; x < 176; ++x) {  // column 10
    for (const std::int32_t width : {1, 2, 3, 4}) {
      const std::vector<OutlineEdge> edges = polygon({at(x, 0), at(x, 512), at(512, 512), at(512, 0)});
      PictureOf<Xrgb8888> picture = white_around<Xrgb8888>(edges);
      const Drawing drawing({edges[0]});
      REQUIRE(ok(ink(drawing.outlines, {{0, 0, 0}, static_cast<std::uint8_t>(width)}, picture)));
      const std::int32_t first = x <= 168 ? 9 : 10;  // pixel outside
      for (std::int32_t column = 0; column < 32; ++column) {
        // In sixteenths; the first pixel's part inside is smoothed afterwards.
        const std::int32_t left = std::max(16 * column, x - 16 * width);
        const std::int32_t right = column == first ? 16 * column + 16 : std::min(16 * column + 16, x);
        std::int32_t covered = column > first ? 0 : std::clamp(right - left, 0, 16);
        if (column == first && x < 16 * first + 16)
          covered = std::clamp(16 * width + 16 * first + 16 - x, 0, 16);
        const std::int32_t expected = 255 - covered * 255 / 16;
        CHECK(std::abs(picture.frame.pixel(column, 7).g - expected) <= 4);
      }
    }
  }
}

TEST_CASE("Ink: what is nearer hides it, and a surface is not inked") {
  Random random(63);
  for (int i = 0; i < share_of(20); ++i) {
    const std::vector<OutlineEdge> edges = random_triangle(random, 1);
    const Drawing drawing(edges);
    const auto changes = [&](std::uint16_t depth_around) {
      PictureOf<Rgb565> picture = white_around<Rgb565>(edges);
      const PictureOf<Rgb565> plain = white_around<Rgb565>(edges);
      for (std::uint16_t& z : picture.depths)
        if (z == DepthBuffer::kFarthest) z = depth_around;
      REQUIRE(ok(ink(drawing.outlines, {kInk, 2}, picture)));
      for (std::int32_t y = 0; y < 32; ++y) {
        for (std::int32_t x = 0; x < 32; ++x)
          if (covers(edges, x, y)) REQUIRE(picture.frame.pixel(x, y) == plain.frame.pixel(x, y));
      }
      return picture.colours != plain.colours;
    };
    CHECK_FALSE(changes(999));
    CHECK(changes(1000));
    CHECK(changes(1001));
  }
}

TEST_CASE("Ink: the order of outlines does not matter, nor how often one is there") {
  Random random(64);
  for (int i = 0; i < share_of(20); ++i) {
    std::vector<OutlineEdge> edges = random_triangle(random, 1);
    const OutlineInk style{kInk, static_cast<std::uint8_t>(random.integer(1, 4))};
    Picture once = white_around<Rgb565>(edges);
    REQUIRE(ok(ink(Drawing(edges).outlines, style, once)));
    Picture again = white_around<Rgb565>(edges);
    edges.insert(edges.end(), {edges[1], edges[0], edges[2]});
    std::reverse(edges.begin(), edges.end());
    REQUIRE(ok(ink(Drawing(edges).outlines, style, again)));
    CHECK(again.colours == once.colours);
  }
}

TEST_CASE("Ink: a crease is a line of one pixel, or left out") {
  Random random(65);
  for (int i = 0; i < share_of(60); ++i) {
    const LineAcross crease(random);
    const bool steep = crease.steep;
    const Drawing drawing({{crease.a, crease.b}, {crease.b, crease.a}});
    const auto inked = [&](bool creases, std::uint16_t depth) {
      PictureOf<Xrgb8888> picture({0, 0, 32, 32});
      picture.frame.clear({255, 255, 255});
      std::fill(picture.depths.begin(), picture.depths.end(), depth);
      REQUIRE(ok(ink(drawing.outlines, {{0, 0, 0}, 3, creases}, picture)));
      return picture;
    };
    const PictureOf<Xrgb8888> plain = inked(false, 1000);
    CHECK(std::all_of(plain.colours.begin(), plain.colours.end(),
                      [&](std::uint32_t word) { return word == plain.colours.front(); }));
    CHECK(inked(true, 999).colours == plain.colours);
    const PictureOf<Xrgb8888> lined = inked(true, 1000);
    for (std::int32_t line = 0; line < 32; ++line) {
      double sum = 0;
      double moment = 0;
      for (std::int32_t across = 0; across < 32; ++across) {
        const Rgb8 colour = steep ? lined.frame.pixel(across, line) : lined.frame.pixel(line, across);
        sum += 1 - colour.g / 255.0;
        moment += (1 - colour.g / 255.0) * (across + 0.5);
      }
      CHECK(std::abs(sum - 1) < 0.02);
      const double middle = (crease.from + (crease.to - crease.from) * (line + 0.5) / 32) / 16;
      CHECK(std::abs(moment / sum - middle) < 0.06);
    }
  }
}

TEST_CASE("Ink: without creases the outlines are those of a mesh that has none") {
  Random random(66);
  for (int i = 0; i < share_of(10); ++i) {
    Random same = random;
    const OutlineScene creased(random, true);
    const OutlineScene plain(same, false);
    REQUIRE(creased.outlines.edges().size() > plain.outlines.edges().size());
    Picture a(creased.bounds());
    creased.draw(a);
    Picture b(plain.bounds());
    plain.draw(b);
    REQUIRE(a.colours == b.colours);
    REQUIRE(ok(ink(creased.outlines, {kInk, 2, false}, a)));
    REQUIRE(ok(ink(plain.outlines, {kInk, 2, true}, b)));
    CHECK(a.colours == b.colours);
    REQUIRE(ok(ink(creased.outlines, {kInk, 2, true}, a)));
    CHECK(a.colours != b.colours);
  }
}

TEST_CASE("Ink: a full list is applied and begun anew, and says so") {
  Random random(67);
  const OutlineScene scene(random);
  Picture enough(scene.bounds());
  scene.draw(enough);
  REQUIRE(ok(ink(scene.outlines, {kInk, 2}, enough)));
  for (const std::size_t entries : {1u, 2u, 40u}) {
    Picture picture(scene.bounds());
    scene.draw(picture);
    const std::vector<std::uint16_t> depths = picture.depths;
    CHECK(ink(scene.outlines, {kInk, 2}, picture, entries) == Status::kBufferTooSmall);
    CHECK(picture.depths == depths);
    std::size_t differ = 0;
    for (std::size_t i = 0; i < picture.colours.size(); ++i)
      differ += picture.colours[i] != enough.colours[i] ? 1u : 0u;
    CHECK(differ < 300);  // where pixels were blended twice
  }
  Picture none(scene.bounds());
  scene.draw(none);
  const std::vector<std::uint16_t> plain = none.colours;
  CHECK(ink(scene.outlines, {kInk, 2}, none, 0) == Status::kBufferTooSmall);
  CHECK(none.colours == plain);
}

TEMPLATE_TEST_CASE("Ink: in every format", "", Rgb565, Rgb565Swapped, Xrgb8888, Argb8888, Bgr888, Rgb888,
                   Gray8, Gray4, Gray2, Mono) {
  // From 6 3/4 to 10 3/4: column 6 is covered by a quarter, and 10 is outside, with 3/4 of its area.
  const std::vector<OutlineEdge> edges = polygon({at(172, 0), at(172, 512), at(512, 512), at(512, 0)});
  PictureOf<TestType> picture = white_around<TestType>(edges);
  const Drawing drawing({edges[0]});
  constexpr bool kBlends = TestType::kBitsPerPixel >= 4;
  REQUIRE(ok(ink(drawing.outlines, {{0, 0, 0}, 4}, picture, kBlends ? 100 : 0)));
  CHECK(picture.frame.pixel(5, 5) == Rgb8{255, 255, 255});
  const Rgb8 part = picture.frame.pixel(6, 5);
  const int tolerance = TestType::kBitsPerPixel < 8 ? 9 : 5;
  for (const int channel : {part.r, part.g, part.b}) {
    CHECK(std::abs(channel - (kBlends ? 191 : 255)) <= tolerance);
  }
  for (std::int32_t x = 7; x <= 10; ++x) CHECK(picture.frame.pixel(x, 5) == Rgb8{0, 0, 0});
  CHECK(picture.frame.pixel(11, 5) == Rgb8{255, 255, 255});
}

TEST_CASE("Ink: sinks that cannot be read and widths out of range are refused") {
  const Drawing drawing(polygon({at(163, 0), at(163, 512), at(512, 512), at(512, 0)}));
  Picture picture({0, 0, 32, 32});
  const std::vector<std::uint16_t> plain = picture.colours;
  StreamSink stream;
  std::vector<OutlineGap<Rgb565>> memory(50);
  const auto result = [&](auto& sink, const DepthBuffer& depth, std::uint8_t width) {
    return ink_outlines(drawing.outlines, {kInk, width}, sink, depth, std::span(memory));
  };
  CHECK(result(stream, picture.depth, 1) == Status::kUnsupported);
  CHECK(result(picture.frame, picture.depth, 0) == Status::kInvalidArgument);
  CHECK(result(picture.frame, picture.depth, 5) == Status::kInvalidArgument);
  std::vector<std::uint16_t> few(31 * 32);
  CHECK(result(picture.frame, DepthBuffer(few, 32, 31), 1) == Status::kDepthMismatch);
  CHECK(result(picture.frame, DepthBuffer(few, 32, 32), 1) == Status::kBufferTooSmall);
  CHECK(picture.colours == plain);
}

TEST_CASE("Ink: the status of a sink ends it, and the depths are restored") {
  const std::vector<OutlineEdge> edges = polygon({at(163, 0), at(163, 512), at(512, 512), at(512, 0)});
  const Drawing drawing(edges);
  std::vector<OutlineGap<Rgb565>> memory(50);
  for (const int runs : {1, 5, 40}) {
    Picture picture = drawn<Rgb565>(edges);
    const std::vector<std::uint16_t> depths = picture.depths;
    FailingSink sink{picture, runs};
    CHECK(ink_outlines(drawing.outlines, {kInk, 2}, sink, picture.depth, std::span(memory)) ==
          Status::kTransferFailed);
    CHECK(sink.left == 0);
    CHECK(sink.inside);
    CHECK(picture.depths == depths);
  }
}

TEST_CASE("Ink: any edges and depths are safe") {
  Random random(68);
  for (int i = 0; i < share_of(300); ++i) {
    std::vector<OutlineEdge> edges(30);
    const auto any = [&] {
      return static_cast<std::int16_t>(random.integer(-32768, 32767) >> random.integer(0, 8));
    };
    const auto anywhere = [&] {
      return RasterPosition{any(), any(), static_cast<std::uint16_t>(random.integer(0, 65535))};
    };
    for (std::size_t e = 0; e < edges.size(); ++e) {
      edges[e] = {anywhere(), anywhere()};
      if (e != 0 && random.chance(0.3)) edges[e] = {edges[e - 1].to, edges[e - 1].from};
    }
    const Drawing drawing(edges);
    Picture picture({0, 0, 32, 32});
    for (std::uint16_t& z : picture.depths)
      z = static_cast<std::uint16_t>(random.integer(0, random.chance(0.5) ? 40 : 65535));
    const std::vector<std::uint16_t> depths = picture.depths;
    const Status status =
        ink(drawing.outlines, random_ink(random), picture, static_cast<std::size_t>(random.integer(1, 300)));
    CHECK((ok(status) || status == Status::kBufferTooSmall));
    CHECK(picture.depths == depths);
  }
}
