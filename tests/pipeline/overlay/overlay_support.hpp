// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/overlay/font.hpp>
#include <arcspan/pixel/rgb888.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace arcspan::test {

/// A character of a font, drawn as text: '#' is a pixel of a font of 1 bit, a hexadecimal digit the coverage
/// of one of 4 bits, ' ' none.
struct Drawn {
  std::uint32_t code = 0;
  std::int32_t left = 0;
  std::int32_t top = 0;
  std::int32_t advance = 0;
  std::vector<std::string> rows;
};

/// The tables of a font. The first character is the placeholder too.
template <unsigned Bits>
struct DrawnFont {
  std::vector<overlay::GlyphRange> ranges;
  std::vector<overlay::Glyph> glyphs;
  std::vector<std::uint8_t> bitmaps;
  overlay::Font<Bits> font;

  DrawnFont(std::vector<Drawn> characters, std::int32_t line_height) {
    add(characters[0]);
    std::sort(characters.begin(), characters.end(),
              [](const Drawn& a, const Drawn& b) { return a.code < b.code; });
    for (const Drawn& drawn : characters) {
      ranges.push_back({drawn.code, 0, 1, static_cast<std::uint16_t>(glyphs.size())});
      add(drawn);
    }
    bitmaps.resize(bitmaps.size() + overlay::Font<Bits>::kPadding);
    REQUIRE(ok(overlay::Font<Bits>::make(ranges, glyphs, bitmaps, line_height, font)));
  }
  DrawnFont(const DrawnFont&) = delete;
  DrawnFont& operator=(const DrawnFont&) = delete;

 private:
  void add(const Drawn& drawn) {
    overlay::Glyph glyph;
    glyph.bitmap = static_cast<std::uint16_t>(bitmaps.size());
    glyph.top = static_cast<std::int16_t>(drawn.top);
    glyph.left = static_cast<std::int8_t>(drawn.left);
    glyph.advance = static_cast<std::uint8_t>(drawn.advance);
    glyph.height = static_cast<std::uint8_t>(drawn.rows.size());
    glyph.width = static_cast<std::uint8_t>(drawn.rows.empty() ? 0 : drawn.rows[0].size());
    glyphs.push_back(glyph);
    unsigned bit = 0;
    for (const std::string& row : drawn.rows) {
      REQUIRE(row.size() == glyph.width);
      for (const char c : row) {
        if (bit % 8 == 0) bitmaps.push_back(0);
        const unsigned value = c == ' '    ? 0u
                               : Bits == 1 ? 1u
                                           : static_cast<unsigned>(std::stoi(std::string{c}, nullptr, 16));
        bitmaps.back() = static_cast<std::uint8_t>(bitmaps.back() | (value << (8 - Bits - bit % 8)));
        bit += Bits;
      }
    }
  }
};

/// A font of 1 bit with a placeholder, a space, `i` with a serif left of its pen, `L`, and a wide `W` of 40
/// columns, more than one word of bits.
inline const DrawnFont<1>& plain_font() {
  static const DrawnFont<1> font({{0xFFFD, 0, 0, 4, {"###", "# #", "# #", "###"}},
                                  {' ', 0, 0, 3, {}},
                                  {'L', 0, 0, 4, {"#  ", "#  ", "#  ", "###"}},
                                  {'i', -1, -1, 3, {"  #", "   ", "## ", " # ", "###"}},
                                  {'p', 1, 1, 4, {"##", "##", "# ", "# "}},
                                  {'W', 0, 1, 41, {std::string(40, '#'), "#" + std::string(38, ' ') + "#"}}},
                                 5);
  return font;
}

/// The same letters with smooth edges.
inline const DrawnFont<4>& smooth_font() {
  static const DrawnFont<4> font({{0xFFFD, 0, 0, 4, {"f8f", "8 8", "f8f"}},
                                  {' ', 0, 0, 3, {}},
                                  {'L', 0, 0, 4, {"f  ", "f4 ", "f8f"}},
                                  {'i', -1, -1, 3, {"  7", "   ", "3f ", "1f1"}},
                                  {'W', 0, 1, 41, {std::string(40, 'a'), "1" + std::string(38, ' ') + "f"}}},
                                 5);
  return font;
}

/// A small picture whose pixels can be read as text.
struct TextPicture {
  std::vector<Rgb8> pixels;
  hal::Framebuffer<Rgb888> frame;

  TextPicture(std::int32_t width, std::int32_t height)
      : pixels(static_cast<std::size_t>(width * height)), frame(pixels, width, height) {}
  TextPicture(const TextPicture&) = delete;
  TextPicture& operator=(const TextPicture&) = delete;

  /// The rows; ' ' where nothing is, '#', 'o' and '.' for kInk, kOther and kThird, '?' for others.
  [[nodiscard]] std::vector<std::string> rows() const {
    std::vector<std::string> found;
    for (std::int32_t y = 0; y < frame.bounds().bottom; ++y) {
      std::string row;
      for (std::int32_t x = 0; x < frame.bounds().right; ++x) {
        const Rgb8 c = frame.pixel(x, y);
        row += c == Rgb8{} ? ' ' : c == kInk ? '#' : c == kOther ? 'o' : c == kThird ? '.' : '?';
      }
      found.push_back(row);
    }
    return found;
  }

  static constexpr Rgb8 kInk{255, 255, 255};
  static constexpr Rgb8 kOther{255, 0, 0};
  static constexpr Rgb8 kThird{0, 0, 255};
};

using Rows = std::vector<std::string>;

}  // namespace arcspan::test
