// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace arcspan::tools {

/// A picture with 8 bits a channel, rows from top to bottom.
struct Image {
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::vector<Rgb8> pixels;

  Image() = default;
  Image(std::int32_t w, std::int32_t h) : width(w), height(h), pixels(area(w, h)) {}

  [[nodiscard]] Rgb8& at(std::int32_t x, std::int32_t y) { return pixels[area(width, y) + as_size(x)]; }
  [[nodiscard]] Rgb8 at(std::int32_t x, std::int32_t y) const { return pixels[area(width, y) + as_size(x)]; }
  /// The pixels of row y, 0...height - 1.
  [[nodiscard]] std::span<Rgb8> row(std::int32_t y) {
    return std::span(pixels).subspan(area(width, y), as_size(width));
  }
  friend bool operator==(const Image&, const Image&) = default;

 private:
  static std::size_t as_size(std::int32_t v) { return static_cast<std::size_t>(v); }
  static std::size_t area(std::int32_t w, std::int32_t h) { return as_size(w) * as_size(h); }
};

}  // namespace arcspan::tools
