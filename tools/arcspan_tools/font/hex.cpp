// SPDX-License-Identifier: MIT
// GNU Unifont's .hex: a line per character, CODE:DIGITS, with a bitmap of 16 rows.
#include <arcspan_tools/font/font_lines.hpp>
#include <arcspan_tools/font/source_font.hpp>

#include <charconv>

namespace arcspan::tools {
namespace {

constexpr std::size_t kRows = 16;
constexpr std::int32_t kAscent = 14;  // rows above the baseline

std::uint32_t code_of(std::string_view digits, const FontLines& lines) {
  std::uint32_t code = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, code, 16);
  if (digits.empty() || stop != end || error != std::errc{} || code > 0x10FFFF)
    lines.fail("'" + std::string(digits) + "' is not a code point");
  return code;
}

}  // namespace

SourceFont decode_hex(std::string_view text, const std::string& subject) {
  SourceFont font;
  font.ascent = kAscent;
  font.descent = static_cast<std::int32_t>(kRows) - kAscent;
  font.default_code = 0xFFFD;
  FontLines lines(text, subject);
  for (std::string_view line; lines.next(line);) {
    if (line.empty()) continue;
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) lines.fail("no colon behind the code point");
    const std::string_view digits = line.substr(colon + 1);
    const std::size_t per_row = digits.size() / kRows;
    if (digits.size() % kRows != 0 || per_row % 2 != 0 || per_row < 2 || per_row > 8) {
      lines.fail(std::to_string(digits.size()) +
                 " digits, where 16 rows of 8, 16, 24 or 32 pixels have 32, 64, 96 or 128");
    }
    SourceGlyph glyph;
    glyph.code = code_of(line.substr(0, colon), lines);
    glyph.top = -kAscent;
    glyph.width = glyph.advance = static_cast<std::int32_t>(4 * per_row);
    glyph.height = static_cast<std::int32_t>(kRows);
    for (std::size_t row = 0; row < kRows; ++row)
      append_hex_row(digits.substr(row * per_row, per_row), glyph.width, glyph.pixels, lines);
    font.glyphs.push_back(std::move(glyph));
  }
  return font;
}

}  // namespace arcspan::tools
