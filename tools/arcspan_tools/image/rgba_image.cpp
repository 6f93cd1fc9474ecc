// SPDX-License-Identifier: MIT
#include <arcspan_tools/image/netpbm.hpp>
#include <arcspan_tools/image/picture_checks.hpp>
#include <arcspan_tools/image/rgba_image.hpp>
#include <arcspan_tools/image/stb_memory.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <stb/stb_image.h>

#include <algorithm>
#include <cstring>
#include <memory>

namespace arcspan::tools {
namespace {

RgbaImage decode_stb(std::string_view bytes, const PictureHeader& header, const std::string& subject) {
  // The picture itself with 16 bits a channel, or what it is unpacked from: never more.
  limit_stb_memory(8 * static_cast<std::size_t>(header.width * header.height) + 2 * bytes.size() +
                   (1u << 20));
  // Pictures for Apple's devices have red and blue exchanged, and colours multiplied by their opacity.
  stbi_convert_iphone_png_to_rgb(1);
  stbi_set_unpremultiply_on_load(1);
  int width = 0;
  int height = 0;
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> decoded(
      stbi_load_from_memory(data, static_cast<int>(bytes.size()), &width, &height, nullptr, 4),
      &stbi_image_free);
  if (decoded == nullptr) {
    throw Failure(subject, std::string("a ") + header.kind + " picture that cannot be read (" +
                               stbi_failure_reason() + ")");
  }
  static_assert(sizeof(Rgba8) == 4);
  RgbaImage image(width, height);
  std::memcpy(static_cast<void*>(image.pixels.data()), decoded.get(), 4 * image.pixels.size());
  return image;
}

}  // namespace

RgbaImage decode_rgba(std::string_view bytes, const std::string& subject) {
  if (!is_netpbm(bytes)) return decode_stb(bytes, checked_picture(bytes, subject), subject);
  const Image opaque = read_netpbm(bytes, subject);
  RgbaImage image(opaque.width, opaque.height);
  std::transform(opaque.pixels.begin(), opaque.pixels.end(), image.pixels.begin(), [](Rgb8 c) {
    return Rgba8{c.r, c.g, c.b, 255};
  });
  return image;
}

Image on_squares(const RgbaImage& image) {
  constexpr unsigned kLight = 200;
  constexpr unsigned kDark = 120;
  Image out(image.width, image.height);
  for (std::int32_t y = 0; y < image.height; ++y) {
    for (std::int32_t x = 0; x < image.width; ++x) {
      const unsigned behind = ((x ^ y) & 8) != 0 ? kLight : kDark;
      const Rgba8 c = image.at(x, y);
      const auto mixed = [&](unsigned channel) {
        return static_cast<std::uint8_t>((channel * c.a + behind * (255u - c.a) + 127) / 255);
      };
      out.at(x, y) = {mixed(c.r), mixed(c.g), mixed(c.b)};
    }
  }
  return out;
}

}  // namespace arcspan::tools
