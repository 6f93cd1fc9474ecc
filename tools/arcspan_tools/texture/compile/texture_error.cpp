// SPDX-License-Identifier: MIT
#include <arcspan_tools/texture/compile/texture_error.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace arcspan::tools {

TextureError texture_error(const RgbaImage& picture, const RgbaImage& drawn) {
  TextureError error;
  double squares = 0;
  double sum = 0;
  double count = 0;
  const auto add = [&](int a, int b) {
    const int e = std::abs(a - b);
    squares += e * e;
    sum += e;
    ++count;
    error.largest = std::max(error.largest, static_cast<std::uint8_t>(e));
  };
  const auto is_transparent = [](Rgba8 c) { return c.a < 255; };
  const bool has_alpha = std::any_of(picture.pixels.begin(), picture.pixels.end(), is_transparent) ||
                         std::any_of(drawn.pixels.begin(), drawn.pixels.end(), is_transparent);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    const Rgba8 a = picture.pixels[i];
    const Rgba8 b = drawn.pixels[i];
    if (has_alpha) add(a.a, b.a);
    if (a.a == 0 && b.a == 0) continue;
    add(a.r, b.r);
    add(a.g, b.g);
    add(a.b, b.b);
  }
  error.mean = sum / count;
  error.psnr = 10 * std::log10(255.0 * 255.0 * count / squares);
  return error;
}

}  // namespace arcspan::tools
