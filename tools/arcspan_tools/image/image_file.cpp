// SPDX-License-Identifier: MIT
#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/image/netpbm.hpp>
#include <arcspan_tools/image/picture_checks.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <memory>
#include <string_view>

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

Image read_png(std::string_view bytes, const std::string& subject) {
  check_png(bytes, subject);
  int width = 0;
  int height = 0;
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> decoded(
      stbi_load_from_memory(data, static_cast<int>(bytes.size()), &width, &height, nullptr, 3),
      &stbi_image_free);
  if (decoded == nullptr) {
    throw Failure(subject, std::string("a PNG picture that cannot be read (") + stbi_failure_reason() + ")");
  }
  Image image(width, height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = {decoded.get()[3 * i], decoded.get()[3 * i + 1], decoded.get()[3 * i + 2]};
  }
  return image;
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

void write_image(const Image& image, const std::filesystem::path& path) {
  write_whole_file(path, encode_image(image, image_format(path)));
}

Image read_image(const std::filesystem::path& path) {
  const std::string bytes = read_whole_file(path, kMostPictureBytes);
  if (is_netpbm(bytes)) return read_netpbm(bytes, path.string());
  if (is_png(bytes)) return read_png(bytes, path.string());
  throw Failure(path.string(), "not a PNG, PPM (P6) or PGM (P5) picture");
}

RgbaImage read_rgba(const std::filesystem::path& path) {
  return decode_rgba(read_whole_file(path, kMostPictureBytes), path.string());
}

}  // namespace arcspan::tools
