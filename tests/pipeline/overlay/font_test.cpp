// SPDX-License-Identifier: MIT
#include <arcspan/overlay/font.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/overlay/overlay_support.hpp>

#include <array>

using namespace arcspan;
using namespace arcspan::overlay;

namespace {

constexpr std::array<Glyph, 4> kGlyphs{
    {{0, 0, 0, 2, 2, 3}, {1, 2, 0, 8, 3, 9}, {4, -3, 0, 1, 1, 1}, {0, 0, 0, 0, 0, 5}}};
constexpr std::array<std::uint8_t, 9> kBitmaps{};

Status made(std::initializer_list<GlyphRange> ranges, std::size_t glyphs = 4, std::size_t bytes = 9,
            std::int32_t line_height = 4) {
  Font<1> font;
  const std::vector<GlyphRange> list(ranges);
  return Font<1>::make(list, std::span(kGlyphs).first(glyphs), std::span(kBitmaps).first(bytes), line_height,
                       font);
}

}  // namespace

TEST_CASE("a font finds the glyph of each code point, or its placeholder") {
  const std::array<GlyphRange, 3> ranges{{{0x20, 0, 1, 3}, {0x41, 0, 2, 1}, {0x10FFFF, 0, 1, 2}}};
  Font<1> font;
  REQUIRE(ok(Font<1>::make(ranges, kGlyphs, kBitmaps, 4, font)));
  const auto index = [&](std::uint32_t code) { return font.find(code).glyph - kGlyphs.data(); };
  CHECK(index(0x20) == 3);
  CHECK(index(0x41) == 1);
  CHECK(index(0x42) == 2);
  CHECK(index(0x10FFFF) == 2);
  for (const std::uint32_t missing : {0x21u, 0x40u, 0x43u, 0x10FFFEu, 0x110000u, 0xFFFFFFFFu})
    CHECK(index(missing) == 0);
  for (const std::uint32_t control : {0u, 9u, 10u, 0x1Fu}) CHECK(index(control) == 3);
  CHECK(font.find(0x42).bitmap == kBitmaps.data() + 4);
  CHECK(font.line_height() == 4);
  CHECK(font.top() == -3);
  CHECK(font.bottom() == 5);
  CHECK(text_width(font, "AB C") == 9 + 1 + 5 + 3);
  CHECK(missing_glyphs(font, "AB\nC\xFF") == 2);
  static constexpr std::array<GlyphRange, 1> kLower{{{0x41, 0, 2, 2}}};  // the last is not the highest
  REQUIRE(ok(Font<1>::make(kLower, kGlyphs, kBitmaps, 4, font)));
  CHECK(font.top() == -3);
  static constexpr std::array<GlyphRange, 1> kRange{{{0x41, 0, 2, 1}}};
  static_assert(Font<1>::of(kRange, kGlyphs, kBitmaps, 4).bottom() == 5);
}

TEST_CASE("tables that contradict themselves are no font") {
  CHECK(made({{0x41, 0, 2, 1}}) == Status::kOk);
  CHECK(made({}) == Status::kOk);
  CHECK(made({{0x41, 0, 2, 1}}, 0) == Status::kIndexOutOfRange);
  CHECK(made({{0x41, 0, 2, 1}}, 2) == Status::kIndexOutOfRange);
  CHECK(made({{0x41, 0, 0, 1}}) == Status::kInvalidArgument);
  CHECK(made({{0x41, 0, 2, 1}, {0x42, 0, 1, 1}}) == Status::kInvalidArgument);
  CHECK(made({{0x42, 0, 1, 1}, {0x41, 0, 1, 1}}) == Status::kInvalidArgument);
  CHECK(made({{0x10FFFF, 0, 2, 1}}) == Status::kInvalidArgument);
  CHECK(made({{0xFFFFFFFF, 0, 2, 1}}) == Status::kInvalidArgument);
  CHECK(made({{0x41, 0, 1, 1}}, 4, 9, 0) == Status::kInvalidArgument);
  CHECK(made({{0x41, 0, 1, 1}}, 4, 9, 32768) == Status::kInvalidArgument);
  CHECK(made({{0x41, 0, 1, 1}}, 4, 8) == Status::kOk);
  CHECK(made({{0x41, 0, 1, 1}}, 4, 7) == Status::kBufferTooSmall);
  CHECK(made({{0x41, 1, 1, 1}}, 4, 8) == Status::kBufferTooSmall);
  CHECK(made({{0x41, 0xFFFFFFFF, 1, 1}}) == Status::kBufferTooSmall);
  CHECK(made({}, 1, 4) == Status::kBufferTooSmall);  // the placeholder
  Font<1> unchanged;
  CHECK(unchanged.find('A').glyph->width == 0);
  CHECK(text_width(unchanged, "abc") == 0);
}

TEST_CASE("the width of a text saturates") {
  const std::string many(9'000'000, 'a');
  const std::array<Glyph, 1> wide{{{0, 0, 0, 0, 0, 255}}};
  Font<1> font;
  REQUIRE(ok(Font<1>::make({}, wide, kBitmaps, 1, font)));
  CHECK(text_width(font, many) >= INT32_MAX - 255);
}
