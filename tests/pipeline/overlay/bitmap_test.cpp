// SPDX-License-Identifier: MIT
#include <arcspan/overlay/bitmap.hpp>
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/pixel/rgb565.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/overlay/overlay_support.hpp>
#include <tests/support/strict_sink.hpp>

#include <array>

using namespace arcspan;
using namespace arcspan::overlay;
using namespace arcspan::test;

namespace {

/// 0 is transparent, 1 red, 2 white.
using Icon = Palette4Texels<Alpha1Colour>;
constexpr std::array<std::uint16_t, 16> kPalette = {0x0000, 0xF820, 0xFFFF};
constexpr std::array<std::uint8_t, 8> kIcon = {0x01, 0x20, 0x01, 0x22, 0x01, 0x11, 0x10, 0x00};  // 5x3 pixels
constexpr Bitmap<Icon> kBitmap = Bitmap<Icon>::of(kIcon, 5, 3, kPalette);

}  // namespace

TEST_CASE("bitmaps: rows follow each other within bytes, and transparent pixels are left alone") {
  TextPicture picture(8, 5);
  picture.frame.clear(TextPicture::kThird);
  CHECK(draw_bitmap(picture.frame, {1, 1}, kBitmap) == Status::kOk);
  CHECK(picture.rows() == Rows{"........", "..o#....", ".o##.o..", ".ooo....", "........"});
}

TEST_CASE("bitmaps: parts outside of the picture are left out, at any place") {
  StrictSink sink({0, 0, 4, 3});
  CHECK(draw_bitmap(sink, {-2, -1}, kBitmap) == Status::kOk);
  CHECK(sink.text() == "# #\n#\n\n");
  CHECK(sink.faults() == SinkFaults{});
  sink.clear();
  for (const std::int32_t x : {INT32_MIN, -5, 4, INT32_MAX})
    for (const std::int32_t y : {INT32_MIN, -3, 3, INT32_MAX})
      CHECK(draw_bitmap(sink, {x, y}, kBitmap) == Status::kOk);
  CHECK(sink.drawn() == 0);
}

TEST_CASE("bitmaps: four bits of opacity mix, in formats of 5-6-5 and in others") {
  static constexpr std::array<std::uint16_t, 3> kTexels = {0xF00F, 0xFFF8,
                                                           0xFFF0};  // red, white of 9/16, none
  constexpr auto kMixed = Bitmap<DirectTexels<Alpha4Colour>>::of(kTexels, 3, 1);
  std::array<std::uint16_t, 3> colours{};
  hal::Framebuffer<Rgb565> frame(colours, 3, 1);
  CHECK(draw_bitmap(frame, {0, 0}, kMixed) == Status::kOk);
  CHECK(colours == std::array<std::uint16_t, 3>{0xF800, 0x8C71, 0});
  std::array<std::uint8_t, 3> greys{0, 100, 100};
  hal::Framebuffer<Gray8> grey(greys, 3, 1);
  CHECK(draw_bitmap(grey, {0, 0}, kMixed) == Status::kOk);
  CHECK(greys == std::array<std::uint8_t, 3>{77, 187, 100});
}

TEST_CASE("bitmaps: textures are bitmaps, and opaque rows are one run") {
  std::array<std::uint8_t, 64> levels{};
  for (std::size_t i = 0; i < 64; ++i) levels[i] = static_cast<std::uint8_t>(i % 8 == 7 ? 255 : 0);
  Texture<GrayTexels> texture;
  REQUIRE(ok(Texture<GrayTexels>::make(levels, {3, 3, 1}, texture)));
  StrictSink sink({0, 0, 10, 10});
  CHECK(draw_bitmap(sink, {1, 1}, Bitmap(texture)) == Status::kOk);
  CHECK(sink.drawn() == 64);
  CHECK(sink.runs() == 8);
  CHECK(sink.cell(8, 8).colour == Rgb8{255, 255, 255});
  CHECK(sink.cell(7, 8).colour == Rgb8{0, 0, 0});
}

TEST_CASE("bitmaps: wrong sizes and too little memory are refused") {
  Bitmap<Icon> bitmap = kBitmap;
  CHECK(Bitmap<Icon>::make(kIcon, 5, 4, bitmap, kPalette) == Status::kBufferTooSmall);
  CHECK(Bitmap<Icon>::make(kIcon, 5, 3, bitmap, std::span(kPalette).first(15)) == Status::kBufferTooSmall);
  CHECK(Bitmap<Icon>::make(kIcon, 0, 3, bitmap, kPalette) == Status::kInvalidArgument);
  CHECK(Bitmap<Icon>::make(kIcon, 1, 8193, bitmap, kPalette) == Status::kInvalidArgument);
  CHECK(Bitmap<Icon>::make(kIcon, 8192, 8192, bitmap, kPalette) == Status::kBufferTooSmall);
  CHECK(bitmap.width() == 5);
  Bitmap<GrayTexels> grey;
  CHECK(Bitmap<GrayTexels>::make(kIcon, 2, 2, grey, kPalette) == Status::kInvalidArgument);
  StrictSink sink({0, 0, 4, 3});
  CHECK(draw_bitmap(sink, {0, 0}, grey) == Status::kOk);
  CHECK(sink.drawn() == 0);
}
