// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/pixel_format_list.hpp>

#include <concepts>
#include <string_view>

namespace arcspan::tools {

/// The name of a format of pixel_format_list.hpp.
template <PixelFormat Format>
[[nodiscard]] constexpr std::string_view pixel_format_name() {
#define ARCSPAN_NAME_IF_SAME(name, Listed) \
  if (std::same_as<Format, Listed>) return #name;
  ARCSPAN_FOR_EACH_PIXEL_FORMAT(ARCSPAN_NAME_IF_SAME)
#undef ARCSPAN_NAME_IF_SAME
}

}  // namespace arcspan::tools
