// SPDX-License-Identifier: MIT
#include <arcspan/literature/colour_segment.hpp>
#include <arcspan/pixel/pixel_format_list.hpp>
#include <arcspan/pixel/pixel_operation.hpp>
#include <arcspan/span/draw_pixels.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

using namespace arcspan;

TEMPLATE_TEST_CASE("encode and decode keep black, white and every encoded colour", "", Rgb565, Rgb888, Gray8,
                   Gray4, Gray2, Mono, Rgb332, Rgb565Swapped, Bgr888, Xrgb8888, Argb8888) {
  CHECK(TestType::decode(TestType::encode({0, 0, 0})) == Rgb8{0, 0, 0});
  CHECK(TestType::decode(TestType::encode({255, 255, 255})) == Rgb8{255, 255, 255});
  for (int v = 0; v < 256; ++v) {
    const auto level = static_cast<std::uint8_t>(v);
    const auto code = TestType::encode({level, level, level});
    CHECK(TestType::encode(TestType::decode(code)) == code);
  }
}

TEST_CASE("rgb565 truncates each channel") {
  CHECK(Rgb565::encode({255, 255, 255}) == 0xFFFF);
  CHECK(Rgb565::encode({0x0F, 0x07, 0x0F}) == 0x0821);
  CHECK(Rgb565::encode({0, 4, 0}) == 0x0020);
}

TEST_CASE("a format that changes the bits of another one is blended by its own") {
  struct Bgr565 : Rgb565 {
    static constexpr std::uint16_t encode(Rgb8 c) { return Rgb565::encode(Rgb8{c.b, c.g, c.r}); }
    static constexpr std::uint16_t encode_dithered(Rgb8 c, std::int32_t x, std::int32_t y) {
      return Rgb565::encode_dithered(Rgb8{c.b, c.g, c.r}, x, y);
    }
    static constexpr Rgb8 decode(std::uint16_t v) {
      const Rgb8 c = Rgb565::decode(v);
      return {c.b, c.g, c.r};
    }
  };
  struct Rgb555 : Rgb565 {  // rrrrrggg ggbbbbb0
    static constexpr std::uint16_t encode(Rgb8 c) {
      return static_cast<std::uint16_t>(((c.r & 0xF8u) << 8) | ((c.g & 0xF8u) << 3) | ((c.b & 0xF8u) >> 2));
    }
  };
  STATIC_REQUIRE(detail::Rgb565Words<Rgb565> && detail::Rgb565Words<Rgb565Swapped>);
  STATIC_REQUIRE_FALSE(detail::Rgb565Words<Bgr565> || detail::Rgb565Words<Rgb555>);
  constexpr auto kGlass = Opacity<>{24}(PackedRgb::of(1022, 2, 2));
  const Rgb8 mixed = Bgr565::decode(detail::operated<Bgr565>(kGlass, std::uint16_t{0}, 0, 0));
  CHECK(mixed.r > 180);
  CHECK(mixed.b == 0);
}

TEST_CASE("rgb332 has red in the upper bits and blue in the lower ones") {
  CHECK(Rgb332::encode({255, 0, 0}) == 0xE0);
  CHECK(Rgb332::encode({0, 0x20, 0}) == 0x04);
  CHECK(Rgb332::encode({0x1F, 0x1F, 0x7F}) == 0x01);
  CHECK(Rgb332::decode(0x49) == Rgb8{73, 73, 85});
}

TEST_CASE("formats of three and four bytes have their channels where their names say") {
  constexpr Rgb8 kColour{1, 2, 3};
  CHECK(Xrgb8888::encode(kColour) == 0x00010203u);
  CHECK(Argb8888::encode(kColour) == 0xFF010203u);
  const auto bytes = std::bit_cast<std::array<std::uint8_t, 3>>(Bgr888::encode(kColour));
  CHECK(bytes == std::array<std::uint8_t, 3>{3, 2, 1});
}

TEST_CASE("rgb565_swapped is rgb565 with its bytes exchanged, from every kind of colour") {
  const auto exchanged = [](std::uint16_t v) { return static_cast<std::uint16_t>((v << 8) | (v >> 8)); };
  for (std::uint32_t level = 0; level < 1024; ++level) {
    const PackedRgb packed = PackedRgb::of(level, 1023 - level, (level * 7) & 1023);
    CHECK(Rgb565Swapped::encode(packed) == exchanged(Rgb565::encode(packed)));
    const ColourSegment segment = ColourSegment::of(packed);
    CHECK(Rgb565Swapped::encode(segment) == exchanged(Rgb565::encode(segment)));
    const Rgb8 colour = packed.rgb8();
    CHECK(Rgb565Swapped::encode(colour) == exchanged(Rgb565::encode(colour)));
    for (std::int32_t x = 0; x < 8; ++x) {
      const auto code = Rgb565::encode_dithered(colour, x, -5);
      CHECK(Rgb565::encode_dithered(packed, x, -5) == code);
      CHECK(Rgb565Swapped::encode_dithered(colour, x, -5) == exchanged(code));
      CHECK(Rgb565Swapped::encode_dithered(packed, x, -5) == exchanged(code));
    }
  }
  CHECK(Rgb565Swapped::decode(0x1F00) == Rgb8{0, 0, 255});
}

TEMPLATE_TEST_CASE("a bit cursor changes only its own pixel", "", Gray4, Gray2, Mono) {
  constexpr auto kFull = static_cast<std::uint8_t>((1u << TestType::kBitsPerPixel) - 1);
  for (std::int32_t x = 0; x < 20; ++x) {
    std::array<std::uint8_t, 10> row{};
    typename TestType::Cursor(row.data(), x).write(kFull);
    typename TestType::Cursor cursor(row.data(), 0);
    for (std::int32_t i = 0; i < 20; ++i, cursor.next()) CHECK(cursor.read() == (i == x ? kFull : 0));
  }
}

TEMPLATE_TEST_CASE("dither keeps the mean of every colour within a hundredth of full scale", "", Rgb565,
                   Rgb888, Gray8, Gray4, Gray2, Mono, Rgb332, Rgb565Swapped, Bgr888, Xrgb8888, Argb8888) {
  constexpr bool kGrey = std::is_base_of_v<Gray8, TestType> || std::is_base_of_v<Gray4, TestType> ||
                         std::is_base_of_v<Gray2, TestType> || std::is_base_of_v<Mono, TestType>;
  const unsigned channels = GENERATE(7u, 1u, 2u, 4u);  // grey, red, green, blue
  double worst = 0;
  for (int i = 0; i <= 32; ++i) {
    const auto level = static_cast<std::uint8_t>(std::lround(i * 255.0 / 32));
    const auto part = [&](unsigned c) { return static_cast<std::uint8_t>((channels >> c & 1u) * level); };
    const Rgb8 colour{part(0), part(1), part(2)};
    std::array<double, 3> mean{};
    for (std::int32_t y = -3; y < 5; ++y) {
      for (std::int32_t x = 100; x < 108; ++x) {
        const Rgb8 p = TestType::decode(encode_at<Dithered<TestType>>(
            PackedRgb::of(4u * colour.r + 2, 4u * colour.g + 2, 4u * colour.b + 2), x, y));
        mean = {mean[0] + p.r / 64.0, mean[1] + p.g / 64.0, mean[2] + p.b / 64.0};
      }
    }
    const double luma = 0.299 * colour.r + 0.587 * colour.g + 0.114 * colour.b;  // BT.601
    const std::array<double, 3> wanted =
        kGrey ? std::array<double, 3>{luma, luma, luma}
              : std::array<double, 3>{double(colour.r), double(colour.g), double(colour.b)};
    for (std::size_t c = 0; c < 3; ++c) worst = std::max(worst, std::abs(mean[c] - wanted[c]) / 255);
  }
  CHECK(worst <= 0.01);
}

TEST_CASE("dither keeps black and full, and 8 bits") {
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      CHECK(dithered<1>(0, x, y) < 128);
      CHECK(dithered<1>(255, x, y) >= 128);
      CHECK(dithered<8>(77, x, y) == 77);
    }
  }
}
