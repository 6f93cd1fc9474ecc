// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/pixel/spread_rgb565.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan::detail {

/// The opaque pixel with a share of `share` / 32 of `other`, 0...32, and the rest of `pixel`, as the format
/// shows it: in Mono each is black or white, and so is the mixture.
template <PixelFormat F>
[[nodiscard]] ARCSPAN_INLINE constexpr typename F::Encoded mixed_pixels(typename F::Encoded pixel,
                                                                        typename F::Encoded other,
                                                                        std::uint32_t share) {
  if constexpr (Rgb565Words<F>) {
    return F::word565(joined(mixed_spread(spread(F::word565(pixel)), spread(F::word565(other)), share)));
  } else {
    if (share == 32) return other;  // most pixels of letters
    const auto mixed = [share](std::uint32_t a, std::uint32_t b) {
      return static_cast<std::uint8_t>((a * (32 - share) + b * share + 16) >> 5);
    };
    const Rgb8 a = F::decode(pixel);
    const Rgb8 b = F::decode(other);
    return F::encode(Rgb8{mixed(a.r, b.r), mixed(a.g, b.g), mixed(a.b, b.b)});
  }
}

}  // namespace arcspan::detail
