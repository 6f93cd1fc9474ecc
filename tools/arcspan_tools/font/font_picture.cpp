// SPDX-License-Identifier: MIT
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/overlay/text.hpp>
#include <arcspan/pixel/rgb888.hpp>

#include <arcspan_tools/font/font_picture.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <cstdlib>

namespace arcspan::tools {
namespace {

constexpr std::size_t kLeastPerRow = 16;
constexpr std::int32_t kGap = 4;

/// A code point in UTF-8.
std::string utf8(std::uint32_t code) {
  const auto continued = [code](unsigned shift) {
    return static_cast<char>(0x80u | ((code >> shift) & 0x3Fu));
  };
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) return {static_cast<char>(0xC0u | (code >> 6)), continued(0)};
  if (code < 0x10000) return {static_cast<char>(0xE0u | (code >> 12)), continued(6), continued(0)};
  return {static_cast<char>(0xF0u | (code >> 18)), continued(12), continued(6), continued(0)};
}

/// One string per row of the sheet, in front of U+10FFFF, which is no character and has no glyph.
std::vector<std::string> cells_of(const MadeFont& font) {
  std::vector<std::string> cells;
  for (const overlay::GlyphRange& range : font.ranges)
    for (std::uint32_t i = 0; i < range.count; ++i) cells.push_back(utf8(range.first + i));
  cells.push_back(utf8(0x10FFFF));
  return cells;
}

template <unsigned Bits>
Image drawn(const MadeFont& made) {
  overlay::Font<Bits> font;
  if (!ok(overlay::Font<Bits>::make(made.ranges, made.glyphs, made.bitmaps, made.line_height, font)))
    std::abort();
  std::int32_t cell = kGap;
  for (const overlay::Glyph& glyph : made.glyphs)
    cell = std::max({cell, kGap + glyph.advance, kGap + glyph.left + glyph.width});
  const std::int32_t row = kGap + font.bottom() - font.top();
  const std::vector<std::string> cells = cells_of(made);
  std::size_t per_row = kLeastPerRow;
  while (per_row * per_row < cells.size()) ++per_row;
  Image sheet(kGap + cell * static_cast<std::int32_t>(per_row),
              kGap + row * static_cast<std::int32_t>((cells.size() + per_row - 1) / per_row));
  hal::Framebuffer<Rgb888> frame(sheet.pixels, sheet.width, sheet.height);
  if (!ok(frame.status())) throw Failure("--report", "the font is too large for a picture");
  frame.clear({24, 28, 36});
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const overlay::Point at{kGap + cell * static_cast<std::int32_t>(i % per_row),
                            kGap - font.top() + row * static_cast<std::int32_t>(i / per_row)};
    if (!ok(overlay::draw_text(frame, font, at, cells[i], Rgb8{255, 255, 255}))) std::abort();
  }
  return sheet;
}

}  // namespace

Image font_picture(const MadeFont& font) { return font.bits == 4 ? drawn<4>(font) : drawn<1>(font); }

}  // namespace arcspan::tools
