// SPDX-License-Identifier: MIT
// The readers of font files, and how fonts for flash are made of what they read.
#include <arcspan/mesh/crc32.hpp>

#include <arcspan_tools/font/font_picture.hpp>
#include <arcspan_tools/font/gunzip.hpp>
#include <arcspan_tools/font/make_font.hpp>
#include <arcspan_tools/font/source_font.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <string>
#include <vector>

using namespace arcspan;
using namespace arcspan::tools;
using arcspan::test::message_of;

namespace {

/// Two letters: a b with a stem above the baseline, and a comma below it.
const std::string kBdf =
    "STARTFONT 2.1\n"
    "COMMENT a comment\n"
    "FONT -x-y\n"
    "SIZE 8 75 75\n"
    "FONTBOUNDINGBOX 5 8 0 -2\n"
    "STARTPROPERTIES 5\n"
    "FONT_ASCENT 6\n"
    "FONT_DESCENT 2\n"
    "DEFAULT_CHAR 44\n"
    "CHARSET_REGISTRY \"ISO10646\"\n"
    "COPYRIGHT \"by \"\"us\"\"\"\n"
    "ENDPROPERTIES\n"
    "CHARS 3\n"
    "STARTCHAR b\n"
    "ENCODING 98\n"
    "SWIDTH 500 0\n"
    "DWIDTH 5 0\n"
    "BBX 3 4 1 0\n"
    "BITMAP\n"
    "80\n"
    "C0\n"
    "A0\n"
    "e0ff\n"
    "ENDCHAR\n"
    "STARTCHAR comma\n"
    "ENCODING 44\n"
    "DWIDTH 2 0\n"
    "BBX 1 3 -1 -2\n"
    "BITMAP\n"
    "80\n80\n00\n"
    "ENDCHAR\n"
    "STARTCHAR extra\n"
    "ENCODING -1 7\n"
    "DWIDTH 2 0\n"
    "BBX 0 0 0 0\n"
    "BITMAP\n"
    "ENDCHAR\n"
    "ENDFONT\n";

std::string rows_of(const SourceGlyph& glyph) {
  std::string rows;
  for (std::int32_t y = 0; y < glyph.height; ++y) {
    for (std::int32_t x = 0; x < glyph.width; ++x) rows += glyph.at(x, y) ? '#' : '.';
    rows += '\n';
  }
  return rows;
}

/// `text` with `from`, which it has, replaced.
std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string bdf_error(const std::string& text) {
  return message_of<Failure>([&] { (void)decode_font(text, "f"); });
}

/// How a PCF file stores things.
struct PcfLayout {
  bool bytes_msb = true;
  bool bits_msb = true;
  unsigned pad = 0;   ///< log2 of the bytes that rows are padded to
  unsigned unit = 0;  ///< log2 of the bytes of a scan unit
  bool compressed = true;
};

/// Writes a PCF file.
class PcfWriter {
 public:
  PcfWriter(const SourceFont& font, const PcfLayout& layout) : font_(font), layout_(layout) {}

  std::string bytes() {
    tables_ = {{1, properties()}, {2, accelerators()}, {4, metrics()}, {8, bitmaps()}, {32, encodings()}};
    std::string out = "\1fcp";
    append(out, 5, 4, false);
    std::size_t at = 8 + 16 * tables_.size();
    for (const auto& [type, table] : tables_) {
      append(out, type, 4, false);
      append(out, format_of(type), 4, false);
      append(out, table.size(), 4, false);
      append(out, at, 4, false);
      at += table.size();
    }
    for (const auto& [type, table] : tables_) out += table;
    return out;
  }

 private:
  static void append(std::string& out, std::uint64_t value, unsigned size, bool msb) {
    for (unsigned i = 0; i < size; ++i) out += static_cast<char>(value >> 8 * (msb ? size - 1 - i : i));
  }
  void add(std::string& out, std::int64_t value, unsigned size) const {
    append(out, static_cast<std::uint64_t>(value), size, layout_.bytes_msb);
  }
  [[nodiscard]] std::uint32_t format_of(std::uint32_t type) const {
    return layout_.pad | (layout_.bytes_msb ? 4u : 0u) | (layout_.bits_msb ? 8u : 0u) | layout_.unit << 4 |
           (type == 4 && layout_.compressed ? 0x100u : 0u);
  }
  [[nodiscard]] std::string begun(std::uint32_t type) const {
    std::string out;
    append(out, format_of(type), 4, false);
    return out;
  }
  [[nodiscard]] std::string properties() const {
    std::string out = begun(1);
    const std::string strings("CHARSET_REGISTRY\0ISO10646\0COPYRIGHT\0us\0SIZE", 43);
    add(out, 3, 4);
    for (const auto& [name, text, value] : {std::tuple{0, 1, 17}, {26, 1, 36}, {39, 0, 7}}) {
      add(out, name, 4);
      add(out, text, 1);
      add(out, value, 4);
    }
    out += '\0';  // padding
    add(out, static_cast<std::int64_t>(strings.size() + 1), 4);
    return out + strings + '\0';
  }
  [[nodiscard]] std::string accelerators() const {
    std::string out = begun(2) + std::string(8, '\0');
    add(out, font_.ascent, 4);
    add(out, font_.descent, 4);
    return out;
  }
  [[nodiscard]] std::string metrics() const {
    std::string out = begun(4);
    add(out, static_cast<std::int64_t>(font_.glyphs.size()), layout_.compressed ? 2 : 4);
    for (const SourceGlyph& g : font_.glyphs) {
      for (const std::int32_t v : {g.left, g.left + g.width, g.advance, -g.top, g.top + g.height})
        layout_.compressed ? add(out, v + 0x80, 1) : add(out, v, 2);
      if (!layout_.compressed) add(out, 0, 2);
    }
    return out;
  }
  [[nodiscard]] std::string bitmaps() const {
    std::string out = begun(8);
    std::string data;
    add(out, static_cast<std::int64_t>(font_.glyphs.size()), 4);
    for (const SourceGlyph& g : font_.glyphs) {
      add(out, static_cast<std::int64_t>(data.size()), 4);
      data += bitmap(g);
    }
    for (int i = 0; i < 4; ++i) add(out, static_cast<std::int64_t>(data.size()), 4);
    return out + data;
  }
  [[nodiscard]] std::string bitmap(const SourceGlyph& g) const {
    const std::size_t pad = std::size_t{1} << layout_.pad;
    const std::size_t row = (static_cast<std::size_t>(g.width) + 8 * pad - 1) / (8 * pad) * pad;
    const std::size_t unit = layout_.bytes_msb == layout_.bits_msb ? 1 : std::size_t{1} << layout_.unit;
    std::string out(row * static_cast<std::size_t>(g.height), '\0');
    for (std::int32_t y = 0; y < g.height; ++y) {
      for (std::int32_t x = 0; x < g.width; ++x) {
        const auto column = static_cast<std::size_t>(x);
        char& byte = out[static_cast<std::size_t>(y) * row + ((column / 8) ^ (unit - 1))];
        if (g.at(x, y)) byte = static_cast<char>(byte | 1 << (layout_.bits_msb ? 7 - x % 8 : x % 8));
      }
    }
    return out;
  }
  [[nodiscard]] std::string encodings() const {
    std::string out = begun(32);
    for (const int v : {40, 99, 0, 0, 44}) add(out, v, 2);
    for (std::uint32_t code = 40; code < 100; ++code) {
      std::int64_t index = 0xFFFF;
      for (std::size_t i = 0; i < font_.glyphs.size(); ++i)
        if (font_.glyphs[i].code == code) index = static_cast<std::int64_t>(i);
      add(out, index, 2);
    }
    return out;
  }

  const SourceFont& font_;
  PcfLayout layout_;
  std::vector<std::pair<std::uint32_t, std::string>> tables_;
};

bool same(const SourceFont& a, const SourceFont& b) {
  if (a.ascent != b.ascent || a.descent != b.descent || a.glyphs.size() != b.glyphs.size()) return false;
  for (std::size_t i = 0; i < a.glyphs.size(); ++i) {
    const SourceGlyph& x = a.glyphs[i];
    const SourceGlyph& y = b.glyphs[i];
    if (x.code != y.code || x.left != y.left || x.top != y.top || x.advance != y.advance) return false;
    if (rows_of(x) != rows_of(y)) return false;
  }
  return true;
}

/// A gzip file whose content is stored without compression.
std::string gzipped(const std::string& content, const std::string& flags_and_more = std::string(7, '\0')) {
  const auto number = [](std::size_t value, int bytes) {
    std::string out;
    for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> 8 * i);
    return out;
  };
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(content.data());
  return "\x1F\x8B\x08" + flags_and_more + "\1" + number(content.size(), 2) + number(~content.size(), 2) +
         content + number(crc32({bytes, content.size()}), 4) + number(content.size(), 4);
}

/// A glyph of a made font as text: its coverage in hexadecimal digits.
std::string made_rows(const MadeFont& font, std::size_t index) {
  const overlay::Glyph& glyph = font.glyphs[index];
  std::string rows;
  for (unsigned i = 0; i < unsigned{glyph.width} * glyph.height; ++i) {
    const unsigned bit = i * font.bits;
    const unsigned byte = font.bitmaps[glyph.bitmap + bit / 8];
    rows += "0123456789abcdef"[byte >> (8 - font.bits - bit % 8) & ((1u << font.bits) - 1)];
    if ((i + 1) % glyph.width == 0) rows += '\n';
  }
  return rows;
}

FontOptions options(unsigned bits, FontScale scale = {},
                    std::vector<CodeRange> ranges = {{44, 44}, {98, 98}}) {
  FontOptions made;
  made.bits = bits;
  made.scale = scale;
  made.ranges = std::move(ranges);
  return made;
}

}  // namespace

TEST_CASE("BDF: glyphs, their places, the line and the notices are read") {
  for (const bool dos : {false, true}) {
    std::string text = kBdf;
    for (std::size_t at = 0; dos && (at = text.find('\n', at)) != std::string::npos; at += 2)
      text.insert(at, "\r");
    const SourceFont font = decode_font(text, "f");
    CHECK(font.ascent == 6);
    CHECK(font.descent == 2);
    CHECK(font.default_code == 44u);
    CHECK(font.notices == std::vector<std::string>{"by \"\"us\"\""});
    REQUIRE(font.glyphs.size() == 2);
    const SourceGlyph& comma = font.glyphs[0];
    CHECK(comma.code == 44);
    CHECK(comma.left == -1);
    CHECK(comma.top == -1);
    CHECK(comma.advance == 2);
    CHECK(rows_of(comma) == "#\n#\n.\n");
    CHECK(font.glyphs[1].top == -4);
    CHECK(font.glyphs[1].left == 1);
    CHECK(rows_of(font.glyphs[1]) == "#..\n##.\n#.#\n###\n");
  }
  const SourceFont plain = decode_font(replaced(kBdf, "FONT_ASCENT 6\nFONT_DESCENT 2\n", ""), "f");
  CHECK(plain.ascent == 6);  // of the bounding box
  CHECK(plain.descent == 2);
}

TEST_CASE("BDF: what is wrong is told with its line") {
  CHECK(bdf_error(replaced(kBdf, "BBX 3 4 1 0", "BBX 3 four 1 0")) ==
        "f: line 18: BBX needs an integer as its value 2, not 'four'");
  CHECK(bdf_error(replaced(kBdf, "BBX 3 4 1 0", "BBX 3 4")) ==
        "f: line 18: BBX needs an integer as its value 3, not ''");
  CHECK(bdf_error(replaced(kBdf, "BBX 3 4 1 0", "BBX 3 1024 1 0")) == "f: line 18: a box of 3x1024 pixels");
  CHECK(bdf_error(replaced(kBdf, "BBX 3 4 1 0", "BBX 3 4 1 9999")) == "f: line 18: a box at 9999");
  CHECK(bdf_error(replaced(kBdf, "DWIDTH 5", "DWIDTH 536870915")) ==
        "f: line 17: a step of the pen of 536870915 pixels");
  CHECK(bdf_error(replaced(kBdf, "C0\n", "G0\n")) == "f: line 21: 'G0' is not hexadecimal");
  CHECK(bdf_error(replaced(kBdf, "BBX 3 4 1 0", "BBX 9 4 1 0")) ==
        "f: line 20: a row of 9 pixels has 2 digits only");
  CHECK(bdf_error(replaced(kBdf, "C0\nA0\n", "")) == "f: line 22: the bitmap has 2 rows of 4");
  CHECK(bdf_error(replaced(kBdf, "ENCODING 98\n", "")) == "f: line 23: character 'b' has no ENCODING");
  CHECK(bdf_error(replaced(kBdf, "DWIDTH 5 0\n", "")) == "f: line 23: character 'b' has no DWIDTH");
  CHECK(bdf_error(replaced(kBdf, "ENDCHAR\n", "")) == "f: line 24: character 'b' has no ENDCHAR");
  CHECK(bdf_error(replaced(kBdf, "ENDFONT\n", "")) == "f: line 39: the file ends without ENDFONT");
  CHECK(bdf_error(kBdf.substr(0, kBdf.find("ENDPROPERTIES"))) ==
        "f: line 11: the file ends within its properties");
  CHECK(bdf_error(replaced(kBdf, "\"ISO10646\"", "\"KOI8\"\nCHARSET_ENCODING \"R\"")) ==
        "f: its characters are numbered by KOI8-R, not by Unicode; take the font's variant for ISO10646-1");
  CHECK(bdf_error(replaced(kBdf, "ENCODING 98", "ENCODING 44")) == "f: has character 44 twice");
  CHECK(bdf_error("STARTFONT 2.1\nFONTBOUNDINGBOX 4 4 0 0\nENDFONT\n") == "f: has no characters");
  CHECK(bdf_error("FONTBOUNDINGBOX") == "f: not a BDF, PCF or .hex font");
  CHECK(bdf_error("") == "f: not a BDF, PCF or .hex font");
}

TEST_CASE(".hex: rows of 8 to 32 pixels are read, and mistakes are told with their line") {
  const SourceFont font =
      decode_font("\n0041:" + std::string(28, '0') + "8001\n01F600:" + std::string(64, 'F') + "\n", "f");
  CHECK(font.ascent == 14);
  CHECK(font.descent == 2);
  REQUIRE(font.glyphs.size() == 2);
  CHECK(font.glyphs[0].width == 8);
  CHECK(font.glyphs[0].advance == 8);
  CHECK(font.glyphs[0].at(0, 14));
  CHECK(font.glyphs[0].at(7, 15));
  CHECK(!font.glyphs[0].at(1, 14));
  CHECK(font.glyphs[1].code == 0x1F600);
  CHECK(font.glyphs[1].width == 16);
  const std::string good = "0041:" + std::string(32, '0') + "\n";
  CHECK(bdf_error(good + "0042:" + std::string(33, '0')) ==
        "f: line 2: 33 digits, where 16 rows of 8, 16, 24 or 32 pixels have 32, 64, 96 or 128");
  CHECK(bdf_error(good + "0042:" + std::string(31, '0') + "x") == "f: line 2: '0x' is not hexadecimal");
  CHECK(bdf_error(good + "110000:" + std::string(32, '0')) == "f: line 2: '110000' is not a code point");
  CHECK(bdf_error(good + "xy:" + std::string(32, '0')) == "f: line 2: 'xy' is not a code point");
  CHECK(bdf_error(good + "comment") == "f: line 2: no colon behind the code point");
}

TEST_CASE("PCF: every byte order, padding and scan unit gives the same font") {
  SourceFont font = decode_font(kBdf, "f");
  SourceGlyph wide{'a', -3, -5, 21, 7, 20, {}};
  for (int i = 0; i < 21 * 7; ++i) wide.pixels.push_back((i * 7 + i / 9) % 3 == 0);
  font.glyphs.insert(font.glyphs.begin() + 1, wide);
  for (const bool bytes_msb : {false, true}) {
    for (const bool bits_msb : {false, true}) {
      for (unsigned pad = 0; pad < 4; ++pad) {
        for (unsigned unit = 0; unit <= std::min(pad, 2u); ++unit) {
          const SourceFont read =
              decode_font(PcfWriter(font, {bytes_msb, bits_msb, pad, unit, pad % 2 == 0}).bytes(), "f");
          CHECK(same(read, font));
          CHECK(read.default_code == 44u);
          CHECK(read.notices == std::vector<std::string>{"us"});
        }
      }
    }
  }
}

TEST_CASE("PCF: files that are cut off or changed are refused or read, with the offset, and do no harm") {
  const std::string good = PcfWriter(decode_font(kBdf, "f"), {}).bytes();
  for (std::size_t size = 4; size < good.size(); ++size) {
    const std::string message = bdf_error(good.substr(0, size));
    if (message.find("f: offset ") != 0) CHECK(message == "(nothing was thrown)");
  }
  CHECK(bdf_error(good.substr(0, 30)) == "f: offset 88: the file is cut off");
  test::Random random(1);
  for (const std::string& file : {good, kBdf, gzipped(good), "0041:" + std::string(32, '1') + "\n"}) {
    for (int i = test::share_of(3000); i > 0; --i) {
      std::string changed = file;
      for (std::int32_t n = random.integer(1, 4); n > 0; --n)
        changed[random.bits() % changed.size()] = static_cast<char>(random.bits());
      try {
        (void)make_font(decode_font(changed, "f"), options(4, {1, 2}, {{0, 300}}), "f");
      } catch (const Failure& failure) {
        CHECK(std::string(failure.what()).starts_with("f: "));
      }
    }
  }
}

TEST_CASE("gzip: files are unpacked, with every optional part of the header, and damage is told") {
  CHECK(gunzip(gzipped("text"), 10, "f") == "text");
  const std::string header("\x1E\0\0\0\0\0\0\2\0xyname\0comment\0hh", 26);
  CHECK(gunzip(gzipped("text", header), 10, "f") == "text");
  CHECK(same(decode_font(gzipped(kBdf), "f"), decode_font(kBdf, "f")));
  const auto error = [](const std::string& bytes) {
    return message_of<Failure>([&] { (void)gunzip(bytes, 10, "f"); });
  };
  CHECK(error(gzipped("text").substr(0, 17)) == "f: the gzip file is cut off");
  for (std::size_t size = 18; size < gzipped("text").size(); ++size)
    CHECK(error(gzipped("text").substr(0, size)).starts_with("f: "));
  CHECK(error(replaced(gzipped("text"), "text", "tent")) == "f: the gzip file is damaged");
  CHECK(error(gzipped("text of more bytes")) == "f: holds more than 10 bytes");
  CHECK(error(replaced(gzipped("text"), "\x08", "\x07")) == "f: an unknown kind of gzip file");
  CHECK(error(gzipped("text", std::string("\x08\0\0\0\0\0\0name", 11)).substr(0, 22)).find("gzip file is") !=
        std::string::npos);
}

TEST_CASE("fonts are made: boxes fit their pixels, rows follow each other, equal bitmaps are stored once") {
  const MadeFont font = make_font(decode_font(kBdf, "f"), options(1), "f");
  CHECK(font.line_height == 8);
  CHECK(font.placeholder == "U+002C");
  REQUIRE(font.ranges.size() == 2);
  CHECK(font.ranges[0].first == 44);
  CHECK(font.ranges[1].first == 98);
  REQUIRE(font.glyphs.size() == 3);
  CHECK(made_rows(font, 1) == "1\n1\n");  // the empty row is gone
  CHECK(int{font.glyphs[1].top} == 5);
  CHECK(int{font.glyphs[1].left} == -1);
  CHECK(int{font.glyphs[1].advance} == 2);
  CHECK(made_rows(font, 2) == "100\n110\n101\n111\n");
  CHECK(int{font.glyphs[2].top} == 2);
  CHECK(font.glyphs[0].bitmap == font.glyphs[1].bitmap);
  CHECK(font.bitmaps.size() == 1 + 2 + 4);
  CHECK(font.bytes() == 2 * 12 + 3 * 8 + 7);
  CHECK(font.left_out.empty());
  const MadeFont more = make_font(decode_font(kBdf, "f"), options(1, {}, {{97, 99}, {98, 98}}), "f");
  CHECK(more.left_out == std::vector<std::uint32_t>{97, 99});
  CHECK(message_of<Failure>([] {
          (void)make_font(decode_font(kBdf, "f"), options(1, {}, {{1, 2}}), "f");
        }) == "f: has none of the characters of --range");
}

TEST_CASE("fonts are scaled: blocks of pixels begin at the pen and on the baseline") {
  const SourceFont source = decode_font(kBdf, "f");
  const MadeFont twice = make_font(source, options(1, {2, 1}), "f");
  CHECK(twice.line_height == 16);
  CHECK(made_rows(twice, 1) == "11\n11\n11\n11\n");
  CHECK(int{twice.glyphs[1].top} == 10);
  CHECK(int{twice.glyphs[2].left} == 2);
  CHECK(int{twice.glyphs[2].advance} == 10);
  // The b begins in column 1: its blocks are columns 0-1 and 2-3, rows of two from the baseline upwards.
  const MadeFont smooth = make_font(source, options(4, {1, 2}), "f");
  CHECK(smooth.line_height == 4);
  CHECK(made_rows(smooth, 2) == "84\n8b\n");
  CHECK(int{smooth.glyphs[2].left} == 0);
  CHECK(int{smooth.glyphs[2].top} == 1);
  CHECK(int{smooth.glyphs[2].advance} == 3);
  // The comma is in column -1: its block is columns -2 and -1, rows -1-0 and 1-2.
  CHECK(made_rows(smooth, 1) == "4\n4\n");
  CHECK(int{smooth.glyphs[1].left} == -1);
  CHECK(int{smooth.glyphs[1].top} == 2);
  const MadeFont hard = make_font(source, options(1, {1, 2}), "f");
  CHECK(made_rows(hard, 2) == "10\n11\n");
}

TEST_CASE("a font without a visible default character shows a box, and huge glyphs are refused") {
  SourceFont source = decode_font(kBdf, "f");
  source.default_code = 1;
  MadeFont font = make_font(source, options(1), "f");
  CHECK(font.placeholder == "a hollow box");
  CHECK(made_rows(font, 0) == "111\n101\n101\n111\n");
  source.glyphs[1].advance = 300;
  CHECK(message_of<Failure>([&] { (void)make_font(source, options(1), "f"); }) ==
        "f: the glyph of U+0062 has 3x4 pixels at column 1 and moves the pen by 300; a font has up to "
        "255x255 at "
        "-128...127 and moves by 0...255");
  source.glyphs[1].advance = -1;
  CHECK_THROWS_AS(make_font(source, options(1), "f"), Failure);
}

TEST_CASE("large fonts have ranges whose bitmaps are within 16 bits, and every glyph is found") {
  SourceFont source;
  source.ascent = 20;
  test::Random random(3);
  for (std::uint32_t code = 100; code < 1500; ++code) {
    SourceGlyph glyph{code, 0, -20, 32, 32, 32, {}};
    for (int i = 0; i < 32 * 32; ++i) glyph.pixels.push_back(i == 0 || i == 1023 || random.chance(0.5));
    source.glyphs.push_back(glyph);
  }
  const MadeFont made = make_font(source, options(1, {}, {{100, 1499}}), "f");
  CHECK(made.bitmaps.size() > 2 * 0x10000);
  CHECK(made.ranges.size() >= 3);
  overlay::Font<1> font;
  REQUIRE(ok(overlay::Font<1>::make(made.ranges, made.glyphs, made.bitmaps, made.line_height, font)));
  std::size_t wrong = 0;
  for (const SourceGlyph& glyph : source.glyphs) {
    const auto found = font.find(glyph.code);
    for (std::size_t i = 0; i < 1024; ++i)
      wrong += ((found.bitmap[i / 8] >> (7 - i % 8) & 1) != 0) != glyph.pixels[i] ? 1u : 0u;
  }
  CHECK(wrong == 0);
}

TEST_CASE("ranges of characters are parsed") {
  using Ranges = std::vector<CodeRange>;
  CHECK(parse_ranges("32-126,0xB0,U+2190-U+2193") == Ranges{{32, 126}, {0xB0, 0xB0}, {0x2190, 0x2193}});
  CHECK(parse_ranges("0-0x10FFFF") == Ranges{{0, 0x10FFFF}});
  for (const char* wrong :
       {"", ",", "1,", "a", "0x", "5-4", "1-", "-1", "0x110000", "99999999999", "1--2", " 1"})
    CHECK(!parse_ranges(wrong));
}

TEST_CASE("the picture of a font shows its characters and its placeholder") {
  const Image picture = font_picture(make_font(decode_font(kBdf, "f"), options(1), "f"));
  std::size_t white = 0;
  for (const Rgb8& pixel : picture.pixels) white += pixel == Rgb8{255, 255, 255} ? 1u : 0u;
  CHECK(white == 2 + 8 + 2);
}
