// SPDX-License-Identifier: MIT
#include <arcspan/hal/panel/damage.hpp>
#include <arcspan/overlay/text.hpp>
#include <arcspan/pixel/gray2.hpp>
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/pixel/mono.hpp>
#include <arcspan/pixel/rgb565.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/overlay/overlay_support.hpp>
#include <tests/support/strict_sink.hpp>

using namespace arcspan;
using namespace arcspan::overlay;
using namespace arcspan::test;

namespace {

constexpr Rgb8 kInk = TextPicture::kInk;
constexpr Rgb8 kOther = TextPicture::kOther;

}  // namespace

TEST_CASE("text: glyphs stand at their pens, with what is left of these and above the line") {
  TextPicture picture(14, 8);
  CHECK(draw_text(picture.frame, plain_font().font, {1, 2}, "Lip\xFF", kInk) == Status::kOk);
  CHECK(picture.rows() == Rows{
                              "              ",
                              "      #       ",
                              " #          ##",
                              " #  ##   ## # ",
                              " #   #   ## # ",
                              " ######  #  ##",
                              "         #    ",
                              "              ",
                          });
}

TEST_CASE("text: an outline surrounds all letters, and covers no other one") {
  TextPicture picture(13, 8);
  CHECK(draw_text(picture.frame, plain_font().font, {2, 2}, "LLi", OutlinedText{kInk, kOther}) ==
        Status::kOk);
  CHECK(picture.rows() == Rows{
                              "          ooo",
                              " ooo ooo  o#o",
                              " o#o o#oooooo",
                              " o#o o#oo##o ",
                              " o#ooo#ooo#oo",
                              " o###o######o",
                              " oooooooooooo",
                              "             ",
                          });
}

TEST_CASE("text: a background is as wide as the text and as high as the line") {
  TextPicture picture(10, 7);
  CHECK(draw_text(picture.frame, plain_font().font, {1, 1}, "L L", FilledText{kInk, kOther}) == Status::kOk);
  CHECK(picture.rows() == Rows{
                              "          ",
                              " #oooooo#o",
                              " #oooooo#o",
                              " #oooooo#o",
                              " ###oooo##",
                              " ooooooooo",
                              "          ",
                          });
}

TEST_CASE("text: rows of more than 32 pixels are whole, with outlines too") {
  TextPicture picture(44, 5);
  CHECK(draw_text(picture.frame, plain_font().font, {2, 0}, "W", OutlinedText{kInk, kOther}) == Status::kOk);
  const std::string bar(40, '#');
  const std::string edge = std::string(42, 'o');
  CHECK(picture.rows() == Rows{" " + edge + " ", " o" + bar + "o ", " o#" + std::string(38, 'o') + "#o ",
                               " ooo" + std::string(36, ' ') + "ooo ", std::string(44, ' ')});
}

TEST_CASE("text: behind the last column of a wide letter its outline does not see the next row") {
  const DrawnFont<1> font({{0xFFFD, 0, 0, 41, {std::string(40, ' '), "#" + std::string(39, ' ')}}}, 3);
  TextPicture picture(44, 4);
  CHECK(draw_text(picture.frame, font.font, {1, 1}, "?", OutlinedText{kInk, kOther}) == Status::kOk);
  for (const std::string& row : picture.rows()) CHECK(row.substr(3) == std::string(41, ' '));
}

TEST_CASE("smooth text: coverage mixes the colour with the pixels below it") {
  std::array<std::uint8_t, 8 * 6> memory{};
  hal::Framebuffer<Gray8> frame(memory, 8, 6);
  frame.clear({100, 100, 100});
  CHECK(draw_text(frame, smooth_font().font, {1, 1}, "Li", Rgb8{255, 255, 255}) == Status::kOk);
  // Shares of 32: 1 is 2, 3 is 6, 4 is 9, 7 is 15, 8 is 17, f is 32.
  const std::array<std::array<int, 8>, 6> expected{{
      {100, 100, 100, 100, 100, 100, 173, 100},
      {100, 255, 100, 100, 100, 100, 100, 100},
      {100, 255, 144, 100, 129, 255, 100, 100},
      {100, 255, 182, 255, 110, 255, 110, 100},
      {100, 100, 100, 100, 100, 100, 100, 100},
      {100, 100, 100, 100, 100, 100, 100, 100},
  }};
  for (std::int32_t y = 0; y < 6; ++y)
    for (std::int32_t x = 0; x < 8; ++x)
      CHECK(int{frame.pixel(x, y).r} == expected[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)]);
}

TEST_CASE("smooth text: an outline is no wider than a pixel") {
  std::array<std::uint8_t, 8 * 6> memory{};
  hal::Framebuffer<Gray8> frame(memory, 8, 6);
  frame.clear({100, 100, 100});
  CHECK(draw_text(frame, smooth_font().font, {1, 1}, "L", OutlinedText{{255, 255, 255}, {0, 0, 0}}) ==
        Status::kOk);
  CHECK(frame.pixel(0, 0).r == 0);
  CHECK(frame.pixel(1, 1).r == 255);
  CHECK(frame.pixel(4, 0).r == 100);  // beside a corner without coverage
}

TEMPLATE_TEST_CASE("smooth text: full coverage is the colour, and none changes nothing", "", Rgb565, Gray2,
                   Mono, Rgb888) {
  std::vector<typename TestType::Word> memory(hal::Framebuffer<TestType>::words(8, 8));
  hal::Framebuffer<TestType> frame(memory, 8, 8);
  for (const Rgb8 below : {Rgb8{0, 0, 0}, Rgb8{255, 255, 255}, Rgb8{90, 160, 30}}) {
    frame.clear(below);
    const Rgb8 ground = frame.pixel(0, 0);
    const Rgb8 colour{200, 30, 250};
    CHECK(draw_text(frame, smooth_font().font, {1, 1}, "L", colour) == Status::kOk);
    CHECK(frame.pixel(1, 1) == TestType::decode(TestType::encode(colour)));
    CHECK(frame.pixel(2, 1) == ground);
  }
}

TEST_CASE("smooth text: black and white are chosen by half a coverage") {
  std::array<std::uint8_t, 8> memory{};
  hal::Framebuffer<Mono> frame(memory, 8, 8);
  CHECK(draw_text(frame, smooth_font().font, {1, 2}, "iL", Rgb8{255, 255, 255}) == Status::kOk);
  CHECK(!(frame.pixel(2, 1).r != 0));  // coverage 7 of 15
  CHECK(frame.pixel(5, 4).r == 255);   // coverage 8 of 15
}

TEST_CASE("text: only pixels of glyphs are opened, each once, and marked as damage") {
  StrictSink sink({0, 0, 14, 8});
  CHECK(draw_text(sink, plain_font().font, {1, 2}, "Lip", kInk) == Status::kOk);
  CHECK(sink.faults() == SinkFaults{});
  CHECK(sink.text() == "\n      #\n #\n #  ##   ##\n #   #   ##\n ######  #\n         #\n\n");

  std::vector<hal::RowExtent> memory(hal::Damage::extents(8));
  hal::Damage damage(memory, 14, 8);
  TextPicture picture(14, 8);
  hal::DamageSink marked(picture.frame, damage);
  for (int frame = 0; frame < 3; ++frame) damage.begin_frame();
  CHECK(draw_text(marked, plain_font().font, {1, 2}, "Lip", kInk) == Status::kOk);
  CHECK(damage.changed_area(0, 8) == Rect{1, 1, 11, 7});
  CHECK(damage.changed_area(2, 3) == Rect{1, 2, 2, 3});
}

TEST_CASE("text: nothing is drawn into a sink that refuses, and the first refusal ends it") {
  hal::Framebuffer<Gray8> none({}, 10, 10);
  CHECK(draw_text(none, plain_font().font, {0, 0}, "L", kInk) == Status::kBufferTooSmall);
  struct Refusing : StrictSink {
    using StrictSink::StrictSink;
    Status close(const Span& run) {
      (void)StrictSink::close(run);
      return runs() == 3 ? Status::kBusy : Status::kOk;
    }
  };
  Refusing refusing(Rect{0, 0, 14, 8});
  CHECK(draw_text(refusing, plain_font().font, {1, 2}, "Lip", OutlinedText{kInk, kOther}) == Status::kBusy);
  CHECK(refusing.runs() == 3);
}

TEST_CASE("text far outside of the picture is not seen, at any coordinate") {
  TextPicture picture(16, 8);
  constexpr std::int32_t kFar[] = {INT32_MIN, INT32_MIN + 1, INT32_MIN / 2, -200,
                                   30,        INT32_MAX / 2, INT32_MAX - 1, INT32_MAX};
  for (const std::int32_t x : kFar) {
    for (const std::int32_t y : kFar) {
      CHECK(draw_text(picture.frame, plain_font().font, {x, y}, "WLip L", OutlinedText{kInk, kOther}) ==
            Status::kOk);
      CHECK(draw_text(picture.frame, smooth_font().font, {x, y}, "WLip L", OutlinedText{kInk, kOther}) ==
            Status::kOk);
      CHECK(draw_text(picture.frame, plain_font().font, {x, y}, "WLip L", FilledText{kInk, kOther}) ==
            Status::kOk);
    }
  }
  for (const std::string& row : picture.rows()) CHECK(row == std::string(16, ' '));
}

TEST_CASE("text is drawn modulo 2^32, without overflow") {
  struct UpperRows {
    using Format = Gray8;
    [[nodiscard]] static constexpr Rect bounds() { return {0, INT32_MIN, 2, INT32_MIN + 3}; }
    [[nodiscard]] constexpr Gray8::Cursor open(const Span& run) {
      return {pixels + 2 * (run.y - INT32_MIN), run.x};
    }
    [[nodiscard]] static constexpr Status close(const Span&) { return Status::kOk; }
    std::uint8_t pixels[2 * 3] = {};
  };
  // A column of three pixels, of which the first is above row INT32_MIN.
  const auto drawn = []<unsigned Bits>(const Font<Bits>& font) {
    UpperRows sink;
    const Status status = draw_text(sink, font, {0, INT32_MAX}, "I", Rgb8{255, 255, 255});
    return ok(status) && sink.pixels[0] == 255 && sink.pixels[2] == 255 && sink.pixels[4] == 0;
  };
  static constexpr Glyph kGlyph{0, 0, 0, 1, 3, 2};
  static constexpr std::uint8_t kBitmap[] = {0xFF, 0xF0, 0, 0, 0, 0};
  constexpr bool kPlain = drawn(Font<1>::of({}, {&kGlyph, 1}, kBitmap, 3));
  constexpr bool kSmooth = drawn(Font<4>::of({}, {&kGlyph, 1}, kBitmap, 3));
  CHECK(kPlain);
  CHECK(kSmooth);
}
