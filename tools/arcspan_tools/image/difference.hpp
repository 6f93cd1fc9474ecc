// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/image/image.hpp>

namespace arcspan::tools {

/// How two pictures of one size differ, channel by channel in 8-bit units.
struct Difference {
  std::uint8_t largest = 0;
  /// Over all channels of all pixels.
  double mean = 0;
  std::size_t differing_pixels = 0;
};

[[nodiscard]] Difference difference(const Image& a, const Image& b);

/// A picture of the absolute differences, scaled so that the largest is full brightness; black where a and b
/// agree.
[[nodiscard]] Image difference_picture(const Image& a, const Image& b);

}  // namespace arcspan::tools
