// SPDX-License-Identifier: MIT
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/pixel/rgb565.hpp>

#include <catch2/catch.hpp>

#include <array>

using namespace arcspan;
using hal::Framebuffer;

TEST_CASE("a framebuffer refuses memory that is too small") {
  std::array<std::uint8_t, 9> memory{};
  CHECK(Framebuffer<Gray4>(memory, 5, 3).status() == Status::kOk);
  CHECK(Framebuffer<Gray4>(memory, 5, 4).status() == Status::kBufferTooSmall);
  CHECK(Framebuffer<Gray4>(memory, -5, 3).status() == Status::kInvalidArgument);
  CHECK(Framebuffer<Gray4>(memory, 5, 4).bounds().empty());
}

TEST_CASE("a band keeps the rows it stands for") {
  std::array<std::uint16_t, 12> memory{};
  Framebuffer<Rgb565> band(memory, 4, 3, 6);
  CHECK(band.bounds() == Rect{0, 6, 4, 9});
  band.clear({255, 0, 0});
  auto cursor = band.open({7, 1, 2});
  cursor.write(Rgb565::encode({0, 255, 0}));
  CHECK(ok(band.close({7, 1, 2})));
  CHECK(band.pixel(1, 7) == Rgb8{0, 255, 0});
  CHECK(band.pixel(2, 7) == Rgb8{255, 0, 0});
  CHECK(memory[5] == 0x07E0);
}
