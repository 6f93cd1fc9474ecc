// SPDX-License-Identifier: MIT
// Textures made of pictures, and the pictures that they are made of.
#include <arcspan_tools/output/texture_writer.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/texture/compile/make_texture.hpp>
#include <arcspan_tools/texture/compile/texture_error.hpp>
#include <catch2/catch.hpp>
#include <stb/stb_image_write.h>
#include <tests/tools/temporary_folder.hpp>
#include <tiles.hpp>  // made by the build from models/tiles.ppm

#include <cmath>
#include <cstdlib>
#include <string>

using namespace arcspan;
using namespace arcspan::tools;
using arcspan::test::message_of;

namespace {

/// A picture without two equal texels, partly transparent.
RgbaImage shades(std::int32_t width, std::int32_t height) {
  RgbaImage image(width, height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const auto x = static_cast<std::uint32_t>(i) % static_cast<std::uint32_t>(width);
    const auto y = static_cast<std::uint32_t>(i) / static_cast<std::uint32_t>(width);
    image.pixels[i] = {static_cast<std::uint8_t>(7 * x), static_cast<std::uint8_t>(5 * y),
                       static_cast<std::uint8_t>(3 * (x + y)), static_cast<std::uint8_t>(255 - 4 * x)};
  }
  return image;
}

void append_bytes(void* to, void* data, int size) {
  static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

TextureOptions as(const char* format) { return {find_texture_format(format).value()}; }

std::vector<Rgba8> half_size(const TextureOptions& options, const RgbaImage& picture) {
  return make_texture(picture, options, "test").levels[1].pixels;
}

/// The colour and the opacity that the library reads at each texel of all levels.
template <TexelFormat Texels>
void check_library_reads(const MadeTexture& made) {
  const std::string file = texture_binary_file(made);
  // A copy, for the alignment that a string need not have.
  const std::vector<std::uint8_t> bytes(file.begin(), file.end());
  Texture<Texels> texture;
  REQUIRE(ok(view_texture_binary(bytes, texture)));
  CHECK(texture.size() == made.size);
  CHECK(texture.sampler() == made.sampler);
  for (unsigned level = 0; level < made.size.levels; ++level) {
    const RgbaImage drawn = drawn_level(made, level);
    const typename Texels::Word* words = texture.at(made.size.texels(level));
    bool same = true;
    for (std::size_t i = 0; i < drawn.pixels.size(); ++i) {
      const std::uint16_t stored = Texels::stored(words, texture.palette(), static_cast<std::uint32_t>(i));
      const std::uint16_t rgb565 = Texels::ColourFormat::rgb565(stored);
      const Rgba8 c = drawn.pixels[i];
      same = same && c.r >> 3 == rgb565 >> 11 && c.g >> 2 == ((rgb565 >> 5) & 63) &&
             c.b >> 3 == (rgb565 & 31) &&
             static_cast<std::uint32_t>(c.a + 8) / 16 == Texels::ColourFormat::alpha(stored);
    }
    CHECK(same);
  }
}

}  // namespace

TEST_CASE("pictures of each kind are read with their opacity, and refused when they are truncated") {
  const RgbaImage image = shades(20, 12);
  const void* data = image.pixels.data();
  std::string file;
  std::string name = "a.png";
  SECTION("PNG") { stbi_write_png_to_func(append_bytes, &file, 20, 12, 4, data, 80); }
  SECTION("TGA with run lengths") {
    name = "a.TGA";
    stbi_write_tga_to_func(append_bytes, &file, 20, 12, 4, data);
  }
  SECTION("TGA") {
    name = "a.tga";
    stbi_write_tga_with_rle = 0;
    stbi_write_tga_to_func(append_bytes, &file, 20, 12, 4, data);
    stbi_write_tga_with_rle = 1;
  }
  SECTION("BMP") { stbi_write_bmp_to_func(append_bytes, &file, 20, 12, 4, data); }
  CHECK(decode_rgba(file, name) == image);
  for (std::size_t size = 20; size < file.size(); ++size) {
    CAPTURE(size);
    CHECK(message_of<Failure>([&] { (void)decode_rgba(file.substr(0, size), name); }).find("truncated") !=
          std::string::npos);
  }
}

TEST_CASE("a TGA whose rows run from right to left is refused, not mirrored") {
  std::string file;
  stbi_write_tga_to_func(append_bytes, &file, 20, 12, 4, shades(20, 12).pixels.data());
  file[17] = static_cast<char>(file[17] | 16);
  CHECK(message_of<Failure>([&] { (void)decode_rgba(file, "a.tga"); }) ==
        "a.tga: a TGA picture with rows from right to left, which cannot be read");
}

TEST_CASE("a JPEG is read, and refused when it is truncated") {
  RgbaImage image = shades(32, 32);
  for (Rgba8& c : image.pixels) c.a = 255;
  std::string file;
  stbi_write_jpg_to_func(append_bytes, &file, 32, 32, 4, image.pixels.data(), 100);
  const TextureError error = texture_error(image, decode_rgba(file, "a.jpg"));
  CHECK(error.mean < 3);
  for (std::size_t size = 3; size < file.size(); size += 5) {
    CHECK(message_of<Failure>([&] { (void)decode_rgba(file.substr(0, size), "a.jpg"); }) ==
          "a.jpg: a truncated JPEG picture");
  }
  CHECK(message_of<Failure>([] { (void)decode_rgba("GIF89a", "a.gif"); }) ==
        "a.gif: not a PNG, JPEG, BMP, TGA, PPM (P6) or PGM (P5) picture");
}

TEST_CASE("a stored colour is the nearest that its format has") {
  const unsigned alpha_bits = GENERATE(0u, 1u, 4u);
  for (int value = 0; value < 256; ++value) {
    const auto v = static_cast<std::uint8_t>(value);
    const Rgba8 drawn = drawn_colour(stored_colour({v, v, v, v}, alpha_bits), alpha_bits);
    // The largest steps between two levels that are drawn.
    const int step = alpha_bits == 4 ? 25 : 9;
    const int green = alpha_bits == 0 ? 5 : alpha_bits == 1 ? 13 : 25;
    CHECK(std::abs(drawn.r - value) <= step / 2);
    CHECK(std::abs(drawn.b - value) <= step / 2);
    CHECK(std::abs(drawn.g - value) <= green / 2);
    if (alpha_bits == 0) CHECK(drawn.a == 255);
    if (alpha_bits == 1) CHECK(drawn.a == (value >= 128 ? 255 : 0));
    if (alpha_bits == 4) CHECK(std::abs(drawn.a - value) <= 16);
  }
  for (const std::uint8_t v : {std::uint8_t{0}, std::uint8_t{255}}) {
    CHECK(drawn_colour(stored_colour({v, v, v, 255}, alpha_bits), alpha_bits) == Rgba8{v, v, v, 255});
  }
}

TEST_CASE("the library reads the texels that were made, in every format and on every level") {
  const RgbaImage picture = shades(32, 16);
  const auto made = [&picture](const char* format) {
    TextureOptions options = as(format);
    options.levels = 0;
    options.dither = true;
    return make_texture(picture, options, "test").texture;
  };
  check_library_reads<DirectTexels<>>(made("rgb565"));
  check_library_reads<DirectTexels<Alpha1Colour>>(made("rgba5551"));
  check_library_reads<DirectTexels<Alpha4Colour>>(made("rgba4444"));
  check_library_reads<Palette8Texels<>>(made("pal8"));
  check_library_reads<Palette8Texels<Alpha1Colour>>(made("pal8-5551"));
  check_library_reads<Palette8Texels<Alpha4Colour>>(made("pal8-4444"));
  check_library_reads<Palette4Texels<>>(made("pal4"));
  check_library_reads<Palette4Texels<Alpha1Colour>>(made("pal4-5551"));
  check_library_reads<Palette4Texels<Alpha4Colour>>(made("pal4-4444"));
  check_library_reads<GrayTexels>(made("gray"));
}

TEST_CASE("levels are averaged in linear light, weighted by opacity") {
  RgbaImage picture(8, 8);
  for (std::size_t i = 0; i < 64; ++i) picture.pixels[i] = i % 2 == 0 ? Rgba8{255, 255, 255, 255} : Rgba8{};
  TextureOptions options = as("rgba4444");
  options.levels = 2;
  // Half of the light of white is 188 in sRGB.
  for (const Rgba8 c : half_size(options, picture)) CHECK(c.r == 188);
  for (std::size_t i = 1; i < 64; i += 2) picture.pixels[i] = {255, 0, 0, 0};
  for (const Rgba8 c : half_size(options, picture)) {
    CHECK(c.g == 255);  // the red that nobody sees has no share
    CHECK(c.a == 128);
  }
}

TEST_CASE("the edges of a picture are filtered as the texture is used") {
  RgbaImage picture(8, 64);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    const bool top = i < picture.pixels.size() / 2;
    picture.pixels[i] = top ? Rgba8{0, 0, 0, 255} : Rgba8{255, 255, 255, 255};
  }
  TextureOptions options = as("rgb565");
  options.size = Size{8, 8};
  CHECK(make_texture(picture, options, "test").levels[0].at(0, 0).r > 10);  // the white of the other end
  for (const TextureWrap wrap : {TextureWrap::kClamp, TextureWrap::kMirror}) {
    options.sampler = {TextureWrap::kRepeat, wrap, TextureFilter::kBilinear};
    CHECK(make_texture(picture, options, "test").levels[0].at(0, 0).r == 0);
    check_library_reads<DirectTexels<>>(make_texture(picture, options, "test").texture);
  }
  options.sampler = {TextureWrap::kClamp, TextureWrap::kRepeat};
  CHECK(make_texture(picture, options, "test").levels[0].at(0, 0).r > 10);
}

TEST_CASE("a mirrored picture with a side of one or two texels is resized without reading beside it") {
  const std::int32_t side = GENERATE(1, 2, 3);
  TextureOptions options = as("rgb565");
  options.size = Size{64, 64};
  options.sampler = {TextureWrap::kMirror, TextureWrap::kMirror};
  for (const Size size : {Size{33, side}, Size{side, 33}}) {
    RgbaImage picture(size.width, size.height);
    for (Rgba8& c : picture.pixels) c = {255, 0, 0, 255};
    const TextureAndLevels made = make_texture(picture, options, "test");
    for (const Rgba8 c : made.levels[0].pixels) CHECK(c == Rgba8{255, 0, 0, 255});
  }
}

TEST_CASE("a row of few texels keeps their colours where it is enlarged") {
  const std::int32_t width = GENERATE(4, 16);
  RgbaImage picture(width, 1);
  for (std::int32_t x = 0; x < width; ++x)
    picture.pixels[static_cast<std::size_t>(x)] = x % 3 == 0 ? Rgba8{255, 0, 0, 255} : Rgba8{0, 0, 255, 255};
  for (const TextureFilter filter : {TextureFilter::kNearest, TextureFilter::kBilinear}) {
    if (width < 8 && filter == TextureFilter::kBilinear) continue;  // which mixes neighbours anyway
    TextureOptions options = as("rgb565");
    options.sampler = {TextureWrap::kRepeat, TextureWrap::kRepeat, filter};
    const RgbaImage level = make_texture(picture, options, "test").levels[0];
    REQUIRE(level.height == 8);
    for (std::int32_t y = 0; y < level.height; ++y) {
      for (std::int32_t x = 0; x < level.width; ++x)
        CHECK(level.at(x, y) == picture.at(x * width / level.width, 0));
    }
  }
}

TEST_CASE("a palette holds the colours of the picture, if it can; otherwise they are chosen") {
  RgbaImage picture(16, 16);
  for (std::size_t i = 0; i < 256; ++i) {
    const auto level = static_cast<std::uint16_t>((i % 16) * 0x0841);
    picture.pixels[i] = drawn_colour(level, 0);
  }
  TextureOptions options = as("pal4");
  options.exact = true;
  const TextureAndLevels sixteen = make_texture(picture, options, "test");
  CHECK(drawn_level(sixteen.texture, 0) == picture);
  CHECK(std::isinf(texture_error(picture, drawn_level(sixteen.texture, 0)).psnr));
  picture.pixels[77] = {255, 0, 0, 255};
  CHECK(message_of<Failure>([&] { (void)make_texture(picture, options, "test"); }) ==
        "test: has 17 colours, and pal4 holds 16");
  options.exact = false;
  const TextureAndLevels chosen = make_texture(picture, options, "test");
  CHECK(chosen.texture.palette.size() == 16);
  const TextureError error = texture_error(picture, drawn_level(chosen.texture, 0));
  CHECK(error.psnr > 35);
  CHECK(error.largest > 0);
}

TEST_CASE("what is fully transparent stays so in a palette") {
  const RgbaImage picture = [] {
    RgbaImage image = shades(64, 64);
    for (std::size_t i = 0; i < image.pixels.size() / 8; ++i) image.pixels[i].a = 0;
    return image;
  }();
  const MadeTexture made = make_texture(picture, as("pal4-4444"), "test").texture;
  const RgbaImage drawn = drawn_level(made, 0);
  for (std::size_t i = 0; i < drawn.pixels.size() / 8; ++i) CHECK(drawn.pixels[i].a == 0);
}

TEST_CASE("dithering keeps the mean of what lies between two colours") {
  RgbaImage picture(16, 16);
  for (Rgba8& c : picture.pixels) c = {100, 130, 61, 255};
  TextureOptions options = as(GENERATE("rgb565", "rgba5551", "rgba4444"));
  const auto mean_error = [&](bool dither) {
    options.dither = dither;
    const RgbaImage drawn = drawn_level(make_texture(picture, options, "test").texture, 0);
    double sum = 0;
    for (const Rgba8 c : drawn.pixels) sum += c.r - 100;
    return std::abs(sum / 256);
  };
  CHECK(mean_error(true) < 2.6);  // 0.3 without alpha; steps of 4 bits are drawn in unequal widths
  CHECK(mean_error(true) < mean_error(false));
}

TEST_CASE("sizes and levels that do not exist are refused") {
  const RgbaImage picture = shades(20, 100);
  TextureOptions options = as("rgb565");
  const TextureSize nearest = make_texture(picture, options, "test").texture.size;
  CHECK(nearest == TextureSize{4, 7, 1});  // 16x128
  const auto message = [&](Size size, std::int32_t levels) {
    options.size = size;
    options.levels = levels;
    return message_of<Failure>([&] { (void)make_texture(picture, options, "test"); });
  };
  const std::string must = "test: a texture's side must be a power of two from 8 to 1024, not ";
  CHECK(message({64, 48}, 1) == must + "48");
  CHECK(message({4, 64}, 1) == must + "4");
  CHECK(message({2048, 64}, 1) == must + "2048");
  CHECK(message({16, 64}, 6) == "test: a texture of 16x64 has at most 5 levels, not 6");
  options.exact = true;
  CHECK(message({16, 64}, 1) == "test: is 20x100 and would have to be resized");
}

TEST_CASE("a generated header is a texture") {
  STATIC_REQUIRE(tiles::kTexture.size() == TextureSize{4, 3, 2});
  const auto colour = [](std::uint32_t i) {
    return Palette4Texels<>::stored(tiles::kTexture.at(0), tiles::kTexture.palette(), i);
  };
  CHECK(colour(0) == 0xF800);
  CHECK(colour(5) == 0x07E0);
  CHECK(colour(11) == 0x001F);
  CHECK(colour(15) == 0xFFFF);
  CHECK(colour(127) == 0);
}
