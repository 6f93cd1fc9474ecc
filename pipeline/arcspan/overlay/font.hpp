// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/overlay/utf8.hpp>
#include <arcspan/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan::overlay {

/// The picture of a character: a box of pixels, and how far the pen moves. The box is as small as its pixels
/// allow; a space has one of 0 by 0.
struct Glyph {
  std::uint16_t bitmap = 0;  ///< first byte, from GlyphRange::bitmaps on
  std::int16_t top = 0;      ///< rows from the top of the line down to the box
  std::int8_t left = 0;      ///< columns from the pen to the box
  std::uint8_t width = 0;
  std::uint8_t height = 0;
  std::uint8_t advance = 0;  ///< columns from this glyph's pen to the next one's
};

/// The glyphs of consecutive code points: first ... first + count - 1 have glyphs[glyph ... glyph + count -
/// 1].
struct GlyphRange {
  std::uint32_t first = 0;
  std::uint32_t bitmaps = 0;  ///< byte that Glyph::bitmap counts from
  std::uint16_t count = 0;
  std::uint16_t glyph = 0;
};

namespace detail::refused {  // the reasons of Font::of()
void font_ranges_overlap_or_are_not_in_order();
void font_glyph_does_not_exist();
void font_bitmaps_too_small();
}  // namespace detail::refused

/// A font in the caller's memory, usually flash, which must outlive it; nothing is copied. `arcspan font`
/// makes headers with fonts.
///
/// The rows of a glyph's bitmap follow each other without a gap, from the upper left pixel on. With `Bits` =
/// 1 a set bit is a pixel of the glyph, the highest bit of a byte first. With `Bits` = 4 a pixel is its
/// coverage, 0...15, the left one of two in the upper bits. Glyph 0 is the placeholder for code points that
/// the font does not have; its bitmap counts from byte 0.
template <unsigned Bits>
class Font {
  static_assert(Bits == 1 || Bits == 4, "a pixel of a font has 1 bit or 4");

 public:
  static constexpr unsigned kBits = Bits;
  /// Bytes behind the last bitmap: four are read at once.
  static constexpr std::size_t kPadding = 4;

  /// A glyph with its bitmap.
  struct Found {
    const Glyph* glyph;
    const std::uint8_t* bitmap;
  };

  /// A font without any pixel. A place for make().
  constexpr Font() = default;

  /// Makes a font with lines of `line_height` rows, the distance of two lines of a caption. Returns:
  ///
  ///   kOk                `font` is set; otherwise it is not changed
  ///   kInvalidArgument   `line_height` is not in 1...32767, or the ranges are empty, overlap, are not in
  ///                      ascending order or exceed U+10FFFF
  ///   kIndexOutOfRange   a range has glyphs that do not exist, or there is none at all
  ///   kBufferTooSmall    a bitmap or the kPadding bytes behind it lie outside of `bitmaps`
  static constexpr Status make(std::span<const GlyphRange> ranges, std::span<const Glyph> glyphs,
                               std::span<const std::uint8_t> bitmaps, std::int32_t line_height, Font& font) {
    Font made;
    const Status status = made.set(ranges, glyphs, bitmaps, line_height);
    if (ok(status)) font = made;
    return status;
  }

  /// make() as a constant. Arguments that make() rejects do not compile.
  [[nodiscard]] static consteval Font of(std::span<const GlyphRange> ranges, std::span<const Glyph> glyphs,
                                         std::span<const std::uint8_t> bitmaps, std::int32_t line_height) {
    Font font;
    const Status status = make(ranges, glyphs, bitmaps, line_height, font);
    if (status == Status::kInvalidArgument) detail::refused::font_ranges_overlap_or_are_not_in_order();
    if (status == Status::kIndexOutOfRange) detail::refused::font_glyph_does_not_exist();
    if (status == Status::kBufferTooSmall) detail::refused::font_bitmaps_too_small();
    return font;
  }

  /// The glyph of a code point, or the placeholder. Control characters below U+0020 are shown as spaces.
  [[nodiscard]] constexpr Found find(std::uint32_t code) const {
    if (code < 0x20) code = 0x20;
    std::uint32_t low = 0;  // the ranges below begin at `code` or before it, those from `high` on behind it
    for (std::uint32_t high = range_count_; low < high;) {
      const std::uint32_t middle = (low + high) / 2;
      if (ranges_[middle].first <= code)
        low = middle + 1;
      else
        high = middle;
    }
    if (low != 0) {
      const GlyphRange& range = ranges_[low - 1];
      const std::uint32_t index = code - range.first;
      if (index < range.count) {
        const Glyph& glyph = glyphs_[range.glyph + index];
        return {&glyph, bitmaps_ + static_cast<std::size_t>(range.bitmaps + glyph.bitmap)};
      }
    }
    return {glyphs_, bitmaps_ + glyphs_->bitmap};
  }

  /// The glyph that find() returns for code points that the font does not have.
  [[nodiscard]] constexpr const Glyph* placeholder() const { return glyphs_; }
  /// Rows from the top of a line to that of the next one.
  [[nodiscard]] constexpr std::int32_t line_height() const { return line_height_; }
  /// The first row that the line or a glyph takes, relative to the top of the line: 0 or less.
  [[nodiscard]] constexpr std::int32_t top() const { return top_; }
  /// The row behind the last one, likewise: line_height() or more.
  [[nodiscard]] constexpr std::int32_t bottom() const { return bottom_; }

 private:
  static constexpr Glyph kNoGlyph{};
  static constexpr std::uint8_t kNoBitmap[kPadding] = {};

  constexpr Status set(std::span<const GlyphRange> ranges, std::span<const Glyph> glyphs,
                       std::span<const std::uint8_t> bitmaps, std::int32_t line_height) {
    if (line_height < 1 || line_height > INT16_MAX || ranges.size() > 0xFFFF) return Status::kInvalidArgument;
    if (glyphs.empty()) return Status::kIndexOutOfRange;
    line_height_ = bottom_ = line_height;
    if (!include(glyphs.data(), 1, 0, bitmaps.size())) return Status::kBufferTooSmall;
    std::uint32_t next = 0;
    for (const GlyphRange& range : ranges) {
      if (range.count == 0 || range.first < next || range.first > 0x110000u - range.count)
        return Status::kInvalidArgument;
      if (std::uint32_t{range.glyph} + range.count > glyphs.size()) return Status::kIndexOutOfRange;
      next = range.first + range.count;
      if (!include(glyphs.data() + range.glyph, range.count, range.bitmaps, bitmaps.size()))
        return Status::kBufferTooSmall;
    }
    ranges_ = ranges.data();
    glyphs_ = glyphs.data();
    bitmaps_ = bitmaps.data();
    range_count_ = static_cast<std::uint16_t>(ranges.size());
    return Status::kOk;
  }

  /// Makes top_ and bottom_ include `count` glyphs. Returns false if one of their bitmaps, which count from
  /// byte `base`, is not within `bytes` bytes. (Compilers limit the steps of constants: no calls per glyph.)
  constexpr bool include(const Glyph* glyph, std::uint32_t count, std::uint32_t base, std::size_t bytes) {
    if (base > bytes) return false;
    for (const Glyph* const end = glyph + count; glyph != end; ++glyph) {
      if (glyph->top < top_) top_ = glyph->top;
      if (std::int32_t{glyph->top} + glyph->height > bottom_)
        bottom_ = std::int32_t{glyph->top} + glyph->height;
      const std::uint32_t size = (std::uint32_t{glyph->width} * glyph->height * Bits + 7) / 8 + kPadding;
      if (glyph->bitmap + size > bytes - base) return false;
    }
    return true;
  }

  const GlyphRange* ranges_ = nullptr;
  const Glyph* glyphs_ = &kNoGlyph;
  const std::uint8_t* bitmaps_ = kNoBitmap;
  std::uint16_t range_count_ = 0;
  std::int32_t line_height_ = 1;
  std::int32_t top_ = 0;
  std::int32_t bottom_ = 1;
};

/// The columns that `text` moves the pen in one line, saturated.
template <unsigned Bits>
[[nodiscard]] constexpr std::int32_t text_width(const Font<Bits>& font, Utf8Text text) {
  std::int32_t width = 0;
  while (!text.empty() && width < INT32_MAX - UINT8_MAX) width += font.find(text.take()).glyph->advance;
  return width;
}

/// The number of code points in `text` that the font shows as its placeholder. Newlines do not count.
template <unsigned Bits>
[[nodiscard]] constexpr std::size_t missing_glyphs(const Font<Bits>& font, Utf8Text text) {
  std::size_t count = 0;
  while (!text.empty()) {
    const std::uint32_t code = text.take();
    if (code != '\n' && font.find(code).glyph == font.placeholder()) ++count;
  }
  return count;
}

}  // namespace arcspan::overlay
