// SPDX-License-Identifier: MIT
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/fill.hpp>
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/pixel/mono.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/rgb888.hpp>
#include <arcspan/span/depth.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <vector>

using namespace arcspan;

namespace {

constexpr bool fills_in_a_constant() {
  std::array<std::uint16_t, 37> codes{};
  fill(codes.data() + 1, 35, std::uint16_t{0x1234});
  bool right = codes[0] == 0 && codes[36] == 0;
  for (std::size_t i = 1; i < 36; ++i) right = right && codes[i] == 0x1234;
  return right;
}
static_assert(fills_in_a_constant());

}  // namespace

TEMPLATE_TEST_CASE("fill sets as many words as it is asked for, wherever they begin", "", std::uint8_t,
                   std::uint16_t, std::uint32_t, std::int16_t, std::uint64_t) {
  constexpr auto kValue = static_cast<TestType>(0x9A3CF1E5u);
  constexpr auto kOutside = static_cast<TestType>(0x55);
  for (std::size_t first = 0; first < 9; ++first) {
    for (std::size_t count = 0; count < 150; ++count) {
      std::vector<TestType> codes(first + count + 9, kOutside);
      std::vector<TestType> wanted = codes;
      std::fill_n(wanted.begin() + static_cast<std::ptrdiff_t>(first), count, kValue);
      fill(codes.data() + first, count, kValue);
      REQUIRE(codes == wanted);
    }
  }
}

TEMPLATE_TEST_CASE("elements are copied from any place to any other", "", std::uint8_t, std::uint16_t,
                   std::uint32_t) {
  constexpr auto kOutside = static_cast<TestType>(0x55);
  std::vector<TestType> source(60);
  for (std::size_t i = 0; i < source.size(); ++i) source[i] = static_cast<TestType>(0x9A3C71E5u * (i + 1));
  for (std::size_t from = 0; from < 4; ++from) {
    for (std::size_t to = 0; to < 4; ++to) {
      for (std::size_t count = 0; from + count <= source.size(); ++count) {
        std::vector<TestType> copied(to + count + 9, kOutside);
        std::vector<TestType> wanted = copied;
        std::copy_n(source.begin() + static_cast<std::ptrdiff_t>(from), count,
                    wanted.begin() + static_cast<std::ptrdiff_t>(to));
        copy_elements(source.data() + from, count, copied.data() + to);
        REQUIRE(copied == wanted);
      }
    }
  }
}

TEMPLATE_TEST_CASE("clearing a band sets every pixel, and nothing behind it", "", Rgb565, Rgb888, Gray8,
                   Gray4, Mono) {
  using Frame = hal::Framebuffer<TestType>;
  constexpr std::int32_t kWidth = 35;
  constexpr std::int32_t kRows = 7;
  constexpr Rgb8 kColour{200, 100, 60};
  std::vector<typename Frame::Word> memory(Frame::words(kWidth, kRows) + 4, typename Frame::Word{0x5A});
  Frame frame({memory.data(), memory.size() - 4}, kWidth, kRows, 20);
  frame.clear(kColour);
  const Rgb8 stored = TestType::decode(TestType::encode(kColour));
  for (std::int32_t y = 20; y < 20 + kRows; ++y) {
    for (std::int32_t x = 0; x < kWidth; ++x) REQUIRE(frame.pixel(x, y) == stored);
  }
  CHECK(std::count(memory.end() - 4, memory.end(), typename Frame::Word{0x5A}) == 4);
}

TEST_CASE("clearing depths makes all of them the farthest") {
  std::vector<std::uint16_t> memory(DepthBuffer::words(33, 5) + 1, 7);
  DepthBuffer depth({memory.data(), memory.size() - 1}, 33, 5, 10);
  depth.clear();
  CHECK(std::count(memory.begin(), memory.end() - 1, DepthBuffer::kFarthest) == 33 * 5);
  CHECK(memory.back() == 7);
}
