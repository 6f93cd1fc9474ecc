// SPDX-License-Identifier: MIT
#include <arcspan_tools/image/side_by_side.hpp>

namespace arcspan::tools {

Image side_by_side(const Image& left, const Image& right) {
  Image out(left.width + right.width, left.height);
  for (std::int32_t y = 0; y < out.height; ++y) {
    for (std::int32_t x = 0; x < left.width; ++x) out.at(x, y) = left.at(x, y);
    for (std::int32_t x = 0; x < right.width; ++x) out.at(left.width + x, y) = right.at(x, y);
  }
  return out;
}

}  // namespace arcspan::tools
