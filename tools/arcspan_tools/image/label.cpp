// SPDX-License-Identifier: MIT
#include <arcspan_tools/image/label.hpp>
#include <stb/stb_easy_font.h>

#include <algorithm>

namespace arcspan::tools {
namespace {

/// A quad of stb_easy_font, always an upright rectangle.
struct Quad {
  struct Corner {
    float x;
    float y;
    float z;
    unsigned char colour[4];
  };
  Corner corners[4];
};

std::int32_t whole(float v) { return static_cast<std::int32_t>(v); }

}  // namespace

std::int32_t text_width(std::string text, std::int32_t scale) {
  return scale * stb_easy_font_width(text.data());
}

void fill(Image& image, std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height,
          Rgb8 colour) {
  for (std::int32_t row = std::max(y, 0); row < std::min(y + height, image.height); ++row) {
    for (std::int32_t column = std::max(x, 0); column < std::min(x + width, image.width); ++column) {
      image.at(column, row) = colour;
    }
  }
}

void draw_text(Image& image, std::int32_t x, std::int32_t y, std::string text, std::int32_t scale,
               Rgb8 colour) {
  // On average a character takes 270 bytes (the header's estimate), about 17 quads at most.
  std::vector<Quad> quads(text.size() * 20);
  const int count = stb_easy_font_print(0, 0, text.data(), nullptr, quads.data(),
                                        static_cast<int>(quads.size() * sizeof(Quad)));
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const Quad::Corner& from = quads[i].corners[0];
    const Quad::Corner& to = quads[i].corners[2];
    fill(image, x + scale * whole(from.x), y + scale * whole(from.y), scale * whole(to.x - from.x),
         scale * whole(to.y - from.y), colour);
  }
}

void paste(Image& image, const Image& part, std::int32_t x, std::int32_t y) {
  for (std::int32_t row = 0; row < part.height; ++row) {
    for (std::int32_t column = 0; column < part.width; ++column) {
      image.at(x + column, y + row) = part.at(column, row);
    }
  }
}

}  // namespace arcspan::tools
