// SPDX-License-Identifier: MIT
// The bytes of any area, from and to any address, are those of its pixels one by one.
#include <arcspan/hal/panel/wire_layout.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

using namespace arcspan;
using namespace arcspan::hal;

namespace {

/// A frame of random pixels whose memory begins `offset` words after that of a vector.
template <class F>
struct Noise {
  std::vector<typename F::Word> memory;
  Framebuffer<F> frame;

  Noise(std::int32_t width, std::int32_t height, std::size_t offset, test::Random& random)
      : memory(offset + Framebuffer<F>::words(width, height)),
        frame(std::span(memory).subspan(offset), width, height) {
    for (auto& word : memory) word = static_cast<typename F::Word>(random.bits());
  }
};

/// The bytes that a layout packs at `offset` bytes after an address of new memory.
template <class Layout>
std::vector<std::uint8_t> packed(const Framebuffer<typename Layout::Format>& frame, const Rect& area,
                                 std::size_t offset) {
  std::vector<std::uint8_t> bytes(offset + Layout::bytes(area) + 1, 0x5A);
  Layout::pack(frame, area, Orientation::k0, bytes.data() + offset);
  CHECK(bytes.back() == 0x5A);
  bytes.pop_back();
  bytes.erase(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(offset));
  return bytes;
}

}  // namespace

TEST_CASE("16-bit pixels have their high byte first, from and to any address") {
  test::Random random(61);
  for (std::size_t from = 0; from < 2; ++from) {
    const Noise<Rgb565> noise(23, 3, from, random);
    for (std::int32_t left = 0; left < 4; ++left) {
      for (std::int32_t right = left; right <= 23; ++right) {
        std::vector<std::uint8_t> expected;
        for (std::int32_t y = 1; y < 3; ++y) {
          for (std::int32_t x = left; x < right; ++x) {
            expected.push_back(static_cast<std::uint8_t>(noise.frame.row(y)[x] >> 8));
            expected.push_back(static_cast<std::uint8_t>(noise.frame.row(y)[x] & 0xFF));
          }
        }
        for (std::size_t to = 0; to < 4; ++to)
          REQUIRE(packed<BigEndianRgb565>(noise.frame, {left, 1, right, 3}, to) == expected);
      }
    }
  }
}

TEST_CASE("a page has one byte per column, the top pixel in its lowest bit") {
  test::Random random(62);
  const Noise<Mono> noise(40, 24, 0, random);
  for (std::int32_t left = 0; left < 17; ++left) {
    for (std::int32_t right = left; right <= 40; ++right) {
      std::vector<std::uint8_t> expected;
      for (std::int32_t page = 8; page < 24; page += 8) {
        for (std::int32_t x = left; x < right; ++x) {
          unsigned bits = 0;
          for (std::int32_t i = 0; i < 8; ++i)
            bits |= unsigned{Mono::Cursor(noise.frame.row(page + i), x).read()} << i;
          expected.push_back(static_cast<std::uint8_t>(bits));
        }
      }
      REQUIRE(packed<MonoPages>(noise.frame, {left, 8, right, 24}, 0) == expected);
    }
  }
}
