// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/image/image.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace arcspan::tools {

/// A colour in display values with its opacity, 255 being opaque.
struct Rgba8 {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  std::uint8_t a = 255;

  friend constexpr bool operator==(const Rgba8&, const Rgba8&) = default;
};

/// A picture with 8 bits a channel and opacity, rows from top to bottom. Colours are not multiplied by it.
struct RgbaImage {
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::vector<Rgba8> pixels;

  RgbaImage() = default;
  RgbaImage(std::int32_t w, std::int32_t h)
      : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

  [[nodiscard]] const Rgba8& at(std::int32_t x, std::int32_t y) const {
    return pixels[static_cast<std::size_t>(width) * static_cast<std::size_t>(y) +
                  static_cast<std::size_t>(x)];
  }
  friend bool operator==(const RgbaImage&, const RgbaImage&) = default;
};

/// The picture in the bytes of a PNG, JPEG, BMP, PPM or PGM file, or of a TGA file if `subject` ends in .tga.
/// Throws a Failure about `subject` for one that is damaged, truncated or of another kind.
[[nodiscard]] RgbaImage decode_rgba(std::string_view bytes, const std::string& subject);

/// `image` on a board of light and dark squares of 8 pixels, which show through where it is transparent.
[[nodiscard]] Image on_squares(const RgbaImage& image);

}  // namespace arcspan::tools
