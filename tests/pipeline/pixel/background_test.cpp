// SPDX-License-Identifier: MIT
// Backgrounds: the rows of a gradient against its formula, a picture against its pixels, and both in bands.
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/background.hpp>
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/rgb888.hpp>
#include <arcspan/pixel/sink_part.hpp>

#include <catch2/catch.hpp>
#include <tests/support/strict_sink.hpp>

#include <cmath>
#include <vector>

using namespace arcspan;
using hal::Framebuffer;

namespace {

constexpr std::int32_t kWidth = 21;
constexpr std::int32_t kHeight = 50;

/// Draws a background in bands and returns the memory of the whole picture.
template <class Format, class Background>
std::vector<typename Format::Word> drawn(const Background& background, std::int32_t rows) {
  const std::size_t per_row = Format::words_per_row(kWidth);
  std::vector<typename Format::Word> picture;
  for (std::int32_t top = 0; top < kHeight; top += rows) {
    const std::int32_t height = std::min(rows, kHeight - top);
    std::vector<typename Format::Word> memory(Framebuffer<Format>::words(kWidth, height));
    Framebuffer<Format> band(memory, kWidth, height, top);
    REQUIRE(ok(draw_background(band, background)));
    picture.insert(picture.end(), memory.begin(), memory.end());
  }
  REQUIRE(picture.size() == per_row * kHeight);
  return picture;
}

}  // namespace

TEST_CASE("a gradient is linear from its upper colour to its lower one") {
  const VerticalGradient sky{{0, 255, 17}, {255, 3, 17}, kHeight};
  const std::vector<Rgb8> picture = drawn<Rgb888>(sky, kHeight);
  for (std::int32_t y = 0; y < kHeight; ++y) {
    const double t = double(y) / (kHeight - 1);
    const Rgb8 pixel = picture[static_cast<std::size_t>(y * kWidth + y % kWidth)];
    CAPTURE(y);
    CHECK(std::abs(pixel.r - 255 * t) < 0.51);
    CHECK(std::abs(pixel.g - (255 - 252 * t)) < 0.51);
    CHECK(pixel.b == 17);
  }
  CHECK(picture.front() == Rgb8{0, 255, 17});
  CHECK(picture.back() == Rgb8{255, 3, 17});
}

TEST_CASE("a gradient in bands is the gradient, dithered too") {
  const VerticalGradient sky{{10, 20, 200}, {250, 240, 100}, kHeight};
  CHECK(drawn<Rgb565>(sky, 7) == drawn<Rgb565>(sky, kHeight));
  CHECK(drawn<Dithered<Gray4>>(sky, 1) == drawn<Dithered<Gray4>>(sky, kHeight));
  CHECK(drawn<Dithered<Rgb565>>(sky, kHeight) != drawn<Rgb565>(sky, kHeight));
}

TEMPLATE_TEST_CASE("a picture is copied pixel for pixel, in bands too", "", Rgb565, Gray4) {
  const std::vector<typename TestType::Word> pixels =
      drawn<Dithered<TestType>>(VerticalGradient{{0, 0, 0}, {255, 255, 255}, kHeight}, kHeight);
  const BackgroundPicture<TestType> picture{pixels, kWidth, kHeight};
  CHECK(drawn<TestType>(picture, kHeight) == pixels);
  CHECK(drawn<TestType>(picture, 9) == pixels);
}

TEST_CASE("backgrounds that do not fit are refused and change nothing") {
  std::vector<Rgb565::Word> memory(kWidth * 4, 0x1234);
  Framebuffer<Rgb565> band(memory, kWidth, 4, kHeight - 4);
  CHECK(draw_background(band, VerticalGradient{{}, {}, 0}) == Status::kInvalidArgument);
  CHECK(draw_background(band, VerticalGradient{{}, {}, 32768}) == Status::kInvalidArgument);
  const std::vector<Rgb565::Word> pixels(kWidth * kHeight);
  using Picture = BackgroundPicture<Rgb565>;
  CHECK(draw_background(band, Picture{pixels, kWidth, kHeight - 1}) == Status::kInvalidArgument);
  CHECK(draw_background(band, Picture{pixels, kWidth - 1, kHeight}) == Status::kInvalidArgument);
  CHECK(draw_background(band, Picture{pixels, 0, kHeight}) == Status::kInvalidArgument);
  CHECK(draw_background(band, Picture{pixels, kWidth + 1, kHeight}) == Status::kBufferTooSmall);
  CHECK(memory == std::vector<Rgb565::Word>(kWidth * 4, 0x1234));
  CHECK(ok(draw_background(band, Picture{pixels, kWidth, kHeight})));
  CHECK(memory == std::vector<Rgb565::Word>(kWidth * 4, 0));
}

TEST_CASE("rows beyond a gradient have its nearest colour") {
  std::vector<Rgb888::Word> memory(4);
  Framebuffer<Rgb888> frame(memory, 1, 4);
  CHECK(ok(draw_background(frame, VerticalGradient{{10, 10, 10}, {20, 20, 20}, 2})));
  CHECK(memory == std::vector<Rgb8>{{10, 10, 10}, {20, 20, 20}, {20, 20, 20}, {20, 20, 20}});
  CHECK(ok(draw_background(frame, VerticalGradient{{10, 10, 10}, {20, 20, 20}, 1})));
  CHECK(memory[0] == Rgb8{10, 10, 10});
  test::StrictSink above({0, -200, 1, 1});
  CHECK(ok(draw_background(above, VerticalGradient{{10, 10, 10}, {255, 20, 20}, 2})));
  for (std::int32_t y = -200; y <= 0; ++y) REQUIRE(above.cell(0, y).colour == Rgb8{10, 10, 10});
}

TEST_CASE("a background in a sink that takes no pixels has the status of the sink") {
  std::vector<Rgb565::Word> memory(kWidth * 4);
  Framebuffer<Rgb565> small(memory, kWidth, 5);
  const BackgroundPicture<Rgb565> picture{memory, kWidth, 4};
  CHECK(draw_background(small, Rgb8{}) == Status::kBufferTooSmall);
  CHECK(draw_background(small, VerticalGradient{{}, {}, 5}) == Status::kBufferTooSmall);
  CHECK(draw_background(small, picture) == Status::kBufferTooSmall);
  Framebuffer<Rgb565> band(memory, kWidth, 4);
  band.move_to(-1);
  SinkPart part(band, {0, 0, 4, 4});
  CHECK(draw_background(part, Rgb8{}) == Status::kInvalidArgument);
}
