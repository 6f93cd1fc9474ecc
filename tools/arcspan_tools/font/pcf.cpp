// SPDX-License-Identifier: MIT
// Portable Compiled Format of the X Window System, as libXfont writes it (X.Org, src/bitmap/pcfwrite.c and
// include/X11/fonts/pcf.h).
#include <arcspan_tools/font/source_font.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <array>
#include <cstdint>

namespace arcspan::tools {
namespace {

enum PcfTable : std::uint32_t {
  kProperties = 1,
  kAccelerators = 2,
  kMetrics = 4,
  kBitmaps = 8,
  kEncodings = 32,
  kBdfAccelerators = 256,
};

/// The bits of a table's format.
constexpr std::uint32_t kPadMask = 3;         // rows are padded to 1 << n bytes
constexpr std::uint32_t kBytesMsbFirst = 4;   // numbers have their high byte first
constexpr std::uint32_t kBitsMsbFirst = 8;    // the left pixel is the highest bit
constexpr unsigned kScanShift = 4;            // bytes are exchanged in units of 1 << n bytes
constexpr std::uint32_t kCompressed = 0x100;  // metrics of one byte each

/// Reads numbers of a table.
class PcfCursor {
 public:
  PcfCursor(std::string_view bytes, std::size_t at, const std::string& subject)
      : bytes_(bytes), at_(at), subject_(&subject) {}

  void set_format(std::uint32_t format) { format_ = format; }
  [[nodiscard]] std::uint32_t format() const { return format_; }
  [[nodiscard]] std::size_t at() const { return at_; }
  [[nodiscard]] std::string_view bytes() const { return bytes_; }

  [[noreturn]] void fail(const std::string& what) const {
    throw Failure(*subject_, "offset " + std::to_string(at_) + ": " + what);
  }
  void skip(std::size_t count) {
    need(count);
    at_ += count;
  }
  void need(std::size_t count) const {
    if (count > bytes_.size() || at_ > bytes_.size() - count) fail("the file is cut off");
  }

  std::uint32_t number(std::size_t size) {
    need(size);
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t place = (format_ & kBytesMsbFirst) != 0 ? size - 1 - i : i;
      value |= std::uint32_t{static_cast<unsigned char>(bytes_[at_ + i])} << (8 * place);
    }
    at_ += size;
    return value;
  }
  std::uint32_t u32() { return number(4); }
  std::uint32_t u16() { return number(2); }
  std::int32_t i32() { return static_cast<std::int32_t>(number(4)); }
  std::int32_t i16() { return static_cast<std::int16_t>(number(2)); }
  std::int32_t compressed() { return static_cast<std::int32_t>(number(1)) - 0x80; }

 private:
  std::string_view bytes_;
  std::size_t at_;
  const std::string* subject_;
  std::uint32_t format_ = 0;
};

struct PcfMetrics {
  std::int32_t left = 0;
  std::int32_t right = 0;
  std::int32_t advance = 0;
  std::int32_t ascent = 0;
  std::int32_t descent = 0;
};

class PcfReader {
 public:
  PcfReader(std::string_view bytes, const std::string& subject) : bytes_(bytes), subject_(subject) {}

  SourceFont font() {
    read_properties();
    read_accelerators();
    read_metrics();
    read_encodings();
    return std::move(font_);
  }

 private:
  /// The place of a table behind its format, or nothing if it does not exist.
  std::optional<PcfCursor> find(PcfTable type) {
    PcfCursor cursor(bytes_, 4, subject_);
    const std::uint32_t tables = cursor.u32();
    for (std::uint32_t i = 0; i < tables; ++i) {
      if (cursor.u32() != type) {
        cursor.skip(12);
        continue;
      }
      cursor.skip(8);
      PcfCursor table(bytes_, cursor.u32(), subject_);
      table.set_format(table.u32());
      return table;
    }
    return std::nullopt;
  }

  PcfCursor need(PcfTable type, const char* name) {
    const std::optional<PcfCursor> table = find(type);
    if (!table) throw Failure(subject_, std::string("has no table of ") + name);
    return *table;
  }

  void read_properties() {
    std::optional<PcfCursor> table = find(kProperties);
    if (!table) return;
    const std::uint32_t count = table->u32();
    PcfCursor entries = *table;
    constexpr std::size_t kEntryBytes = 9;
    if (count > bytes_.size() / kEntryBytes) table->fail("more properties than the file has bytes");
    table->skip(count * kEntryBytes + (4 - count % 4) % 4);
    const std::uint32_t size = table->u32();
    table->need(size);
    const std::string_view strings = bytes_.substr(table->at(), size);
    const auto text_at = [&](std::uint32_t at) {
      if (at >= strings.size()) entries.fail("a property's text lies outside of its table");
      return std::string(strings.substr(at, strings.find('\0', at) - at));
    };
    std::string registry;
    std::string encoding;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::string name = text_at(entries.u32());
      const bool is_text = entries.number(1) != 0;
      const std::uint32_t value = entries.u32();
      if (!is_text) continue;
      if (name == "CHARSET_REGISTRY") registry = text_at(value);
      if (name == "CHARSET_ENCODING") encoding = text_at(value);
      if (name == "COPYRIGHT" || name == "NOTICE") font_.notices.push_back(text_at(value));
    }
    check_charset(registry, encoding, subject_);
  }

  void read_accelerators() {
    std::optional<PcfCursor> table = find(kBdfAccelerators);
    if (!table) table = need(kAccelerators, "accelerators");
    table->skip(8);
    font_.ascent = table->i32();
    font_.descent = table->i32();
    for (const std::int32_t rows : {font_.ascent, font_.descent})
      if (rows <= -kMostGlyphSide || rows >= kMostGlyphSide)
        table->fail("lines with " + std::to_string(rows) + " rows on one side of the baseline");
    if (font_.ascent + font_.descent < 1) table->fail("the font's lines have no height");
  }

  void read_metrics() {
    PcfCursor table = need(kMetrics, "metrics");
    const bool compressed = (table.format() & kCompressed) != 0;
    const std::uint32_t count = compressed ? table.u16() : table.u32();
    if (count > bytes_.size() / (compressed ? 5 : 12)) table.fail("more metrics than the file has bytes");
    const auto next = [&] { return compressed ? table.compressed() : table.i16(); };
    metrics_.resize(count);
    for (PcfMetrics& m : metrics_) {
      m.left = next();
      m.right = next();
      m.advance = next();
      m.ascent = next();
      m.descent = next();
      if (!compressed) table.skip(2);  // attributes
      const std::int32_t width = m.right - m.left;
      const std::int32_t height = m.ascent + m.descent;
      if (width < 0 || height < 0 || width >= kMostGlyphSide || height >= kMostGlyphSide)
        table.fail("a glyph of " + std::to_string(width) + "x" + std::to_string(height) + " pixels");
    }
  }

  void read_encodings() {
    PcfCursor table = need(kEncodings, "encodings");
    const std::uint32_t first_low = table.u16();
    const std::uint32_t last_low = table.u16();
    const std::uint32_t first_high = table.u16();
    const std::uint32_t last_high = table.u16();
    const std::uint32_t default_code = table.u16();
    if (first_low > last_low || first_high > last_high || last_low > 255 || last_high > 255)
      table.fail("wrong ranges of characters");
    constexpr std::uint32_t kNoGlyph = 0xFFFF;
    const PcfCursor bitmaps = need(kBitmaps, "bitmaps");
    for (std::uint32_t high = first_high; high <= last_high; ++high) {
      for (std::uint32_t low = first_low; low <= last_low; ++low) {
        const std::uint32_t index = table.u16();
        if (index == kNoGlyph) continue;
        if (index >= metrics_.size()) table.fail("character without metrics");
        add_glyph(256 * high + low, index, bitmaps);
      }
    }
    const auto is_default = [=](const SourceGlyph& glyph) { return glyph.code == default_code; };
    if (std::any_of(font_.glyphs.begin(), font_.glyphs.end(), is_default)) font_.default_code = default_code;
  }

  /// Adds the glyph of a code point; `table` is at the number of bitmaps.
  void add_glyph(std::uint32_t code, std::uint32_t index, PcfCursor table) {
    const PcfMetrics& m = metrics_[index];
    SourceGlyph glyph{code, m.left, -m.ascent, m.right - m.left, m.ascent + m.descent, m.advance, {}};
    const std::uint32_t count = table.u32();
    if (index >= count || count > bytes_.size() / 4) table.fail("character without a bitmap");
    PcfCursor offset = table;
    offset.skip(4 * index);
    const std::size_t from = offset.u32();
    table.skip(4 * count + 16);
    const std::size_t pad = std::size_t{1} << (table.format() & kPadMask);
    const std::size_t row_bytes = (static_cast<std::size_t>(glyph.width) + 8 * pad - 1) / (8 * pad) * pad;
    const std::size_t size = row_bytes * static_cast<std::size_t>(glyph.height);
    table.skip(from);
    table.need(size);
    pixels_ += size;
    constexpr std::size_t kMostBytes = std::size_t{64} << 20;  // glyphs may share bytes of a small file
    if (pixels_ > kMostBytes) table.fail("the bitmaps of all glyphs are too large");
    read_pixels(bytes_.substr(table.at(), size), row_bytes, table.format(), glyph);
    font_.glyphs.push_back(std::move(glyph));
  }

  static void read_pixels(std::string_view bitmap, std::size_t row_bytes, std::uint32_t format,
                          SourceGlyph& glyph) {
    const bool bits_msb = (format & kBitsMsbFirst) != 0;
    const bool bytes_msb = (format & kBytesMsbFirst) != 0;
    // Where bytes and bits are ordered differently, the bytes of a scan unit are exchanged.
    const std::size_t unit = bits_msb == bytes_msb ? 1 : std::size_t{1} << ((format >> kScanShift) & 3u);
    for (std::int32_t y = 0; y < glyph.height; ++y) {
      for (std::int32_t x = 0; x < glyph.width; ++x) {
        const auto column = static_cast<std::size_t>(x);
        const std::size_t at = static_cast<std::size_t>(y) * row_bytes + ((column / 8) ^ (unit - 1));
        const unsigned bit = bits_msb ? 7u - column % 8 : column % 8;
        const unsigned byte = at < bitmap.size() ? static_cast<unsigned char>(bitmap[at]) : 0u;
        glyph.pixels.push_back(((byte >> bit) & 1u) != 0);
      }
    }
  }

  std::string_view bytes_;
  const std::string& subject_;
  SourceFont font_;
  std::vector<PcfMetrics> metrics_;
  std::size_t pixels_ = 0;  ///< bytes of bitmaps so far
};

}  // namespace

SourceFont decode_pcf(std::string_view bytes, const std::string& subject) {
  return PcfReader(bytes, subject).font();
}

}  // namespace arcspan::tools
