// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/framebuffer/pixel_layout.hpp>
#include <arcspan/pixel/rgb565.hpp>

#include <catch2/catch.hpp>

#include <array>

using namespace arcspan;
using namespace arcspan::linux_host;

namespace {

struct Kernel {
  fb_fix_screeninfo fixed{};
  fb_var_screeninfo variable{};
};

Kernel true_colour(unsigned bits, fb_bitfield red, fb_bitfield green, fb_bitfield blue,
                   fb_bitfield alpha = {}) {
  Kernel kernel;
  kernel.fixed.type = FB_TYPE_PACKED_PIXELS;
  kernel.fixed.visual = FB_VISUAL_TRUECOLOR;
  kernel.variable.bits_per_pixel = bits;
  kernel.variable.red = red;
  kernel.variable.green = green;
  kernel.variable.blue = blue;
  kernel.variable.transp = alpha;
  return kernel;
}

Kernel other(unsigned visual, unsigned bits, unsigned grayscale = 0) {
  Kernel kernel;
  kernel.fixed.type = FB_TYPE_PACKED_PIXELS;
  kernel.fixed.visual = visual;
  kernel.variable.bits_per_pixel = bits;
  kernel.variable.grayscale = grayscale;
  return kernel;
}

PixelLayout layout_of(const Kernel& kernel) {
  PixelLayout layout;
  const Result result = PixelLayout::from_kernel(kernel.fixed, kernel.variable, layout);
  INFO(result.text());
  REQUIRE(ok(result));
  return layout;
}

std::string refusal(const Kernel& kernel) {
  PixelLayout layout;
  const Result result = PixelLayout::from_kernel(kernel.fixed, kernel.variable, layout);
  return ok(result) ? "(taken)" : result.text();
}

const Kernel kRgb565 = true_colour(16, {11, 5, 0}, {5, 6, 0}, {0, 5, 0});
const Kernel kXrgb = true_colour(32, {16, 8, 0}, {8, 8, 0}, {0, 8, 0});

}  // namespace

TEST_CASE("a 5-6-5 layout encodes and decodes as the pipeline's rgb565") {
  const PixelLayout layout = layout_of(kRgb565);
  CHECK(layout.pipeline_format() == std::string("rgb565"));
  CHECK(layout.bytes_per_row(7) == 14);
  for (unsigned code = 0; code < 65536; ++code) {
    const Rgb8 colour = Rgb565::decode(static_cast<Rgb565::Encoded>(code));
    if (layout.encode(colour) != code || layout.decode(code) != colour) FAIL("code " << code);
  }
}

TEST_CASE("channels go where the kernel says, alpha is full") {
  const Rgb8 colour{0x12, 0x34, 0x56};
  CHECK(layout_of(kXrgb).encode(colour) == 0x00123456);
  CHECK(layout_of(true_colour(32, {16, 8, 0}, {8, 8, 0}, {0, 8, 0}, {24, 8, 0})).encode(colour) ==
        0xFF123456);
  CHECK(layout_of(true_colour(32, {0, 8, 0}, {8, 8, 0}, {16, 8, 0})).encode(colour) == 0x00563412);
  CHECK(layout_of(true_colour(32, {24, 8, 0}, {16, 8, 0}, {8, 8, 0}, {0, 8, 0})).encode(colour) ==
        0x123456FF);
  CHECK(layout_of(true_colour(24, {16, 8, 0}, {8, 8, 0}, {0, 8, 0})).encode(colour) == 0x123456);
  CHECK(layout_of(true_colour(16, {10, 5, 0}, {5, 5, 0}, {0, 5, 0}, {15, 1, 0})).encode({255, 0, 8}) ==
        0xFC01);
  CHECK(layout_of(true_colour(16, {0, 5, 0}, {5, 6, 0}, {11, 5, 0})).encode({255, 0, 0}) == 0x001F);
  CHECK(layout_of(other(FB_VISUAL_PSEUDOCOLOR, 8)).encode({255, 0x60, 0x80}) == 0xEE);
  CHECK(layout_of(other(FB_VISUAL_STATIC_PSEUDOCOLOR, 8, 1)).encode({9, 9, 9}) == 9);
  CHECK(layout_of(other(FB_VISUAL_MONO10, 1)).encode({255, 255, 255}) == 1);
  CHECK(layout_of(other(FB_VISUAL_MONO01, 1)).encode({255, 255, 255}) == 0);
}

TEST_CASE("a pixel is stored alone and read back, in every layout") {
  const Kernel kernels[] = {kRgb565,
                            kXrgb,
                            true_colour(24, {0, 8, 0}, {8, 8, 0}, {16, 8, 0}),
                            true_colour(16, {10, 5, 0}, {5, 5, 0}, {0, 5, 0}),
                            true_colour(32, {20, 6, 0}, {10, 6, 0}, {0, 6, 0}),
                            other(FB_VISUAL_PSEUDOCOLOR, 8),
                            other(FB_VISUAL_TRUECOLOR, 8, 1),
                            other(FB_VISUAL_MONO01, 1),
                            other(FB_VISUAL_MONO10, 1)};
  constexpr std::size_t kPixels = 19;
  for (const Kernel& kernel : kernels) {
    const PixelLayout layout = layout_of(kernel);
    CAPTURE(int{layout.bits}, int(layout.kind));
    for (const Rgb8 colour : {Rgb8{0, 0, 0}, Rgb8{255, 255, 255}, Rgb8{200, 100, 50}}) {
      for (std::size_t x = 0; x < kPixels; ++x) {
        for (const int before : {0, 255}) {
          std::array<std::uint8_t, kPixels * 4 + 1> row;
          row.fill(static_cast<std::uint8_t>(before));
          const auto others = row;
          layout.store(row.data(), x, colour);
          CHECK(layout.load(row.data(), x) == layout.decode(layout.encode(colour)));
          for (std::size_t i = 0; i < kPixels; ++i) {
            if (i != x && layout.load(row.data(), i) != layout.load(others.data(), i)) FAIL("pixel " << i);
          }
          CHECK(row.back() == before);
        }
      }
    }
    for (const std::uint8_t full : {std::uint8_t{0}, std::uint8_t{255}}) {
      CHECK(layout.decode(layout.encode({full, full, full})) == Rgb8{full, full, full});
    }
  }
}

TEST_CASE("the leftmost of eight mono pixels is the lowest bit") {
  const PixelLayout layout = layout_of(other(FB_VISUAL_MONO10, 1));
  std::uint8_t row[2] = {};
  layout.store(row, 0, {255, 255, 255});
  layout.store(row, 9, {255, 255, 255});
  CHECK(row[0] == 0x01);
  CHECK(row[1] == 0x02);
  CHECK(layout.bytes_per_row(9) == 2);
}

TEST_CASE("a layout that cannot be drawn is refused with the reason") {
  Kernel kernel = kRgb565;
  kernel.fixed.type = FB_TYPE_PLANES;
  CHECK(refusal(kernel) == "pixels do not lie packed, row by row");
  kernel = kRgb565;
  kernel.variable.nonstd = 1;
  CHECK(refusal(kernel) == "the pixel format is not standard");
  kernel = kRgb565;
  kernel.variable.grayscale = 0x32595559;  // a FOURCC
  CHECK(refusal(kernel) == "the pixel format is not standard");
  CHECK(refusal(other(FB_VISUAL_DIRECTCOLOR, 32)).substr(0, 22) == "the visual is none of ");
  CHECK(refusal(other(FB_VISUAL_TRUECOLOR, 4)) == "colour pixels are neither 16, 24 nor 32 bits");
  CHECK(refusal(other(FB_VISUAL_TRUECOLOR, 0x110)) == "colour pixels are neither 16, 24 nor 32 bits");
  const std::string channels = "colour channels are not 1 to 8 bits inside the pixel";
  CHECK(refusal(true_colour(32, {20, 10, 0}, {10, 10, 0}, {0, 10, 0})) == channels);
  CHECK(refusal(true_colour(16, {11, 5, 1}, {5, 6, 0}, {0, 5, 0})) == channels);
  CHECK(refusal(true_colour(16, {12, 5, 0}, {5, 6, 0}, {0, 5, 0})) == channels);
  CHECK(refusal(true_colour(16, {0xFFFFFFFF, 5, 0}, {5, 6, 0}, {0, 5, 0})) == channels);
  CHECK(refusal(true_colour(16, {11, 0, 0}, {5, 6, 0}, {0, 5, 0})) == channels);
}
