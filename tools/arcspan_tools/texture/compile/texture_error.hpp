// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/image/rgba_image.hpp>

#include <cstdint>

namespace arcspan::tools {

/// How a texture differs from its picture, channel by channel in 8-bit units. Opacity counts as a channel;
/// colours of texels that are fully transparent in both do not count.
struct TextureError {
  double psnr = 0;  ///< 10 log10(255² / mean squared error) in dB; infinite if there is none
  double mean = 0;  ///< absolute
  std::uint8_t largest = 0;
};

/// Compares two pictures of one size.
[[nodiscard]] TextureError texture_error(const RgbaImage& picture, const RgbaImage& drawn);

}  // namespace arcspan::tools
