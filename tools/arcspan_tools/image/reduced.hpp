// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/image/image.hpp>

#include <cstdint>

namespace arcspan::tools {

/// The picture with the mean of each square of `n` by `n` pixels as one. Its sides are multiples of `n`, 1 or
/// more.
[[nodiscard]] Image reduced(const Image& image, std::int32_t n);

}  // namespace arcspan::tools
