// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace arcspan::tools {

/// A character as a font file has it. The pen stands at column 0 on the baseline, which is the upper border
/// of row 0; rows count downwards.
struct SourceGlyph {
  std::uint32_t code = 0;  ///< code point
  std::int32_t left = 0;   ///< first column and row of its box
  std::int32_t top = 0;
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::int32_t advance = 0;
  std::vector<bool> pixels;  ///< width * height of them, row by row

  [[nodiscard]] bool at(std::int32_t x, std::int32_t y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// The characters of a font file.
struct SourceFont {
  std::int32_t ascent = 0;                    ///< rows of a line above the baseline
  std::int32_t descent = 0;                   ///< and below it
  std::optional<std::uint32_t> default_code;  ///< of the glyph for characters that the font does not have
  std::vector<std::string> notices;           ///< copyright and licence
  std::vector<SourceGlyph> glyphs;            ///< in ascending order of their code points, which differ
};

/// The sides of a glyph's box and its pen's steps are less than this.
inline constexpr std::int32_t kMostGlyphSide = 1024;

/// Reads a font file: BDF 2.1 or 2.2, PCF or GNU Unifont's .hex, each also compressed by gzip. Its content
/// says which one it is. Throws Failure with the line, or in a PCF file the offset, that is wrong.
[[nodiscard]] SourceFont read_font(const std::filesystem::path& path);

/// read_font() of bytes. `subject` names them in a Failure.
[[nodiscard]] SourceFont decode_font(std::string_view bytes, const std::string& subject);

[[nodiscard]] SourceFont decode_bdf(std::string_view text, const std::string& subject);
[[nodiscard]] SourceFont decode_pcf(std::string_view bytes, const std::string& subject);
[[nodiscard]] SourceFont decode_hex(std::string_view text, const std::string& subject);

/// Throws a Failure unless the characters of a font are numbered by Unicode: ISO10646-1, and what begins like
/// it. A font that does not say is taken for one.
void check_charset(const std::string& registry, const std::string& encoding, const std::string& subject);

}  // namespace arcspan::tools
