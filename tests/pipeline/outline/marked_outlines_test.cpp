// SPDX-License-Identifier: MIT
// Pictures smoothed without memory: as with memory but at corners, and depths that are marks afterwards.
#include <arcspan/pixel/pixel_format_list.hpp>
#include <arcspan/smooth_outlines.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/outline/outline_pictures.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

[[nodiscard]] constexpr bool is_mark(std::uint16_t depth) { return depth >= 1 && depth <= 15; }

[[nodiscard]] std::size_t differing(const std::vector<std::uint16_t>& a,
                                    const std::vector<std::uint16_t>& b) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < a.size(); ++i) found += a[i] != b[i] ? 1u : 0u;
  return found;
}

}  // namespace

TEST_CASE("Marked outlines: along an edge pixels are those with memory") {
  Random random(70);
  const std::int32_t step = GENERATE(1, 8, 16);
  std::size_t changed = 0;
  for (int i = 0; i < share_of(200); ++i) {
    const std::vector<OutlineEdge> edges = random_triangle(random, step);
    const Drawing drawing(edges);
    const Picture plain = drawn<Rgb565>(edges);
    Picture with_memory = drawn<Rgb565>(edges);
    Picture without = drawn<Rgb565>(edges);
    REQUIRE(ok(smooth(drawing.outlines, with_memory)));
    REQUIRE(ok(smooth_outlines(drawing.outlines, without.frame, without.depth)));
    bool same = true;
    for (std::int32_t y = 0; y < 32; ++y) {
      for (std::int32_t x = 0; x < 32; ++x) {
        if (edges_near(edges, x, y) > 1) continue;
        same = same && with_memory.frame.pixel(x, y) == without.frame.pixel(x, y);
        changed += plain.frame.pixel(x, y) == without.frame.pixel(x, y) ? 0u : 1u;
      }
    }
    CHECK(same);
  }
  CHECK(changed > 5u * static_cast<unsigned>(share_of(200)));
}

TEST_CASE("Marked outlines: pictures of meshes are nearly those with memory, and nearly the same in bands") {
  Random random(71);
  std::size_t changed = 0;
  std::size_t otherwise = 0;
  std::size_t in_bands = 0;
  for (int i = 0; i < share_of(100); ++i) {
    const OutlineScene scene(random, i % 2 != 0);
    Picture plain(scene.bounds());
    Picture with_memory(scene.bounds());
    Picture whole(scene.bounds());
    for (Picture* picture : {&plain, &with_memory, &whole}) scene.draw(*picture);
    REQUIRE(ok(smooth(scene.outlines, with_memory)));
    REQUIRE(ok(smooth_outlines(scene.outlines, whole.frame, whole.depth)));
    changed += differing(plain.colours, with_memory.colours);
    otherwise += differing(with_memory.colours, whole.colours);
    bool marked = true;
    for (std::size_t at = 0; at < plain.depths.size(); ++at)
      marked = marked && (whole.depths[at] == plain.depths[at] || is_mark(whole.depths[at]));
    CHECK(marked);
    const std::int32_t rows = random.integer(4, 30);
    const Rect& all = scene.bounds();
    for (std::int32_t top = 0; top < all.bottom; top += rows) {
      const Rect sent{0, top, all.right, std::min(all.bottom, top + rows)};
      Picture band({0, std::max(0, top - 1), all.right, std::min(all.bottom, sent.bottom + 1)});
      scene.draw(band);
      REQUIRE(ok(smooth_outlines(scene.outlines, band.frame, band.depth)));
      for (std::int32_t y = sent.top; y < sent.bottom; ++y) {
        for (std::int32_t x = 0; x < sent.right; ++x)
          in_bands += whole.frame.pixel(x, y) == band.frame.pixel(x, y) ? 0u : 1u;
      }
    }
  }
  REQUIRE(changed > 100u * static_cast<unsigned>(share_of(100)));
  CHECK(otherwise < changed / 5);
  CHECK(in_bands < changed / 100);
}

TEST_CASE("Marked outlines: what is nearer hides them, and a side is blended once") {
  Random random(72);
  const std::vector<OutlineEdge> edges = random_triangle(random, 1);
  const Picture plain = drawn<Rgb565>(edges);
  for (const int depth_around : {999, 1000, 1001}) {
    Picture picture = drawn<Rgb565>(edges);
    for (std::uint16_t& z : picture.depths)
      if (z == DepthBuffer::kFarthest) z = static_cast<std::uint16_t>(depth_around);
    REQUIRE(ok(smooth_outlines(Drawing(edges).outlines, picture.frame, picture.depth)));
    CHECK((picture.colours != plain.colours) == (depth_around >= 1000));
  }

  // The same edge again, and that of a surface on the other side.
  const OutlineEdge edge{at(165, 0), at(165, 512)};
  const std::vector<OutlineEdge> surface = polygon({at(165, 0), at(165, 512), at(512, 512), at(512, 0)});
  Picture pictures[3] = {drawn<Rgb565>(surface), drawn<Rgb565>(surface), drawn<Rgb565>(surface)};
  const std::vector<OutlineEdge> lists[3] = {{edge}, {edge, edge}, {edge, {edge.to, edge.from}}};
  for (std::size_t i = 0; i < 3; ++i)
    REQUIRE(ok(smooth_outlines(Drawing(lists[i]).outlines, pictures[i].frame, pictures[i].depth)));
  CHECK(pictures[0].colours != drawn<Rgb565>(surface).colours);
  CHECK(pictures[1].colours == pictures[0].colours);
  CHECK(pictures[2].colours == pictures[0].colours);
}

TEST_CASE("Marked outlines: a pixel with surfaces on two sides is blended with both, with each once") {
  // The outline runs a quarter of a pixel inside of column 9 and row 9, whose common pixel is a corner.
  const OutlineEdge upright{at(156, 0), at(156, 156)};
  const OutlineEdge level{at(156, 156), at(0, 156)};
  const Drawing drawing({upright, level, upright, level});
  Picture pictures[2] = {Picture({0, 0, 32, 32}), Picture({0, 0, 32, 32})};
  for (Picture& picture : pictures) {
    for (std::int32_t y = 0; y < 32; ++y) {
      for (std::int32_t x = 0; x < 32; ++x) {
        const bool is_surface = x >= 10 || y >= 10;
        picture.frame.row(y)[x] = is_surface ? 0xFFFF : 0;
        if (is_surface) picture.depth.row(y)[x] = 1000;
      }
    }
  }
  REQUIRE(ok(smooth(drawing.outlines, pictures[0])));
  REQUIRE(ok(smooth_outlines(drawing.outlines, pictures[1].frame, pictures[1].depth)));
  CHECK(pictures[1].colours == pictures[0].colours);
  const std::uint16_t once = detail::blended<Rgb565>(0, 0xFFFF, 8);
  CHECK(pictures[1].colours[5 * 32 + 9] == once);
  CHECK(pictures[1].colours[9 * 32 + 9] == detail::blended<Rgb565>(once, 0xFFFF, 8));
}

TEST_CASE(
    "Marked outlines: sinks that cannot be read or do not blend are refused, and those that fail end it") {
  const std::vector<OutlineEdge> edges = polygon({at(163, 0), at(163, 512), at(512, 512), at(512, 0)});
  const Drawing drawing(edges);
  const Picture picture({0, 0, 32, 32});
  StreamSink stream;
  CHECK(smooth_outlines(drawing.outlines, stream, picture.depth) == Status::kUnsupported);
  PictureOf<Mono> mono({0, 0, 32, 32});
  CHECK(smooth_outlines(drawing.outlines, mono.frame, mono.depth) == Status::kUnsupported);
  Picture small({0, 0, 32, 32});
  std::vector<std::uint16_t> few(31 * 32);
  CHECK(smooth_outlines(drawing.outlines, small.frame, DepthBuffer(few, 32, 31)) == Status::kDepthMismatch);
  CHECK(smooth_outlines(drawing.outlines, small.frame, DepthBuffer(few, 32, 32)) == Status::kBufferTooSmall);
  Picture failing = drawn<Rgb565>(edges);
  FailingSink sink{failing, 5};
  CHECK(smooth_outlines(drawing.outlines, sink, failing.depth) == Status::kTransferFailed);
  CHECK(sink.left == 0);
  CHECK(sink.inside);
}

TEST_CASE("Marked outlines: any edges and depths are safe") {
  Random random(73);
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
    CHECK(ok(smooth_outlines(drawing.outlines, picture.frame, picture.depth)));
    bool marked = true;
    for (std::size_t at = 0; at < depths.size(); ++at)
      marked = marked && (picture.depths[at] == depths[at] || is_mark(picture.depths[at]));
    CHECK(marked);
  }
}
