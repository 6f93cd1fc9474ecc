// SPDX-License-Identifier: MIT
#include <arcspan_tools/image/difference.hpp>
#include <arcspan_tools/image/image_file.hpp>
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
  CHECK(complaint("P3\n1 1\n255\n1 2 3\n") == "not a PNG, PPM (P6) or PGM (P5) picture");
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
