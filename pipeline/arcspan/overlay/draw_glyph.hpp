// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/overlay/area.hpp>
#include <arcspan/overlay/font.hpp>
#include <arcspan/overlay/mixed_colour.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

/// How the pixels of a glyph are written. A mask says which pixels of a glyph's box are covered; its
/// `kMargin` is how far it reaches beyond the box.
namespace arcspan::overlay::detail {

/// 32 bits from bit `at` of `bytes` on, the first one the highest. Five bytes are read.
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t bits_at(const std::uint8_t* bytes, std::uint32_t at) {
  bytes += static_cast<std::size_t>(at >> 3);
  const std::uint32_t word = (std::uint32_t{bytes[0]} << 24) | (std::uint32_t{bytes[1]} << 16) |
                             (std::uint32_t{bytes[2]} << 8) | bytes[3];
  const std::uint32_t shift = at & 7u;
  return (word << shift) | (std::uint32_t{bytes[4]} >> (8 - shift));
}

/// The highest `count` of 32 bits, 0...32.
[[nodiscard]] constexpr std::uint32_t highest_bits(std::uint32_t word, std::int32_t count) {
  return count < 32 ? word & ~(0xFFFFFFFFu >> count) : word;
}

/// The pixels of a glyph of 1 bit.
struct BitMask {
  static constexpr std::int32_t kMargin = 0;
  static constexpr std::int32_t kColumns = 32;  ///< that columns() returns

  const Glyph& glyph;
  const std::uint8_t* bitmap;

  /// Pixels of row `y` of the box from column `x` on, the left one in the highest bit; 0 beyond `count`. All
  /// of them lie in the box.
  [[nodiscard]] constexpr std::uint32_t columns(std::int32_t x, std::int32_t y, std::int32_t count) const {
    const auto row = static_cast<std::uint32_t>(y) * glyph.width;
    return highest_bits(bits_at(bitmap, row + static_cast<std::uint32_t>(x)), count);
  }
};

/// The pixels of a glyph of 1 bit and their eight neighbours.
struct BitOutline {
  static constexpr std::int32_t kMargin = 1;
  static constexpr std::int32_t kColumns = 30;

  BitMask mask;

  [[nodiscard]] constexpr std::uint32_t columns(std::int32_t x, std::int32_t y, std::int32_t count) const {
    const std::uint32_t three =
        columns_or_none(x - 1, y - 1) | columns_or_none(x - 1, y) | columns_or_none(x - 1, y + 1);
    return highest_bits(three | (three << 1) | (three << 2), count);
  }

 private:
  /// 32 pixels from column x on, which may be -2 or more.
  [[nodiscard]] constexpr std::uint32_t columns_or_none(std::int32_t x, std::int32_t y) const {
    if (y < 0 || y >= mask.glyph.height) return 0;
    const std::int32_t left = x < 0 ? 0 : x;
    if (left >= mask.glyph.width) return 0;
    return mask.columns(left, y, mask.glyph.width - left) >> (left - x);
  }
};

/// Writes the pixels of a mask of bits, run by run.
template <class Mask, PixelSink Sink>
[[nodiscard]] constexpr Status draw_mask(Sink& sink, const Mask& mask, Point at, const Rect& visible,
                                         typename Sink::Format::Encoded colour) {
  for (std::int32_t y = visible.top; y < visible.bottom; ++y) {
    for (std::int32_t x = visible.left; x < visible.right; x += Mask::kColumns) {
      const std::int32_t left = visible.right - x;
      std::uint32_t word = mask.columns(x - at.x, y - at.y, left < Mask::kColumns ? left : Mask::kColumns);
      for (std::int32_t column = x; word != 0;) {
        const int skipped = leading_zeros(word);
        word <<= skipped;
        const int count = leading_zeros(~word);
        const Status status = fill_run(sink, {y, column + skipped, count}, colour);
        if (!ok(status)) return status;
        column += skipped + count;
        word = count < 32 ? word << count : 0;
      }
    }
  }
  return Status::kOk;
}

/// The coverage of the pixels of a glyph of 4 bits.
struct CoverageMask {
  static constexpr std::int32_t kMargin = 0;

  const Glyph& glyph;
  const std::uint8_t* bitmap;

  /// The coverage of a pixel of the box, 0...15.
  [[nodiscard]] constexpr std::uint32_t at(std::int32_t x, std::int32_t y) const {
    const std::uint32_t pixel = static_cast<std::uint32_t>(y) * glyph.width + static_cast<std::uint32_t>(x);
    return (std::uint32_t{bitmap[static_cast<std::size_t>(pixel >> 1)]} >> ((~pixel & 1u) << 2)) & 15u;
  }
};

/// The coverage of the pixel of a glyph of 4 bits that covers most among a pixel and its eight neighbours.
struct CoverageOutline {
  static constexpr std::int32_t kMargin = 1;

  CoverageMask mask;

  [[nodiscard]] constexpr std::uint32_t at(std::int32_t x, std::int32_t y) const {
    std::uint32_t most = 0;
    for (std::int32_t row = y - 1; row <= y + 1; ++row) {
      if (row < 0 || row >= mask.glyph.height) continue;
      for (std::int32_t column = x - 1; column <= x + 1; ++column) {
        if (column < 0 || column >= mask.glyph.width) continue;
        const std::uint32_t coverage = mask.at(column, row);
        if (coverage > most) most = coverage;
      }
    }
    return most;
  }
};

/// Mixes the covered pixels of a run of at most 32 pixels; `coverage` has them in its order.
template <PixelSink Sink>
[[nodiscard]] constexpr Status mix_run(Sink& sink, const Span& run, const std::uint8_t* coverage,
                                       const MixedColour<typename Sink::Format>& colour) {
  typename Sink::Format::Cursor cursor = sink.open(run);
  for (std::int32_t i = 0; i < run.count; ++i, cursor.next()) {
    const std::uint32_t share = (coverage[i] * 34u + 8) >> 4;  // 0...15 to 0...32
    cursor.write(colour.over(cursor.read(), share));
  }
  return sink.close(run);
}

/// Mixes the pixels of a mask of coverages, run by run.
template <class Mask, PixelSink Sink>
[[nodiscard]] constexpr Status draw_mask(Sink& sink, const Mask& mask, Point at, const Rect& visible,
                                         const MixedColour<typename Sink::Format>& colour) {
  constexpr std::int32_t kMost = 32;
  std::uint8_t coverage[kMost];
  for (std::int32_t y = visible.top; y < visible.bottom; ++y) {
    for (std::int32_t x = visible.left; x < visible.right;) {
      std::int32_t count = 0;
      for (; count < kMost && x + count < visible.right; ++count) {
        const std::uint32_t covered = mask.at(x + count - at.x, y - at.y);
        if (covered == 0) break;
        coverage[count] = static_cast<std::uint8_t>(covered);
      }
      if (count == 0) {
        ++x;
        continue;
      }
      const Status status = mix_run(sink, {y, x, count}, coverage, colour);
      if (!ok(status)) return status;
      x += count;
    }
  }
  return Status::kOk;
}

}  // namespace arcspan::overlay::detail
