// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/image/image.hpp>

namespace arcspan::tools {

/// Two pictures of one height next to each other.
[[nodiscard]] Image side_by_side(const Image& left, const Image& right);

}  // namespace arcspan::tools
