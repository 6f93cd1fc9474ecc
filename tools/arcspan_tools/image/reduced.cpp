// SPDX-License-Identifier: MIT
#include <arcspan_tools/image/reduced.hpp>

#include <array>

namespace arcspan::tools {
namespace {

Rgb8 mean_at(const Image& image, std::int32_t left, std::int32_t top, std::int32_t n) {
  std::array<std::int32_t, 3> sum{};
  for (std::int32_t y = top; y < top + n; ++y) {
    for (std::int32_t x = left; x < left + n; ++x) {
      const Rgb8 c = image.at(x, y);
      sum[0] += c.r;
      sum[1] += c.g;
      sum[2] += c.b;
    }
  }
  const auto mean = [n](std::int32_t v) { return static_cast<std::uint8_t>((v + n * n / 2) / (n * n)); };
  return {mean(sum[0]), mean(sum[1]), mean(sum[2])};
}

}  // namespace

Image reduced(const Image& image, std::int32_t n) {
  Image result(image.width / n, image.height / n);
  for (std::int32_t y = 0; y < result.height; ++y) {
    for (std::int32_t x = 0; x < result.width; ++x) result.at(x, y) = mean_at(image, n * x, n * y, n);
  }
  return result;
}

}  // namespace arcspan::tools
