// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/hal/panel/glass.hpp>
#include <arcspan/numbers/unroll.hpp>
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/pixel/mono.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/target.hpp>

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace arcspan::hal {

/// Order of pixels and bytes on the way to a controller. Each driver names its layout as `Layout`.
///
/// `Format` is the format of the framebuffer. Windows start and end at multiples of column_step(o) columns
/// and row_step(o) rows of the picture. `pack` writes the pixels of `area`, bytes(area) bytes, to `out` in
/// the order in which they are sent; `area` must fit the steps and lie inside the frame's bounds.
template <class L>
concept WireLayout = PixelFormat<typename L::Format> &&
    requires(const Framebuffer<typename L::Format>& frame, const Rect& area, Orientation o,
             std::uint8_t* out) {
  { L::column_step(o) } -> std::same_as<std::int32_t>;
  { L::row_step(o) } -> std::same_as<std::int32_t>;
  { L::bytes(area) } -> std::same_as<std::size_t>;
  { L::pack(frame, area, o, out) } -> std::same_as<void>;
};

namespace detail {
[[nodiscard]] constexpr std::size_t pixel_count(const Rect& r) {
  return static_cast<std::size_t>(r.width()) * static_cast<std::size_t>(r.height());
}

/// Two pixels with the bytes of each exchanged.
[[nodiscard]] ARCSPAN_INLINE inline AliasingWord with_bytes_exchanged(AliasingWord two) {
  if constexpr (kReversesBytes) {
    return std::rotl(__builtin_bswap32(two), 16);
  } else {
    return ((two >> 8) & 0x00FF00FFu) | ((two & 0x00FF00FFu) << 8);
  }
}

/// Writes `count` pixels with the high byte first, and returns their end. Two pixels are moved as a word
/// where both addresses are multiples of 4, if need be after the first pixel.
constexpr std::uint8_t* put_high_byte_first(const std::uint16_t* pixels, std::size_t count,
                                            std::uint8_t* out) {
  const auto put_one = [&] {
    *out++ = static_cast<std::uint8_t>(*pixels >> 8);
    *out++ = static_cast<std::uint8_t>(*pixels++);
    --count;
  };
  if constexpr (std::endian::native == std::endian::little && kHasWords) {
    if (!std::is_constant_evaluated()) {
      const auto address = [](const void* at) { return reinterpret_cast<std::uintptr_t>(at); };
      if (count != 0 && address(pixels) % sizeof(AliasingWord) != 0) put_one();
      if (address(out) % sizeof(AliasingWord) == 0) {
        const auto* from = static_cast<const AliasingWord*>(static_cast<const void*>(pixels));
        auto* to = static_cast<AliasingWord*>(static_cast<void*>(out));
        const auto put_two = [&] { *to++ = with_bytes_exchanged(*from++); };
        for (std::size_t left = count / 8; left != 0; --left) unrolled<4>([&](auto) { put_two(); });
        for (std::size_t left = count % 8 / 2; left != 0; --left) put_two();
        pixels += count / 2 * 2;
        out += count / 2 * 4;
        count %= 2;
      }
    }
  }
  while (count != 0) put_one();
  return out;
}
}  // namespace detail

/// 16 bits per pixel, high byte first, row by row. The controller rotates.
struct BigEndianRgb565 {
  using Format = Rgb565;
  [[nodiscard]] static constexpr std::int32_t column_step(Orientation) { return 1; }
  [[nodiscard]] static constexpr std::int32_t row_step(Orientation) { return 1; }
  [[nodiscard]] static constexpr std::size_t bytes(const Rect& area) { return 2 * detail::pixel_count(area); }
  static constexpr void pack(const Framebuffer<Rgb565>& frame, const Rect& area, Orientation,
                             std::uint8_t* out) {
    const auto width = static_cast<std::size_t>(area.width());
    for (std::int32_t y = area.top; y < area.bottom; ++y)
      out = detail::put_high_byte_first(frame.row(y) + area.left, width, out);
  }
};

/// Two 4-bit pixels per byte, the left one in the high nibble, in rows of the glass. The controller cannot
/// exchange axes, so a picture turned by 90 or 270 degrees is packed column by column.
struct Gray4Pairs {
  using Format = Gray4;
  [[nodiscard]] static constexpr std::int32_t column_step(Orientation o) { return swaps_axes(o) ? 1 : 2; }
  [[nodiscard]] static constexpr std::int32_t row_step(Orientation o) { return swaps_axes(o) ? 2 : 1; }
  [[nodiscard]] static constexpr std::size_t bytes(const Rect& area) { return detail::pixel_count(area) / 2; }
  static constexpr void pack(const Framebuffer<Gray4>& frame, const Rect& area, Orientation o,
                             std::uint8_t* out) {
    if (swaps_axes(o)) {
      for (std::int32_t x = area.left; x < area.right; ++x) {
        for (std::int32_t y = area.top; y < area.bottom; y += 2) {
          const unsigned left = Gray4::Cursor(frame.row(y), x).read();
          *out++ = static_cast<std::uint8_t>((left << 4) | Gray4::Cursor(frame.row(y + 1), x).read());
        }
      }
      return;
    }
    for (std::int32_t y = area.top; y < area.bottom; ++y) {
      const std::uint8_t* row = frame.row(y);
      for (std::int32_t i = area.left / 2; i < area.right / 2; ++i) *out++ = row[i];
    }
  }
};

/// Pages of 8 rows of the glass: one byte per column, the top pixel in the lowest bit.
struct MonoPages {
  using Format = Mono;
  [[nodiscard]] static constexpr std::int32_t column_step(Orientation o) { return swaps_axes(o) ? 8 : 1; }
  [[nodiscard]] static constexpr std::int32_t row_step(Orientation o) { return swaps_axes(o) ? 1 : 8; }
  [[nodiscard]] static constexpr std::size_t bytes(const Rect& area) { return detail::pixel_count(area) / 8; }
  static constexpr void pack(const Framebuffer<Mono>& frame, const Rect& area, Orientation o,
                             std::uint8_t* out) {
    if (swaps_axes(o)) {
      for (std::int32_t x = area.left; x < area.right; x += 8) {
        for (std::int32_t y = area.top; y < area.bottom; ++y) *out++ = reversed(frame.row(y)[x / 8]);
      }
      return;
    }
    for (std::int32_t y = area.top; y < area.bottom; y += 8) {
      std::int32_t x = area.left;
      while (x < area.right) {
        if (kHasWords && x % 8 == 0 && x + 8 <= area.right) {
          put_columns(frame, x, y, out);
          x += 8;
          out += 8;
        } else {
          *out++ = column(frame, x++, y);
        }
      }
    }
  }

 private:
  /// Writes column() for the eight columns from x, a multiple of 8, by transposing a matrix of 8x8 bits
  /// (Warren, Hacker's Delight, 7-3). An 8-bit processor would shift words for longer.
  static constexpr void put_columns(const Framebuffer<Mono>& frame, std::int32_t x, std::int32_t y,
                                    std::uint8_t* out) {
    std::uint32_t halves[2] = {};  // a byte per row: the lower four rows, then the upper four
    for (std::int32_t i = 7; i >= 0; --i) halves[i < 4] = (halves[i < 4] << 8) | frame.row(y + i)[x / 8];
    for (std::uint32_t& half : halves) {
      const std::uint32_t ones = (half ^ (half >> 7)) & 0x00AA00AAu;
      half ^= ones ^ (ones << 7);
      const std::uint32_t twos = (half ^ (half >> 14)) & 0x0000CCCCu;
      half ^= twos ^ (twos << 14);
    }
    const std::uint32_t left = (halves[0] & 0xF0F0F0F0u) | ((halves[1] >> 4) & 0x0F0F0F0Fu);
    const std::uint32_t right = ((halves[0] << 4) & 0xF0F0F0F0u) | (halves[1] & 0x0F0F0F0Fu);
    for (int shift = 24; shift >= 0; shift -= 8) {
      out[3 - shift / 8] = static_cast<std::uint8_t>(left >> shift);
      out[7 - shift / 8] = static_cast<std::uint8_t>(right >> shift);
    }
  }
  [[nodiscard]] static constexpr std::uint8_t reversed(unsigned b) {
    b = ((b & 0x0Fu) << 4) | ((b >> 4) & 0x0Fu);
    b = ((b & 0x33u) << 2) | ((b >> 2) & 0x33u);
    b = ((b & 0x55u) << 1) | ((b >> 1) & 0x55u);
    return static_cast<std::uint8_t>(b);
  }
  [[nodiscard]] static constexpr std::uint8_t column(const Framebuffer<Mono>& frame, std::int32_t x,
                                                     std::int32_t y) {
    unsigned bits = 0;
    const int shift = 7 - (x & 7);
    for (std::int32_t i = 0; i < 8; ++i) {
      bits |= ((static_cast<unsigned>(frame.row(y + i)[x / 8]) >> shift) & 1u) << i;
    }
    return static_cast<std::uint8_t>(bits);
  }
};

static_assert(WireLayout<BigEndianRgb565> && WireLayout<Gray4Pairs> && WireLayout<MonoPages>);

/// Whether all sides of `area` are multiples of the layout's steps.
template <WireLayout L>
[[nodiscard]] constexpr bool fits_steps(const Rect& area, Orientation o) {
  const std::int32_t c = L::column_step(o);
  const std::int32_t r = L::row_step(o);
  return area.left % c == 0 && area.right % c == 0 && area.top % r == 0 && area.bottom % r == 0;
}

/// Smallest area that contains `area` and fits the layout's steps. No side of `area` may be negative.
template <WireLayout L>
[[nodiscard]] constexpr Rect widened(const Rect& area, Orientation o) {
  const std::int32_t c = L::column_step(o);
  const std::int32_t r = L::row_step(o);
  return {area.left / c * c, area.top / r * r, (area.right + c - 1) / c * c, (area.bottom + r - 1) / r * r};
}

}  // namespace arcspan::hal
