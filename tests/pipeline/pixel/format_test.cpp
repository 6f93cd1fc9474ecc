// SPDX-License-Identifier: MIT
#include <arcspan/pixel/pixel_format_list.hpp>

#include <catch2/catch.hpp>

#include <array>
#include <bit>
#include <cstdlib>

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
    CHECK(Rgb565Swapped::encode_dithered(colour, 1, 2) == exchanged(Rgb565::encode_dithered(colour, 1, 2)));
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

TEST_CASE("dither keeps the mean of a level that the format cannot show") {
  // Over a 4x4 tile the mean of the truncated output is within one step of the matrix (1/8 of 8) of the
  // input.
  for (int v = 8; v < 248; ++v) {
    int sum = 0;
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x) sum += (dithered<5>(static_cast<std::uint8_t>(v), x, y) >> 3) * 8;
    // Truncation loses 3.5 of 8 on average and the matrix adds -0.5.
    CHECK(std::abs(sum / 16.0 - (v - 4.0)) <= 0.5);
  }
}

TEST_CASE("dither saturates at both ends") {
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      CHECK(dithered<1>(0, x, y) < 128);
      CHECK(dithered<1>(255, x, y) >= 128);
      CHECK(dithered<8>(77, x, y) == 77);
    }
  }
}
