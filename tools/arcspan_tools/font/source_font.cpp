// SPDX-License-Identifier: MIT
#include <arcspan_tools/font/gunzip.hpp>
#include <arcspan_tools/font/source_font.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>

#include <algorithm>
#include <cctype>

namespace arcspan::tools {
namespace {

constexpr std::size_t kMostFontBytes = std::size_t{64} << 20;

bool is_hex_digit(char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; }

/// Whether the first line that is not empty begins as one of Unifont does: 4 to 6 digits and a colon.
bool looks_like_hex(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of("\r\n"), text.size()));
  const std::size_t colon = text.find(':');
  return colon != std::string_view::npos && colon >= 4 && colon <= 6 &&
         std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(colon), is_hex_digit);
}

SourceFont decode_any(std::string_view bytes, const std::string& subject) {
  if (bytes.starts_with("\1fcp")) return decode_pcf(bytes, subject);
  if (bytes.starts_with("STARTFONT")) return decode_bdf(bytes, subject);
  if (looks_like_hex(bytes)) return decode_hex(bytes, subject);
  throw Failure(subject, "not a BDF, PCF or .hex font");
}

bool ascending(const SourceGlyph& a, const SourceGlyph& b) { return a.code < b.code; }

}  // namespace

SourceFont decode_font(std::string_view bytes, const std::string& subject) {
  std::string unpacked;
  if (is_gzip(bytes)) {
    unpacked = gunzip(bytes, kMostFontBytes, subject);
    bytes = unpacked;
  }
  SourceFont font = decode_any(bytes, subject);
  if (font.glyphs.empty()) throw Failure(subject, "has no characters");
  std::stable_sort(font.glyphs.begin(), font.glyphs.end(), ascending);
  const auto same = [](const SourceGlyph& a, const SourceGlyph& b) { return a.code == b.code; };
  const auto twice = std::adjacent_find(font.glyphs.begin(), font.glyphs.end(), same);
  if (twice != font.glyphs.end())
    throw Failure(subject, "has character " + std::to_string(twice->code) + " twice");
  return font;
}

SourceFont read_font(const std::filesystem::path& path) {
  return decode_font(read_whole_file(path, kMostFontBytes), path.string());
}

void check_charset(const std::string& registry, const std::string& encoding, const std::string& subject) {
  std::string name = registry + (encoding.empty() ? "" : "-" + encoding);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  for (const char* unicode : {"", "ISO10646-1", "ISO10646", "ISO8859-1", "ISO646.1991-IRV", "ASCII-0"})
    if (name == unicode) return;
  throw Failure(subject, "its characters are numbered by " + name +
                             ", not by Unicode; take the font's variant for ISO10646-1");
}

}  // namespace arcspan::tools
