// SPDX-License-Identifier: MIT
#include <arcspan_tools/image/difference.hpp>

#include <algorithm>
#include <cstdlib>

namespace arcspan::tools {
namespace {

std::uint8_t apart(std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>(std::abs(a - b)); }

Rgb8 apart(Rgb8 a, Rgb8 b) { return {apart(a.r, b.r), apart(a.g, b.g), apart(a.b, b.b)}; }

std::uint8_t scaled(std::uint8_t level, std::uint8_t largest) {
  return static_cast<std::uint8_t>(level * 255 / largest);
}

}  // namespace

Difference difference(const Image& a, const Image& b) {
  Difference result;
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const Rgb8 d = apart(a.pixels[i], b.pixels[i]);
    result.largest = std::max({result.largest, d.r, d.g, d.b});
    sum += std::uint64_t{d.r} + d.g + d.b;
    if (d != Rgb8{}) ++result.differing_pixels;
  }
  if (!a.pixels.empty())
    result.mean = static_cast<double>(sum) / (3.0 * static_cast<double>(a.pixels.size()));
  return result;
}

Image difference_picture(const Image& a, const Image& b) {
  Image out(a.width, a.height);
  const std::uint8_t largest = std::max<std::uint8_t>(difference(a, b).largest, 1);
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const Rgb8 d = apart(a.pixels[i], b.pixels[i]);
    out.pixels[i] = {scaled(d.r, largest), scaled(d.g, largest), scaled(d.b, largest)};
  }
  return out;
}

}  // namespace arcspan::tools
