// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/overlay/area.hpp>
#include <arcspan/overlay/font.hpp>
#include <arcspan/pixel/mixed_pixels.hpp>
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

  /// Pixels of row `y` of the box from column `x` on, the left one in the highest bit. Beyond the box they
  /// are any.
  [[nodiscard]] constexpr std::uint32_t columns(std::int32_t x, std::int32_t y) const {
    return bits_at(bitmap, static_cast<std::uint32_t>(y * glyph.width + x));
  }
};

/// The pixels of a glyph of 1 bit and their eight neighbours.
struct BitOutline {
  static constexpr std::int32_t kMargin = 1;
  static constexpr std::int32_t kColumns = 30;

  const Glyph& glyph;
  const std::uint8_t* bitmap;

  /// As BitMask::columns(), kColumns of them.
  [[nodiscard]] constexpr std::uint32_t columns(std::int32_t x, std::int32_t y) const {
    std::uint32_t three = 0;
    for (std::int32_t row = y - 1; row <= y + 1; ++row)
      if (row >= 0 && row < glyph.height) three |= columns_or_none(x - 1, row);
    return highest_bits(three | (three << 1) | (three << 2), kColumns);
  }

 private:
  /// 32 pixels from column x on, which is -2 or more.
  [[nodiscard]] constexpr std::uint32_t columns_or_none(std::int32_t x, std::int32_t y) const {
    const std::int32_t left = x < 0 ? 0 : x;
    if (left >= glyph.width) return 0;
    const std::uint32_t bits = bits_at(bitmap, static_cast<std::uint32_t>(y * glyph.width + left));
    return highest_bits(bits, glyph.width - left) >> (left - x);
  }
};

/// A mask that returns several pixels at once, a bit each; others return the coverage of one.
template <class M>
concept MaskOfBits = requires {
  M::kColumns;
};

/// The part of a glyph's box, with the margin of a mask around it, that lies within `clip`. It is relative to
/// the upper left pixel of the box, which is at `at`.
template <class Mask>
[[nodiscard]] constexpr Rect part_within(const Rect& clip, Point at, const Glyph& glyph) {
  constexpr std::int32_t kMargin = Mask::kMargin;
  return intersection({wrap_sub(clip.left, at.x), wrap_sub(clip.top, at.y), wrap_sub(clip.right, at.x),
                       wrap_sub(clip.bottom, at.y)},
                      {-kMargin, -kMargin, glyph.width + kMargin, glyph.height + kMargin});
}

/// Writes the pixels of a glyph by a mask of bits, run by run; `at` is the upper left pixel of its box.
template <MaskOfBits Mask, PixelSink Sink>
[[nodiscard]] constexpr Status draw_glyph(Sink& sink, const Mask& mask, Point at, const Rect& clip,
                                          typename Sink::Format::Encoded colour) {
  const Rect part = part_within<Mask>(clip, at, mask.glyph);
  for (std::int32_t y = part.top; y < part.bottom; ++y) {
    for (std::int32_t x = part.left; x < part.right; x += Mask::kColumns) {
      std::uint32_t word = highest_bits(mask.columns(x, y), part.right - x);
      for (std::int32_t column = x; word != 0;) {
        const int skipped = leading_zeros(word);
        word <<= skipped;
        const int count = leading_zeros(~word);
        column += skipped;
        const Status status = fill_run(sink, {wrap_add(at.y, y), wrap_add(at.x, column), count}, colour);
        if (!ok(status)) return status;
        column += count;
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

  const Glyph& glyph;
  const std::uint8_t* bitmap;

  [[nodiscard]] constexpr std::uint32_t at(std::int32_t x, std::int32_t y) const {
    std::uint32_t most = 0;
    for (std::int32_t row = y - 1; row <= y + 1; ++row) {
      if (row < 0 || row >= glyph.height) continue;
      for (std::int32_t column = x - 1; column <= x + 1; ++column) {
        if (column < 0 || column >= glyph.width) continue;
        const std::uint32_t coverage = CoverageMask{glyph, bitmap}.at(column, row);
        if (coverage > most) most = coverage;
      }
    }
    return most;
  }
};

/// Mixes the covered pixels of a run of at most 32 pixels; `coverage` has them in its order.
template <PixelSink Sink>
[[nodiscard]] constexpr Status mix_run(Sink& sink, const Span& run, const std::uint8_t* coverage,
                                       typename Sink::Format::Encoded colour) {
  using Format = typename Sink::Format;
  typename Format::Cursor cursor = sink.open(run);
  for (std::int32_t i = 0; i < run.count; ++i, cursor.next()) {
    const std::uint32_t share = (coverage[i] * 34u + 8) >> 4;  // 0...15 to 0...32
    cursor.write(arcspan::detail::mixed_pixels<Format>(cursor.read(), colour, share));
  }
  return sink.close(run);
}

/// Mixes the pixels of a glyph by a mask of coverages, run by run; `at` is the upper left pixel of its box.
template <class Mask, PixelSink Sink>
[[nodiscard]] constexpr Status draw_glyph(Sink& sink, const Mask& mask, Point at, const Rect& clip,
                                          typename Sink::Format::Encoded colour) {
  constexpr std::int32_t kMost = 32;
  std::uint8_t coverage[kMost];
  const Rect part = part_within<Mask>(clip, at, mask.glyph);
  for (std::int32_t y = part.top; y < part.bottom; ++y) {
    for (std::int32_t x = part.left; x < part.right;) {
      std::int32_t count = 0;
      for (; count < kMost && x + count < part.right; ++count) {
        coverage[count] = static_cast<std::uint8_t>(mask.at(x + count, y));
        if (coverage[count] == 0) break;
      }
      if (count == 0) {
        ++x;
        continue;
      }
      const Status status = mix_run(sink, {wrap_add(at.y, y), wrap_add(at.x, x), count}, coverage, colour);
      if (!ok(status)) return status;
      x += count;
    }
  }
  return Status::kOk;
}

}  // namespace arcspan::overlay::detail
