// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/row_start.hpp>

#include <cstdint>

namespace arcspan::literature {

/// A pixel of a row.
struct RowPixel {
  std::uint32_t inside;  ///< distance in pixels from the row's left end, `bits` fraction bits
  std::uint32_t width;   ///< of the row in pixels, `bits` fraction bits; raw value at least 1
  int bits;              ///< 16, or 32 for rows shorter than a pixel
};

/// The first pixel of a row.
[[nodiscard]] constexpr RowPixel row_pixel(const RowStart& start) {
  if ((start.width >> 32) != 0) {
    return {start.fraction + (static_cast<std::uint32_t>(start.skipped) << 16),
            static_cast<std::uint32_t>(start.width >> 16), 16};
  }
  const auto narrow = static_cast<std::uint32_t>(start.width);
  return {start.fine, narrow | static_cast<std::uint32_t>(narrow == 0), 32};
}

}  // namespace arcspan::literature
