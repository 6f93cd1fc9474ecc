// SPDX-License-Identifier: MIT
#include <arcspan_tools/font/make_font.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/text.hpp>

#include <algorithm>
#include <map>

namespace arcspan::tools {
namespace {

constexpr std::int32_t kFull = 15;  // coverage of 4 bits

/// a / b, rounded down; b > 0.
std::int32_t floor_of(std::int32_t a, std::int32_t b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

/// A glyph of the size in which it is shown. Rows count from the top of the line.
struct ScaledGlyph {
  std::int32_t left = 0;
  std::int32_t top = 0;
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::int32_t advance = 0;
  std::vector<std::uint8_t> coverage;  ///< 0...kFull, row by row

  std::uint8_t& at(std::int32_t x, std::int32_t y) {
    return coverage[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(x)];
  }
  void resize(std::int32_t new_width, std::int32_t new_height) {
    width = new_width;
    height = new_height;
    coverage.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  }
};

/// The rows of a line above the baseline and below it.
struct LineRows {
  std::int32_t above = 0;
  std::int32_t below = 0;
};

LineRows scaled_rows(const SourceFont& source, const FontScale& scale) {
  const auto rows = [&](std::int32_t v) { return -floor_of(-v * scale.up, scale.down); };
  return {rows(source.ascent), rows(source.descent)};
}

/// Set pixels per pixel of the scaled glyph become coverage.
std::uint8_t coverage_of(std::int32_t set, std::int32_t all, unsigned bits) {
  if (bits == 1) return static_cast<std::uint8_t>(2 * set >= all && set > 0 ? kFull : 0);
  return static_cast<std::uint8_t>((2 * kFull * set + all) / (2 * all));
}

ScaledGlyph enlarged(const SourceGlyph& glyph, std::int32_t up) {
  ScaledGlyph made;
  made.left = glyph.left * up;
  made.top = glyph.top * up;
  made.resize(glyph.width * up, glyph.height * up);
  for (std::int32_t y = 0; y < made.height; ++y)
    for (std::int32_t x = 0; x < made.width; ++x)
      made.at(x, y) = static_cast<std::uint8_t>(glyph.at(x / up, y / up) ? kFull : 0);
  return made;
}

ScaledGlyph reduced(const SourceGlyph& glyph, std::int32_t down, unsigned bits) {
  ScaledGlyph made;
  made.left = floor_of(glyph.left, down);
  made.top = floor_of(glyph.top, down);
  made.resize(floor_of(glyph.left + glyph.width - 1, down) + 1 - made.left,
              floor_of(glyph.top + glyph.height - 1, down) + 1 - made.top);
  std::vector<std::int32_t> set(made.coverage.size());
  for (std::int32_t y = 0; y < glyph.height; ++y) {
    for (std::int32_t x = 0; x < glyph.width; ++x) {
      const std::int32_t column = floor_of(glyph.left + x, down) - made.left;
      const std::int32_t row = floor_of(glyph.top + y, down) - made.top;
      set[static_cast<std::size_t>(row) * static_cast<std::size_t>(made.width) +
          static_cast<std::size_t>(column)] += glyph.at(x, y) ? 1 : 0;
    }
  }
  std::transform(set.begin(), set.end(), made.coverage.begin(),
                 [=](std::int32_t count) { return coverage_of(count, down * down, bits); });
  return made;
}

/// The glyph without the rows and columns around its pixels.
ScaledGlyph cropped(ScaledGlyph glyph) {
  std::int32_t left = glyph.width, right = 0, top = glyph.height, bottom = 0;
  for (std::int32_t y = 0; y < glyph.height; ++y) {
    for (std::int32_t x = 0; x < glyph.width; ++x) {
      if (glyph.at(x, y) == 0) continue;
      left = std::min(left, x);
      right = std::max(right, x + 1);
      top = std::min(top, y);
      bottom = y + 1;
    }
  }
  ScaledGlyph made;
  made.advance = glyph.advance;
  if (right <= left) return made;
  made.left = glyph.left + left;
  made.top = glyph.top + top;
  made.resize(right - left, bottom - top);
  for (std::int32_t y = 0; y < made.height; ++y)
    for (std::int32_t x = 0; x < made.width; ++x) made.at(x, y) = glyph.at(left + x, top + y);
  return made;
}

ScaledGlyph scaled(const SourceGlyph& glyph, const FontOptions& options, std::int32_t rows_above) {
  const FontScale& scale = options.scale;
  ScaledGlyph made;
  if (glyph.width > 0 && glyph.height > 0)
    made = scale.down == 1 ? enlarged(glyph, scale.up) : reduced(glyph, scale.down, options.bits);
  made.top += rows_above;
  made.advance = floor_of(2 * glyph.advance * scale.up + scale.down, 2 * scale.down);
  return cropped(std::move(made));
}

/// The rows of a glyph without gaps, as overlay::Font has them.
std::vector<std::uint8_t> packed(const ScaledGlyph& glyph, unsigned bits) {
  std::vector<std::uint8_t> bytes((glyph.coverage.size() * bits + 7) / 8);
  for (std::size_t i = 0; i < glyph.coverage.size(); ++i) {
    const unsigned value = bits == 4 ? glyph.coverage[i] : glyph.coverage[i] != 0 ? 1u : 0u;
    const std::size_t at = i * bits;
    bytes[at / 8] = static_cast<std::uint8_t>(bytes[at / 8] | (value << (8 - bits - at % 8)));
  }
  return bytes;
}

/// A hollow box, nearly as wide as `advance` and three fourths as high as the line above its baseline.
ScaledGlyph hollow_box(std::int32_t advance, std::int32_t rows_above) {
  ScaledGlyph box;
  const std::int32_t height = std::max(3 * rows_above / 4, 3);
  box.advance = std::max(advance, 4);
  box.top = rows_above - height;
  box.resize(box.advance - 1, height);
  for (std::int32_t y = 0; y < box.height; ++y)
    for (std::int32_t x = 0; x < box.width; ++x)
      if (x == 0 || y == 0 || x == box.width - 1 || y == box.height - 1) box.at(x, y) = kFull;
  return box;
}

const SourceGlyph* find(const SourceFont& source, std::uint32_t code) {
  const auto at = std::lower_bound(source.glyphs.begin(), source.glyphs.end(), code,
                                   [](const SourceGlyph& glyph, std::uint32_t c) { return glyph.code < c; });
  return at != source.glyphs.end() && at->code == code ? &*at : nullptr;
}

/// The code points that the options name, each once.
std::vector<std::uint32_t> codes_of(const FontOptions& options) {
  std::vector<std::uint32_t> codes;
  for (const CodeRange& range : options.ranges)
    for (std::uint32_t code = range.first; code <= range.last; ++code) codes.push_back(code);
  std::sort(codes.begin(), codes.end());
  codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
  return codes;
}

/// Collects the tables of a font.
class FontMaker {
 public:
  FontMaker(const SourceFont& source, const FontOptions& options, const std::string& subject)
      : source_(source), options_(options), subject_(subject), rows_(scaled_rows(source, options.scale)) {
    made_.bits = options.bits;
    made_.line_height = std::max(rows_.above + rows_.below, 1);
    made_.notices = source.notices;
  }

  MadeFont font() {
    add_placeholder();
    for (const std::uint32_t code : codes_of(options_)) {
      const SourceGlyph* const glyph = find(source_, code);
      if (glyph == nullptr)
        made_.left_out.push_back(code);
      else
        add(code, scaled(*glyph, options_, rows_.above));
    }
    if (made_.ranges.empty()) throw Failure(subject_, "has none of the characters of --range");
    made_.bitmaps.resize(made_.bitmaps.size() + overlay::Font<1>::kPadding);
    return std::move(made_);
  }

 private:
  /// The font's own glyph for this, or that of U+FFFD, unless they show nothing; else a box.
  void add_placeholder() {
    for (const std::optional<std::uint32_t> code : {source_.default_code, std::optional(0xFFFDu)}) {
      const SourceGlyph* const glyph = code ? find(source_, *code) : nullptr;
      if (glyph == nullptr) continue;
      const ScaledGlyph made = scaled(*glyph, options_, rows_.above);
      if (made.width == 0) continue;
      made_.placeholder = formatted("U+%04X", static_cast<unsigned>(*code));
      made_.glyphs.push_back(stored(*code, made));
      return;
    }
    const SourceGlyph* const digit = find(source_, '0');
    const ScaledGlyph model = scaled(digit != nullptr ? *digit : source_.glyphs[0], options_, rows_.above);
    made_.placeholder = "a hollow box";
    made_.glyphs.push_back(stored(0, hollow_box(model.advance, rows_.above)));
  }

  void add(std::uint32_t code, const ScaledGlyph& glyph) {
    if (made_.glyphs.size() > 0xFFFF) throw Failure(subject_, "more than 65535 characters");
    const bool follows = !made_.ranges.empty() && !base_is_new_ &&
                         made_.ranges.back().first + made_.ranges.back().count == code &&
                         made_.ranges.back().count < 0xFFFF;
    overlay::Glyph placed = stored(code, glyph);
    if (!follows || base_is_new_) {
      made_.ranges.push_back({code, base_, 0, static_cast<std::uint16_t>(made_.glyphs.size())});
      base_is_new_ = false;
    }
    ++made_.ranges.back().count;
    made_.glyphs.push_back(placed);
  }

  /// The glyph with its bitmap in the table, unless it is there already.
  overlay::Glyph stored(std::uint32_t code, const ScaledGlyph& glyph) {
    if (glyph.width > 255 || glyph.height > 255 || glyph.advance < 0 || glyph.advance > 255 ||
        glyph.left < -128 || glyph.left > 127 || glyph.top < -32768 || glyph.top > 32767) {
      throw Failure(subject_, formatted("the glyph of U+%04X", static_cast<unsigned>(code)) +
                                  formatted(" has %dx%d pixels at column %d and moves the pen by %d; a font "
                                            "has up to 255x255 at -128...127 and moves by 0...255",
                                            glyph.width, glyph.height, glyph.left, glyph.advance));
    }
    overlay::Glyph made;
    made.bitmap = bitmap_of(packed(glyph, made_.bits));
    made.top = static_cast<std::int16_t>(glyph.top);
    made.left = static_cast<std::int8_t>(glyph.left);
    made.width = static_cast<std::uint8_t>(glyph.width);
    made.height = static_cast<std::uint8_t>(glyph.height);
    made.advance = static_cast<std::uint8_t>(glyph.advance);
    return made;
  }

  /// Where the bytes are, counted from base_. A new base begins where 16 bits do not reach.
  std::uint16_t bitmap_of(const std::vector<std::uint8_t>& bytes) {
    if (bytes.empty()) return 0;
    const auto known = places_.find(bytes);
    if (known != places_.end() && known->second >= base_) {
      return static_cast<std::uint16_t>(known->second - base_);
    }
    const auto place = static_cast<std::uint32_t>(made_.bitmaps.size());
    if (place - base_ > 0xFFFF) {
      base_ = place;
      base_is_new_ = true;
    }
    places_[bytes] = place;
    made_.bitmaps.insert(made_.bitmaps.end(), bytes.begin(), bytes.end());
    return static_cast<std::uint16_t>(place - base_);
  }

  const SourceFont& source_;
  const FontOptions& options_;
  const std::string& subject_;
  LineRows rows_;
  MadeFont made_;
  std::map<std::vector<std::uint8_t>, std::uint32_t> places_;  ///< of bitmaps
  std::uint32_t base_ = 0;
  bool base_is_new_ = false;  ///< no range counts from base_ yet
};

/// `65`, `0x41` or `U+0041`.
std::optional<std::uint32_t> parse_code(std::string_view text) {
  int base = 10;
  for (const std::string_view prefix : {"0x", "0X", "U+", "u+"}) {
    if (!text.starts_with(prefix)) continue;
    base = 16;
    text.remove_prefix(2);
    break;
  }
  if (text.empty() || text.size() > 8) return std::nullopt;
  std::uint32_t code = 0;
  for (const char c : text) {
    const int digit = c >= '0' && c <= '9'   ? c - '0'
                      : c >= 'a' && c <= 'f' ? c - 'a' + 10
                      : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                             : 99;
    if (digit >= base) return std::nullopt;
    code = code * static_cast<std::uint32_t>(base) + static_cast<std::uint32_t>(digit);
    if (code > 0x10FFFF) return std::nullopt;
  }
  return code;
}

}  // namespace

std::optional<std::vector<CodeRange>> parse_ranges(const std::string& text) {
  std::vector<CodeRange> ranges;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    const std::string_view part = std::string_view(text).substr(at, comma - at);
    const std::size_t dash = part.find('-');
    const auto first = parse_code(part.substr(0, dash));
    const auto last = dash == std::string_view::npos ? first : parse_code(part.substr(dash + 1));
    if (!first || !last || *first > *last) return std::nullopt;
    ranges.push_back({*first, *last});
    at = comma + 1;
  }
  return ranges;
}

MadeFont make_font(const SourceFont& source, const FontOptions& options, const std::string& subject) {
  return FontMaker(source, options, subject).font();
}

}  // namespace arcspan::tools
