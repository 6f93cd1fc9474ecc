// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/pixel_format.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// The cursor of a format whose pixels are one word each.
template <class Pixel>
class WordCursor {
 public:
  constexpr WordCursor(Pixel* row, std::int32_t x) : at_(row + x) {}
  constexpr void write(Pixel encoded) { *at_ = encoded; }
  [[nodiscard]] constexpr Pixel read() const { return *at_; }
  constexpr void next() { ++at_; }
  constexpr void skip(std::int32_t count) { at_ += count; }
  /// The address of the present pixel. Those to its right follow in memory.
  [[nodiscard]] constexpr Pixel* pixels() const { return at_; }

 private:
  Pixel* at_;
};

/// The cursor of a format with `Bits` = 1, 2 or 4 bits per pixel. The leftmost pixel of a byte is in its
/// highest bits.
template <unsigned Bits>
class BitCursor {
 public:
  constexpr BitCursor(std::uint8_t* row, std::int32_t x)
      : at_(row + (x >> kLog2PerByte)), shift_(kTop - Bits * (static_cast<unsigned>(x) & kMaskPerByte)) {}
  constexpr void write(std::uint8_t encoded) {
    const unsigned kept = *at_ & ~(kPixelMask << shift_);
    *at_ = static_cast<std::uint8_t>(kept | (static_cast<unsigned>(encoded) << shift_));
  }
  [[nodiscard]] constexpr std::uint8_t read() const {
    return static_cast<std::uint8_t>((*at_ >> shift_) & kPixelMask);
  }
  constexpr void next() {
    if (shift_ == 0) {
      ++at_;
      shift_ = kTop;
    } else {
      shift_ -= Bits;
    }
  }

 private:
  static constexpr unsigned kLog2PerByte = Bits == 1 ? 3 : Bits == 2 ? 2 : 1;
  static constexpr unsigned kMaskPerByte = (1u << kLog2PerByte) - 1;
  static constexpr unsigned kTop = 8 - Bits;
  static constexpr unsigned kPixelMask = (1u << Bits) - 1;

  std::uint8_t* at_;
  unsigned shift_;
};

}  // namespace arcspan
