// SPDX-License-Identifier: MIT
#include <arcspan/mesh/crc32.hpp>

#include <arcspan_tools/image/difference.hpp>
#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/image/rgba_image.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <catch2/catch.hpp>
#include <tests/tools/temporary_folder.hpp>

using namespace arcspan;
using namespace arcspan::tools;
using namespace arcspan::test;

namespace {

Image gradient(std::int32_t width, std::int32_t height) {
  Image image(width, height);
  for (std::int32_t y = 0; y < height; ++y) {
    for (std::int32_t x = 0; x < width; ++x) {
      image.at(x, y) = {static_cast<std::uint8_t>(x * 16), static_cast<std::uint8_t>(y * 31),
                        static_cast<std::uint8_t>(x * y)};
    }
  }
  return image;
}

}  // namespace

TEST_CASE("PNG and PPM keep every pixel, PGM keeps the luma") {
  const TemporaryFolder folder;
  const Image image = gradient(13, 7);
  for (const char* name : {"a.png", "a.ppm", "a.PPM"}) {
    CAPTURE(name);
    write_image(image, folder / name);
    CHECK(read_image(folder / name) == image);
  }
  write_image(image, folder / "a.pgm");
  const Image grey = read_image(folder / "a.pgm");
  REQUIRE(grey.pixels.size() == image.pixels.size());
  for (std::size_t i = 0; i < grey.pixels.size(); ++i) {
    const std::uint8_t v = luma(image.pixels[i]);
    CHECK(grey.pixels[i] == Rgb8{v, v, v});
  }
}

TEST_CASE("the netpbm headers are as the formats ask, byte by byte") {
  Image image(2, 1);
  image.at(0, 0) = {'a', 'b', 'c'};
  image.at(1, 0) = {'d', 'e', 'f'};
  CHECK(encode_image(image, ImageFormat::kPpm) == "P6\n2 1\n255\nabcdef");
  image.at(1, 0) = {'z', 'z', 'z'};
  CHECK(encode_image(image, ImageFormat::kPgm) == "P5\n2 1\n255\nbz");
}

TEST_CASE("names of other kinds and files that are no pictures are refused") {
  const TemporaryFolder folder;
  CHECK(message_of<Failure>([] { (void)image_format("a.jpg"); }) ==
        "a.jpg: a picture's name must end in .png, .ppm or .pgm");
  CHECK_THROWS_AS(image_format("png"), Failure);
  CHECK_THROWS_AS(read_image(folder.file("a.png", "no picture")), Failure);
  CHECK_THROWS_AS(read_image(folder.file("empty.png", "")), Failure);
  CHECK_THROWS_AS(read_image(folder.file("b.ppm", "P6\n100000 100000\n255\n")), Failure);
  const std::string png = encode_image(gradient(9, 9), ImageFormat::kPng);
  CHECK_THROWS_AS(read_image(folder.file("c.png", png.substr(0, png.size() / 2))), Failure);
}

TEST_CASE("PPM and PGM: comments, maxima and 16 bits are read as the formats say") {
  const TemporaryFolder folder;
  const auto read = [&folder](const std::string& bytes) {
    return read_image(folder.file("a", bytes)).pixels;
  };
  CHECK(read("P6 2\t1\n255\nabcdef, and what follows the first picture") ==
        std::vector<Rgb8>{{'a', 'b', 'c'}, {'d', 'e', 'f'}});
  CHECK(read("P5#a 9 comment\n1 #2\r3\n255\nabc") ==
        std::vector<Rgb8>{{97, 97, 97}, {98, 98, 98}, {99, 99, 99}});
  CHECK(read(std::string("P6\n1 1\n100\n\0\x32\x64", 14)) == std::vector<Rgb8>{{0, 128, 255}});
  CHECK(read(std::string("P6\n1 1\n65535\n\0\0\x80\x80\xFF\xFF", 19)) == std::vector<Rgb8>{{0, 128, 255}});
}

TEST_CASE("every damaged PPM and PGM is refused with the reason") {
  const TemporaryFolder folder;
  const std::string path = folder / "a.ppm";
  const auto complaint = [&](const std::string& bytes) {
    const std::string message = message_of<Failure>([&] { (void)read_image(folder.file("a.ppm", bytes)); });
    return message.find(path + ": ") == 0 ? message.substr(path.size() + 2) : message;
  };
  const auto damaged = [&](const std::string& what) { return "a damaged PPM or PGM picture (" + what + ")"; };
  CHECK(complaint("P6\n4 4\n255\nabc") == "truncated (14 bytes of 59)");
  CHECK(complaint("P5\n100 100\n255\n") == "truncated (15 bytes of 10015)");
  CHECK(complaint("P5\n2 1\n256\nabc") == "truncated (14 bytes of 15)");
  CHECK(complaint("P6\n-1 1\n255\nabc") == damaged("width is not a number"));
  CHECK(complaint("P6\n1 0\n255\nabc") == damaged("height 0 out of range 1 to 16384"));
  CHECK(complaint("P6\n1 99999999999999999999\n255\nabc") ==
        damaged("height 999999999999 out of range 1 to 16384"));
  CHECK(complaint("P6\n1 1\n65536\nabc") == damaged("largest value 65536 out of range 1 to 65535"));
  CHECK(complaint("P6\n1 1\n255") == damaged("its header has no end"));
  CHECK(complaint("P6\n1 1\n") == damaged("largest value is not a number"));
  CHECK(complaint("P5\n1 1\n9\nz") == damaged("value 122 above the largest, 9"));
  CHECK(complaint("P3\n1 1\n255\n1 2 3\n") == "not a PNG, JPEG, BMP, TGA, PPM (P6) or PGM (P5) picture");
}

TEST_CASE("headers that lie are refused before anything is decoded") {
  const auto complaint = [](const std::string& bytes, const std::string& name = "a") {
    return message_of<Failure>([&] { (void)decode_rgba(bytes, name); });
  };
  const auto little = [](std::uint32_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(i < 4 ? value >> (8 * i) : 0);
    return text;
  };
  const auto bmp = [&](std::uint32_t width, std::uint32_t height) {
    return "BM" + little(0, 8) + little(54, 4) + little(40, 4) + little(width, 4) + little(height, 4) +
           little(1, 2) + little(24, 2) + little(0, 24) + std::string(64, '\x7F');
  };
  const auto tga = [&](std::uint32_t width, std::uint32_t height, int type = 2) {
    return std::string{0, 0, static_cast<char>(type)} + little(0, 9) + little(width, 2) + little(height, 2) +
           std::string{24, 0} + std::string(64, 1);
  };
  const auto jpeg = [](const std::string& segments) { return "\xFF\xD8" + segments + "\xFF\xD9"; };
  const auto frame = [](std::uint32_t width, std::uint32_t height) {
    const auto big = [](std::uint32_t v) {
      return std::string{static_cast<char>(v >> 8), static_cast<char>(v)};
    };
    return std::string("\xFF\xC0\0\x0B\x08", 5) + big(height) + big(width) + std::string("\1\1\x11\0", 4);
  };
  CHECK(decode_rgba(bmp(2, 2), "a").width == 2);
  CHECK(decode_rgba(bmp(2, 0xFFFFFFFEu), "a").height == 2);
  CHECK(complaint(bmp(0, 2)) == "a: a BMP picture of width 0");
  CHECK(complaint(bmp(2, 0)) == "a: a BMP picture of height 0");
  CHECK(complaint(bmp(0xFFFFFFFFu, 2)) == "a: a BMP picture of width -1");
  CHECK(complaint(bmp(16385, 1)) ==
        "a: a BMP picture of 16385x1 pixels, which is too large (the limits are 16384 in each direction and "
        "67108864 "
        "in all)");
  CHECK(complaint(bmp(2, 0x80000000u)).find("too large") != std::string::npos);
  std::string other = bmp(2, 2);
  other[14] = 16;
  CHECK(complaint(other) == "a: a damaged BMP picture (a header of 16 bytes)");
  CHECK(decode_rgba(tga(2, 2), "a.tga").width == 2);
  CHECK(complaint(tga(0, 2), "a.tga") == "a.tga: a TGA picture of width 0");
  CHECK(complaint(tga(2, 0, 10), "a.tga") == "a.tga: a TGA picture of height 0");
  CHECK(complaint("\xFF\xFF\xD8" + std::string(64, '\1'), "a.tga") ==
        "a.tga: a damaged TGA picture (its palette is of an unknown type)");
  CHECK(complaint(jpeg(frame(0, 8))) == "a: a JPEG picture of width 0");
  CHECK(complaint(jpeg(frame(8, 0))) == "a: a JPEG picture of height 0");
  CHECK(complaint(jpeg(frame(16384, 16384))).find("16384x16384 pixels, which is too large") !=
        std::string::npos);
  CHECK(complaint(jpeg("")) == "a: a damaged JPEG picture (it has no frame)");
  const auto huffman = [&](char most) {
    return jpeg(frame(8, 8) + std::string("\xFF\xC4\1\x13\0", 5) + std::string(15, 0) + most +
                std::string(256, 1));
  };
  CHECK(complaint(huffman('\xFF')).find("256") == std::string::npos);
  std::string large = huffman('\xFF');
  large[22] = 2;
  CHECK(complaint(large) == "a: a damaged JPEG picture (a Huffman table of 257 codes; the limit is 256)");
  CHECK(complaint("P6 16384 16384 255 ").find("too large (the limits are 16384") != std::string::npos);
}

namespace {

std::string chunk(const std::string& type, const std::string& data) {
  const auto big = [](std::uint32_t v) {
    return std::string{static_cast<char>(v >> 24), static_cast<char>(v >> 16), static_cast<char>(v >> 8),
                       static_cast<char>(v)};
  };
  const std::string checked = type + data;
  return big(static_cast<std::uint32_t>(data.size())) + checked +
         big(crc32({reinterpret_cast<const std::uint8_t*>(checked.data()), checked.size()}));
}

/// A PNG of red, green, blue and opacity, from `first` chunks and compressed data.
std::string png(const std::string& first, const std::string& size, const std::string& data) {
  return "\x89PNG\r\n\x1a\n" + first + chunk("IHDR", size + std::string("\x08\6\0\0\0", 5)) +
         chunk("IDAT", data) + chunk("IEND", "");
}

}  // namespace

TEST_CASE("a PNG that is too large, or unpacks to more than its size, is refused") {
  const std::string large("\0\0\x40\0\0\0\x40\0", 8);
  CHECK(message_of<Failure>([&] {
          (void)decode_rgba(png("", large, "x"), "a");
        }).find("a PNG picture of 16384x16384 pixels, which is too large") != std::string::npos);
  const std::string none("\0\0\0\0\0\0\0\1", 8);
  CHECK(message_of<Failure>([&] { (void)decode_rgba(png("", none, "x"), "a"); }) ==
        "a: a PNG picture of width 0");
  // One block of fixed codes: a 0, and then 258 copies of it per code of 13 bits, 2 MB in all.
  constexpr std::size_t kCodes = 8000;
  std::string bomb = std::string("\x78\x01\x63", 3) + std::string(2 * kCodes, '\0');
  for (std::size_t code = 0; code < kCodes; ++code) {
    // 258 is 11000101, the distance 1 is 00000.
    for (const std::size_t one : std::initializer_list<std::size_t>{0, 1, 5, 7}) {
      const std::size_t at = 27 + 13 * code + one;
      bomb[at / 8] = static_cast<char>(static_cast<unsigned char>(bomb[at / 8]) | (1u << (at % 8)));
    }
  }
  const std::string one("\0\0\0\1\0\0\0\1", 8);
  CHECK(message_of<Failure>([&] { (void)decode_rgba(png("", one, bomb), "a"); }) ==
        "a: a PNG picture that cannot be read (outofmem)");
}

TEST_CASE("a PNG of the Apple kind has its colours and opacity put right") {
  // Stored without a zlib header: blue, green, red, opacity, of which the second is multiplied by 100 / 255.
  const std::string data("\1\x09\0\xF6\xFF\0\x0A\x14\x1E\xFF\x14\x28\x3C\x64", 14);
  const std::string two("\0\0\0\2\0\0\0\1", 8);
  const RgbaImage image = decode_rgba(png(chunk("CgBI", std::string("\x50\0\x20\2", 4)), two, data), "a");
  CHECK(image.at(0, 0) == Rgba8{30, 20, 10, 255});
  CHECK(image.at(1, 0) == Rgba8{153, 102, 51, 100});
}

TEST_CASE("every byte of a PNG is protected by its checksums, and every cut is noticed") {
  const TemporaryFolder folder;
  const std::string png = encode_image(gradient(5, 3), ImageFormat::kPng);
  REQUIRE(read_image(folder.file("a.png", png)) == gradient(5, 3));
  for (std::size_t i = 0; i < png.size(); ++i) {
    CAPTURE(i);
    std::string changed = png;
    changed[i] = static_cast<char>(changed[i] ^ 4);
    CHECK_THROWS_AS(read_image(folder.file("b.png", changed)), Failure);
    CHECK_THROWS_AS(read_image(folder.file("c.png", png.substr(0, i))), Failure);
  }
}

TEST_CASE("squares are seen through what is transparent only") {
  RgbaImage image(2, 1);
  image.pixels = {{255, 254, 1, 255}, {255, 254, 1, 0}};
  const Image shown = on_squares(image);
  CHECK(shown.at(0, 0) == Rgb8{255, 254, 1});
  CHECK(shown.at(1, 0) == Rgb8{120, 120, 120});
}

TEST_CASE("a difference is measured per channel") {
  const Image a = gradient(8, 4);
  Image b = a;
  CHECK(difference(a, b).largest == 0);
  CHECK(difference(a, b).mean == 0.0);
  b.at(3, 2).g = static_cast<std::uint8_t>(b.at(3, 2).g - 5);
  b.at(5, 1).r = static_cast<std::uint8_t>(b.at(5, 1).r + 10);
  const Difference d = difference(a, b);
  CHECK(d.largest == 10);
  CHECK(d.mean == Approx(15.0 / (3 * 32)));
  CHECK(d.differing_pixels == 2);
  const Image picture = difference_picture(a, b);
  CHECK(picture.at(5, 1) == Rgb8{255, 0, 0});
  CHECK(picture.at(3, 2) == Rgb8{0, 127, 0});
  CHECK(picture.at(0, 0) == Rgb8{});
}
