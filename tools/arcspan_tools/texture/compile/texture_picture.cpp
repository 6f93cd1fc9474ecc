// SPDX-License-Identifier: MIT
#include <arcspan_tools/image/label.hpp>
#include <arcspan_tools/texture/compile/texture_picture.hpp>

#include <algorithm>

namespace arcspan::tools {
namespace {

constexpr std::int32_t kPictureGap = 8;

Image magnified(const Image& image, std::int32_t times) {
  Image out(image.width * times, image.height * times);
  for (std::int32_t y = 0; y < out.height; ++y) {
    for (std::int32_t x = 0; x < out.width; ++x) out.at(x, y) = image.at(x / times, y / times);
  }
  return out;
}

}  // namespace

Image before_and_after(const TextureAndLevels& made) {
  constexpr std::int32_t kLeastSide = 256;
  const RgbaImage& picture = made.levels[0];
  const std::int32_t times = std::max(kLeastSide / std::max(picture.width, picture.height), 1);
  const auto shown = [times](const RgbaImage& image) { return magnified(on_squares(image), times); };
  const std::int32_t width = picture.width * times;
  const std::int32_t height = picture.height * times;
  const bool has_levels = made.texture.size.levels > 1;
  // Together, the levels below the first are not as high as it is.
  Image out(2 * width + kPictureGap + (has_levels ? kPictureGap + width / 2 : 0), height);
  paste(out, shown(picture), 0, 0);
  paste(out, shown(drawn_level(made.texture, 0)), width + kPictureGap, 0);
  std::int32_t y = 0;
  for (unsigned i = 1; i < made.texture.size.levels; ++i) {
    const Image level = shown(drawn_level(made.texture, i));
    paste(out, level, 2 * (width + kPictureGap), y);
    y += level.height;
  }
  return out;
}

}  // namespace arcspan::tools
