// SPDX-License-Identifier: MIT
#include <arcspan_tools/image/image.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <memory>

namespace arcspan::tools {
namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{1} << 30;

std::string png(const Image& image) {
  static_assert(sizeof(Rgb8) == 3);
  std::string out;
  const auto append = [](void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
  };
  stbi_write_png_to_func(append, &out, image.width, image.height, 3, image.pixels.data(), image.width * 3);
  return out;
}

std::string netpbm_header(const char* kind, const Image& image) {
  return std::string(kind) + "\n" + std::to_string(image.width) + " " + std::to_string(image.height) +
         "\n255\n";
}

std::string ppm(const Image& image) {
  std::string out = netpbm_header("P6", image);
  for (const Rgb8& p : image.pixels) {
    for (const std::uint8_t channel : {p.r, p.g, p.b}) out.push_back(static_cast<char>(channel));
  }
  return out;
}

std::string pgm(const Image& image) {
  std::string out = netpbm_header("P5", image);
  for (const Rgb8& p : image.pixels) out.push_back(static_cast<char>(luma(p)));
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

void write_image(const Image& image, const std::filesystem::path& path) {
  write_whole_file(path, encode_image(image, image_format(path)));
}

Image read_image(const std::filesystem::path& path) {
  const std::string bytes = read_whole_file(path, kMaxFileBytes);
  int width = 0;
  int height = 0;
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> decoded(
      stbi_load_from_memory(data, static_cast<int>(bytes.size()), &width, &height, nullptr, 3),
      &stbi_image_free);
  if (decoded == nullptr) {
    throw Failure(path.string(),
                  std::string("not a PNG, PPM or PGM picture (") + stbi_failure_reason() + ")");
  }
  Image image(width, height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = {decoded.get()[3 * i], decoded.get()[3 * i + 1], decoded.get()[3 * i + 2]};
  }
  return image;
}

}  // namespace arcspan::tools
