// SPDX-License-Identifier: MIT
#include <arcspan_tools/font/make_font.hpp>
#include <arcspan_tools/output/array_text.hpp>
#include <arcspan_tools/support/text.hpp>

namespace arcspan::tools {
namespace {

std::string range_text(const overlay::GlyphRange& range) {
  return formatted("{0x%X, %u, %u, %u}", static_cast<unsigned>(range.first),
                   static_cast<unsigned>(range.bitmaps), static_cast<unsigned>(range.count),
                   static_cast<unsigned>(range.glyph));
}

std::string glyph_text(const overlay::Glyph& glyph) {
  return formatted("{%u, %d, %d, %u, %u, %u}", static_cast<unsigned>(glyph.bitmap), int{glyph.top},
                   int{glyph.left}, static_cast<unsigned>(glyph.width), static_cast<unsigned>(glyph.height),
                   static_cast<unsigned>(glyph.advance));
}

template <class T, class Text>
std::string array_of(const std::vector<T>& values, const Text& text, const std::string& type,
                     const char* name) {
  ArrayText elements;
  for (const T& value : values) elements.add(text(value));
  return elements.array(type, name);
}

}  // namespace

std::string font_header(const MadeFont& font, const std::string& name, const std::string& origin) {
  const std::string type = "arcspan::overlay::Font<" + std::to_string(font.bits) + ">";
  std::string text = "// Made by `arcspan font` from " + harmless(origin) + ".\n";
  for (const std::string& notice : font.notices) text += "// " + harmless(notice) + "\n";
  text += "//\n// " + std::to_string(font.glyphs.size() - 1) + " characters of " + std::to_string(font.bits) +
          (font.bits == 1 ? " bit" : " bits") + " per pixel, lines of " + std::to_string(font.line_height) +
          " rows, " + std::to_string(font.bytes()) + " bytes. Others are shown as " + font.placeholder +
          ".\n#pragma once\n\n#include <arcspan/overlay/font.hpp>\n\n#include <cstdint>\n\nnamespace " +
          name + " {\n\n";
  text += array_of(font.ranges, range_text, "arcspan::overlay::GlyphRange", "kRanges");
  text += array_of(font.glyphs, glyph_text, "arcspan::overlay::Glyph", "kGlyphs");
  text += array_of(
      font.bitmaps, [](std::uint8_t byte) { return std::to_string(byte); }, "std::uint8_t", "kBitmaps");
  return text + "inline constexpr " + type + " kFont = " + type + "::of(kRanges, kGlyphs, kBitmaps, " +
         std::to_string(font.line_height) + ");\n\n}  // namespace " + name + "\n";
}

}  // namespace arcspan::tools
