// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
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

/// The file formats that pictures are written in, by the extension of the name: .ppm (P6), .pgm (P5, luma),
/// .png (8-bit RGB). On standard output (`-`) a picture is a PNG; `ppm:-` and `pgm:-` are the others.
enum class ImageFormat : std::uint8_t { kPpm, kPgm, kPng };

/// The format that a file name asks for. Throws Failure for any other extension.
[[nodiscard]] ImageFormat image_format(const std::filesystem::path& path);

/// The whole file.
[[nodiscard]] std::string encode_image(const Image& image, ImageFormat format);

/// Writes `image` in the format of the path's extension, whole or not at all. Throws Failure.
void write_image(const Image& image, const std::filesystem::path& path);

/// Reads PNG, PPM or PGM. Throws Failure.
[[nodiscard]] Image read_image(const std::filesystem::path& path);

}  // namespace arcspan::tools
