// SPDX-License-Identifier: MIT
// Glyph Bitmap Distribution Format 2.1 and 2.2 (Adobe Technical Note 5005).
#include <arcspan_tools/font/font_lines.hpp>
#include <arcspan_tools/font/source_font.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/parse.hpp>

#include <map>
#include <optional>

namespace arcspan::tools {
namespace {

/// What follows the keyword of a line. A string loses its quotes.
std::string unquoted(std::string_view value) {
  if (value.size() < 2 || value.front() != '"') return std::string(value);
  const std::size_t last = value.rfind('"');
  return std::string(value.substr(1, last == 0 ? std::string_view::npos : last - 1));
}

/// Reads a BDF file line by line.
class BdfReader {
 public:
  BdfReader(std::string_view text, const std::string& subject) : lines_(text, subject) {}

  SourceFont font() {
    while (next()) {
      if (keyword_ == "STARTPROPERTIES") read_properties();
      if (keyword_ == "FONTBOUNDINGBOX") box_ = read_box();
      if (keyword_ == "DWIDTH") dwidth_ = read_step();
      if (keyword_ == "STARTCHAR") read_character();
      if (keyword_ == "ENDFONT") break;
    }
    if (keyword_ != "ENDFONT") lines_.fail("the file ends without ENDFONT");
    place_lines();
    check_charset(text("CHARSET_REGISTRY"), text("CHARSET_ENCODING"), lines_.subject());
    for (const char* name : {"COPYRIGHT", "NOTICE"})
      if (!text(name).empty()) font_.notices.push_back(text(name));
    if (const auto code = parse_integer(text("DEFAULT_CHAR")); code && *code >= 0 && *code <= 0x10FFFF)
      font_.default_code = static_cast<std::uint32_t>(*code);
    return std::move(font_);
  }

 private:
  struct Box {
    std::int32_t width = 0;
    std::int32_t height = 0;
    std::int32_t left = 0;
    std::int32_t bottom = 0;
  };

  /// Reads a line and splits off its keyword. Returns false at the end of the file.
  bool next() {
    std::string_view line;
    if (!lines_.next(line)) return false;
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    keyword_ = line.substr(0, end);
    value_ = line.substr(end);
    value_.remove_prefix(std::min(value_.find_first_not_of(" \t"), value_.size()));
    value_ = value_.substr(0, value_.find_last_not_of(" \t") + 1);
    return true;
  }

  /// The integer of this number in the line; whole numbers may have a fraction of zeros.
  [[nodiscard]] std::int32_t integer(int number) const {
    std::string_view rest = value_;
    for (int i = 0; i < number; ++i) {
      rest.remove_prefix(std::min(rest.find_first_of(" \t"), rest.size()));
      rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
    }
    const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
    const std::optional<std::int64_t> value = parse_integer(word);
    if (!value || *value < -kMostInteger || *value > kMostInteger) {
      lines_.fail(std::string(keyword_) + " needs an integer as its value " + std::to_string(number + 1) +
                  ", not '" + std::string(word) + "'");
    }
    return static_cast<std::int32_t>(*value);
  }

  [[nodiscard]] Box read_box() const {
    const Box box{integer(0), integer(1), integer(2), integer(3)};
    if (box.width < 0 || box.height < 0 || box.width >= kMostGlyphSide || box.height >= kMostGlyphSide)
      lines_.fail("a box of " + std::to_string(box.width) + "x" + std::to_string(box.height) + " pixels");
    for (const std::int32_t side : {box.left, box.bottom})
      if (side <= -kMostGlyphSide || side >= kMostGlyphSide) lines_.fail("a box at " + std::to_string(side));
    return box;
  }

  /// The step of the pen.
  [[nodiscard]] std::int32_t read_step() const {
    const std::int32_t step = integer(0);
    if (step <= -kMostGlyphSide || step >= kMostGlyphSide)
      lines_.fail("a step of the pen of " + std::to_string(step) + " pixels");
    return step;
  }

  void read_properties() {
    while (next() && keyword_ != "ENDPROPERTIES") properties_[std::string(keyword_)] = unquoted(value_);
    if (keyword_ != "ENDPROPERTIES") lines_.fail("the file ends within its properties");
  }

  void read_character() {
    SourceGlyph glyph;
    Box box = box_;
    std::optional<std::int32_t> code;
    std::optional<std::int32_t> advance = dwidth_;
    bool has_bitmap = false;
    const std::string name(value_);
    while (next() && keyword_ != "ENDCHAR") {
      if (keyword_ == "ENCODING") code = integer(0);
      if (keyword_ == "DWIDTH") advance = read_step();
      if (keyword_ == "BBX") box = read_box();
      if (keyword_ == "STARTCHAR" || keyword_ == "ENDFONT") break;
      if (keyword_ != "BITMAP") continue;
      has_bitmap = true;
      glyph.width = box.width;
      glyph.height = box.height;
      read_bitmap(glyph);
    }
    if (keyword_ != "ENDCHAR") lines_.fail("character '" + name + "' has no ENDCHAR");
    if (!code) lines_.fail("character '" + name + "' has no ENCODING");
    if (!has_bitmap) lines_.fail("character '" + name + "' has no BITMAP");
    if (!advance) lines_.fail("character '" + name + "' has no DWIDTH");
    if (*code < 0 || *code > 0x10FFFF) return;  // a glyph without a character
    glyph.code = static_cast<std::uint32_t>(*code);
    glyph.left = box.left;
    glyph.top = -(box.bottom + box.height);
    glyph.advance = *advance;
    font_.glyphs.push_back(std::move(glyph));
  }

  void read_bitmap(SourceGlyph& glyph) {
    for (std::int32_t row = 0; row < glyph.height; ++row) {
      if (!next() || keyword_ == "ENDCHAR")
        lines_.fail("the bitmap has " + std::to_string(row) + " rows of " + std::to_string(glyph.height));
      append_hex_row(keyword_, glyph.width, glyph.pixels, lines_);
    }
  }

  /// The height of lines: by properties, or the font's bounding box.
  void place_lines() {
    const auto ascent = parse_integer(text("FONT_ASCENT"));
    const auto descent = parse_integer(text("FONT_DESCENT"));
    const auto sane = [](const std::optional<std::int64_t>& rows) {
      return rows && *rows > -kMostGlyphSide && *rows < kMostGlyphSide;
    };
    font_.ascent = sane(ascent) ? static_cast<std::int32_t>(*ascent) : box_.height + box_.bottom;
    font_.descent = sane(descent) ? static_cast<std::int32_t>(*descent) : -box_.bottom;
    if (font_.ascent + font_.descent < 1) lines_.fail("the font's lines have no height");
  }

  [[nodiscard]] std::string text(const std::string& property) const {
    const auto found = properties_.find(property);
    return found == properties_.end() ? "" : found->second;
  }

  static constexpr std::int64_t kMostInteger = 0x7FFFFFFF;

  FontLines lines_;
  std::string_view keyword_;
  std::string_view value_;
  SourceFont font_;
  std::map<std::string, std::string> properties_;
  Box box_;
  std::optional<std::int32_t> dwidth_;
};

}  // namespace

SourceFont decode_bdf(std::string_view text, const std::string& subject) {
  return BdfReader(text, subject).font();
}

}  // namespace arcspan::tools
