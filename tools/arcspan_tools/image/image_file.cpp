// SPDX-License-Identifier: MIT
#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/image/netpbm.hpp>
#include <arcspan_tools/image/picture_checks.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>
#include <stb/stb_image_write.h>

#include <algorithm>

namespace arcspan::tools {
namespace {

std::string png(const Image& image) {
  static_assert(sizeof(Rgb8) == 3);
  std::string out;
  const auto append = [](void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
  };
  stbi_write_png_to_func(append, &out, image.width, image.height, 3, image.pixels.data(), image.width * 3);
  return out;
}

}  // namespace

ImageFormat image_format(const std::filesystem::path& path) {
  const std::string kind = output_kind(path, "png");
  if (kind == "ppm") return ImageFormat::kPpm;
  if (kind == "pgm") return ImageFormat::kPgm;
  if (kind == "png") return ImageFormat::kPng;
  throw Failure(path.string(), "a picture's name must end in .png, .ppm or .pgm");
}

std::string encode_image(const Image& image, ImageFormat format) {
  switch (format) {
    case ImageFormat::kPpm:
      return ppm(image);
    case ImageFormat::kPgm:
      return pgm(image);
    case ImageFormat::kPng:
      break;
  }
  return png(image);
}

void write_image(const Image& image, const std::filesystem::path& path, const std::string& summary) {
  write_whole_file(path, encode_image(image, image_format(path)), summary);
}

Image read_image(const std::filesystem::path& path) {
  const RgbaImage read = read_rgba(path);
  Image image(read.width, read.height);
  std::transform(read.pixels.begin(), read.pixels.end(), image.pixels.begin(), [](const Rgba8& c) {
    return Rgb8{c.r, c.g, c.b};
  });
  return image;
}

RgbaImage read_rgba(const std::filesystem::path& path) {
  return decode_rgba(read_whole_file(path, kMostPictureBytes), path.string());
}

}  // namespace arcspan::tools
