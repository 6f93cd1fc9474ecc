// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/overlay/font.hpp>

#include <arcspan_tools/font/source_font.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// Code points first ... last.
struct CodeRange {
  std::uint32_t first = 0;
  std::uint32_t last = 0;

  friend constexpr bool operator==(const CodeRange&, const CodeRange&) = default;
};

/// `32-126,0xB0,U+2190-U+2193`: code points and ranges of them, in decimal or hexadecimal.
[[nodiscard]] std::optional<std::vector<CodeRange>> parse_ranges(const std::string& text);

/// Each pixel of a font becomes up x up pixels, or down x down of them one pixel; one of both is 1.
struct FontScale {
  std::int32_t up = 1;
  std::int32_t down = 1;
};

struct FontOptions {
  std::vector<CodeRange> ranges = {{0x20, 0x7E}};
  unsigned bits = 1;  ///< 1, or 4 with scale.down > 1
  FontScale scale;
};

/// The tables of an overlay::Font.
struct MadeFont {
  unsigned bits = 1;
  std::int32_t line_height = 0;
  std::vector<overlay::GlyphRange> ranges;
  std::vector<overlay::Glyph> glyphs;  ///< the placeholder is the first
  std::vector<std::uint8_t> bitmaps;
  std::string placeholder;              ///< where it comes from
  std::vector<std::uint32_t> left_out;  ///< code points that the options name and the file does not have
  std::vector<std::string> notices;     ///< of the file

  [[nodiscard]] std::size_t bytes() const {
    return ranges.size() * sizeof(overlay::GlyphRange) + glyphs.size() * sizeof(overlay::Glyph) +
           bitmaps.size();
  }
};

/// Makes a font for flash. A pixel that stands for several has their mean, as coverage in 16 levels with 4
/// bits, and is set from a half on with 1 bit; blocks of pixels begin at the pen and on the baseline. Throws
/// a Failure about `subject` if none of the characters exists, or if one is too large for a Glyph.
[[nodiscard]] MadeFont make_font(const SourceFont& source, const FontOptions& options,
                                 const std::string& subject);

/// The header with a font in namespace `name`; `origin` says in a comment what it was made from.
[[nodiscard]] std::string font_header(const MadeFont& font, const std::string& name,
                                      const std::string& origin);

}  // namespace arcspan::tools
