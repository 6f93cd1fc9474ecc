// SPDX-License-Identifier: MIT
// A part of a sink as a scissor, and the depth tests, each by points, which cover whole rectangles.
#include <arcspan/draw_lines.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/pixel/sink_part.hpp>
#include <arcspan/span/depth_mode.hpp>

#include <catch2/catch.hpp>

#include <array>
#include <climits>
#include <cstddef>
#include <cstdint>
#include <vector>

using namespace arcspan;

namespace {

constexpr Viewport kView{40, 30};
constexpr std::size_t kPixels = static_cast<std::size_t>(kView.width * kView.height);
constexpr PackedRgb kWhite255 = Unlit::lighting({255, 255, 255});
constexpr ObjectPosition kMiddle{};
constexpr Placement kAhead{Rotation::identity(), {{}, {}, ObjectLength::of(-8000)}};
constexpr ClipTransform kTransform =
    ClipTransform::of(kAhead, {PixelLength::of(30), ObjectLength::of(1000), ObjectLength::of(60000)}, kView);

/// A sink that is no framebuffer: it has no rows and no status.
struct Plain {
  using Format = Gray8;
  std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(kPixels);

  [[nodiscard]] Rect bounds() const { return {0, 0, kView.width, kView.height}; }
  [[nodiscard]] Format::Cursor open(const Span& run) { return {pixels.data() + run.y * kView.width, run.x}; }
  [[nodiscard]] Status close(const Span&) { return Status::kOk; }
};

static_assert(SinkInMemory<SinkPart<hal::Framebuffer<Gray8>>>);
static_assert(PixelSink<SinkPart<Plain>> && !SinkInMemory<SinkPart<Plain>>);

template <class Sink>
Status cover(Sink& sink) {
  return draw_points({&kMiddle, 1}, 255, kTransform, kWhite255, sink, NoDepth{});
}

}  // namespace

TEST_CASE("only the pixels of a sink's part are drawn") {
  const Rect rects[] = {{3, 4, 11, 9},    {-5, -7, 6, 6},
                        {30, 20, 90, 99}, {0, 0, 40, 30},
                        {12, 5, 12, 20},  {20, 9, 10, 12},
                        {50, 0, 60, 30},  {-9, -9, 0, 0},
                        {7, 8, 8, 9},     {INT_MIN, INT_MIN, INT_MAX, INT_MAX}};
  for (const Rect& rect : rects) {
    INFO(rect.left << ", " << rect.top << ", " << rect.right << ", " << rect.bottom);
    std::vector<std::uint8_t> memory(kPixels);
    hal::Framebuffer<Gray8> frame(memory, kView.width, kView.height);
    Plain plain;
    SinkPart part(frame, rect);
    SinkPart plain_part(plain, rect);
    REQUIRE(ok(cover(part)));
    REQUIRE(ok(cover(plain_part)));
    std::vector<std::uint8_t> wanted(kPixels);
    for (std::size_t i = 0; i < kPixels; ++i) {
      const std::int32_t x = static_cast<std::int32_t>(i) % kView.width;
      const std::int32_t y = static_cast<std::int32_t>(i) / kView.width;
      const bool inside = x >= rect.left && x < rect.right && y >= rect.top && y < rect.bottom;
      wanted[i] = inside ? 255 : 0;
    }
    CHECK(memory == wanted);
    CHECK(plain.pixels == wanted);
  }
}

TEST_CASE("a part of a sink follows its bands and tells its status") {
  std::vector<std::uint8_t> memory(kPixels / 2);
  hal::Framebuffer<Gray8> band(memory, kView.width, kView.height / 2);
  SinkPart part(band, {5, 10, 9, 20});
  CHECK(part.bounds() == Rect{5, 10, 9, 15});
  band.move_to(15);
  CHECK(part.bounds() == Rect{5, 15, 9, 20});
  CHECK(part.status() == Status::kOk);
  hal::Framebuffer<Gray8> none({}, 8, 8);
  SinkPart nothing(none, {0, 0, 4, 4});
  CHECK(cover(nothing) == Status::kBufferTooSmall);
}

TEST_CASE("depth modes draw what they say, and write depths if they say so") {
  const std::uint16_t surface = project(kTransform(kMiddle), kTransform).z;
  const auto check = [&](const auto& make, const std::array<bool, 3>& passes, bool writes) {
    for (int i = 0; i < 3; ++i) {
      const auto stored = static_cast<std::uint16_t>(surface + i - 1);
      std::vector<std::uint8_t> pixels(kPixels);
      std::vector<std::uint16_t> depths(kPixels, stored);
      hal::Framebuffer<Gray8> frame(pixels, kView.width, kView.height);
      DepthBuffer depth(depths, kView.width, kView.height);
      REQUIRE(ok(draw_points({&kMiddle, 1}, 255, kTransform, kWhite255, frame, make(depth))));
      const bool drawn = passes[static_cast<std::size_t>(i)];
      CHECK(pixels == std::vector<std::uint8_t>(kPixels, drawn ? 255 : 0));
      CHECK(depths == std::vector<std::uint16_t>(kPixels, drawn && writes ? surface : stored));
    }
  };
  // Whether a pixel is drawn where the stored depth is nearer, equal, farther.
  using enum DepthCompare;
  check([](const DepthBuffer& d) { return d; }, {false, false, true}, true);
  check([](const DepthBuffer& d) { return DepthMode<kNearerOrEqual, true>(d); }, {false, true, true}, true);
  check([](const DepthBuffer& d) { return DepthMode<kEqual, true>(d); }, {false, true, false}, true);
  check([](const DepthBuffer& d) { return DepthMode<kFarther, false>(d); }, {true, false, false}, false);
  check([](const DepthBuffer& d) { return DepthMode<kAlways, true>(d); }, {true, true, true}, true);
}
