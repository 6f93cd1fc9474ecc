// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

namespace arcspan::tools {

/// A pixel format by its name in pixel_format_list.hpp, with ordered dither or without.
struct PixelChoice {
  std::string_view format;
  bool dithers = false;
};

/// Every pixel format without dither, then those with fewer than 8 bits per channel with it.
[[nodiscard]] std::span<const PixelChoice> pixel_choices();

}  // namespace arcspan::tools
