// SPDX-License-Identifier: MIT
#include <arcspan/mesh/crc32.hpp>
#include <arcspan/texture/texture_binary.hpp>

#include <catch2/catch.hpp>

#include <vector>

using namespace arcspan;

namespace {

// Written by hand from docs/texture-binary.md: 8x8 texels of grey, two levels.
const std::vector<std::uint8_t> kGrey = [] {
  std::vector<std::uint8_t> bytes{
      'A', 'R', 'C', 'T', 2, 0, 3, 0,  // magic, version, grey, no alpha
      100, 0,   0,   0,   3, 3, 2, 0,  // size, 8x8, two levels
  };
  for (int i = 0; i < 80; ++i) bytes.push_back(static_cast<std::uint8_t>(3 * i));
  return bytes;
}();

// 16x8 texels, 4-bit palette of colours with one bit of alpha, one level.
const std::vector<std::uint8_t> kPalette = [] {
  std::vector<std::uint8_t> bytes{'A', 'R', 'C', 'T', 2, 0, 2, 1, 116, 0, 0, 0, 4, 3, 1, 0};
  for (int i = 0; i < 16; ++i) {
    bytes.push_back(static_cast<std::uint8_t>(i));  // low byte of colour i
    bytes.push_back(0x80);
  }
  for (int i = 0; i < 64; ++i) bytes.push_back(static_cast<std::uint8_t>(0xF0 - i));
  return bytes;
}();

// Bytes at an even address, with a right checksum.
std::vector<std::uint8_t> closed(std::vector<std::uint8_t> bytes) {
  const std::uint32_t crc = crc32(bytes);
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(crc >> (8 * i)));
  return bytes;
}

Status status_of(const std::vector<std::uint8_t>& bytes) {
  StoredTexture texture;
  return view_texture_binary(bytes, texture);
}

Status status_with(std::size_t at, std::uint8_t value, std::vector<std::uint8_t> bytes = kGrey) {
  bytes.at(at) = value;
  return status_of(closed(std::move(bytes)));
}

}  // namespace

TEST_CASE("a texture binary is used where it lies") {
  const std::vector<std::uint8_t> bytes = closed(kGrey);
  Texture<GrayTexels> texture;
  REQUIRE(ok(view_texture_binary(bytes, texture)));
  CHECK(texture.size() == TextureSize{3, 3, 2});
  CHECK(texture.at(0) == bytes.data() + 16);
  CHECK(texture.at(64)[15] == 3 * 79);
}

TEST_CASE("a texture binary has the palette of its format") {
  const std::vector<std::uint8_t> bytes = closed(kPalette);
  Texture<Palette4Texels<Alpha1Colour>> texture;
  REQUIRE(ok(view_texture_binary(bytes, texture)));
  CHECK(texture.size() == TextureSize{4, 3, 1});
  const auto stored = [&texture](std::uint32_t i) {
    return Palette4Texels<Alpha1Colour>::stored(texture.at(0), texture.palette(), i);
  };
  CHECK(stored(0) == 0x800F);  // the upper half of 0xF0
  CHECK(stored(1) == 0x8000);
  CHECK(stored(127) == 0x8001);  // the lower half of 0xF0 - 63
}

TEST_CASE("a program that names another format gets a status, and its texture keeps its value") {
  const std::vector<std::uint8_t> grey = closed(kGrey);
  Texture<Palette8Texels<>> eight;
  CHECK(view_texture_binary(grey, eight) == Status::kUnsupported);
  Texture<DirectTexels<>> direct;
  CHECK(view_texture_binary(grey, direct) == Status::kUnsupported);
  CHECK(direct.size() == TextureSize{3, 3, 1});
  Texture<Palette4Texels<>> opaque;
  CHECK(view_texture_binary(closed(kPalette), opaque) == Status::kUnsupported);
}

TEST_CASE("a texture binary may be followed by anything") {
  std::vector<std::uint8_t> bytes = closed(kPalette);
  bytes.resize(4096, 0xFF);
  CHECK(status_of(bytes) == Status::kOk);
}

TEST_CASE("a texture binary has a sampler, which is the default in the byte that was zero") {
  constexpr TextureWrap kWraps[] = {TextureWrap::kRepeat, TextureWrap::kClamp, TextureWrap::kMirror};
  for (unsigned byte = 0; byte < 0x20; ++byte) {
    if ((byte & 3) == 3 || (byte & 12) == 12) continue;
    CAPTURE(byte);
    std::vector<std::uint8_t> bytes = kGrey;
    bytes[15] = static_cast<std::uint8_t>(byte);
    bytes = closed(bytes);
    Texture<GrayTexels> texture;
    REQUIRE(ok(view_texture_binary(bytes, texture)));
    const TextureSampler wanted{kWraps[byte & 3], kWraps[byte >> 2 & 3],
                                byte >> 4 != 0 ? TextureFilter::kBilinear : TextureFilter::kNearest};
    CHECK(texture.sampler() == wanted);
    CHECK(texture_binary::sampler_byte(wanted) == byte);
  }
  CHECK(Texture<GrayTexels>().sampler() == TextureSampler{});
}

TEST_CASE("every changed bit of a texture binary is found") {
  const std::vector<std::uint8_t> whole = closed(GENERATE(false, true) ? kPalette : kGrey);
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    CAPTURE(bit);
    std::vector<std::uint8_t> bytes = whole;
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
    CHECK_FALSE(ok(status_of(bytes)));
  }
}

TEST_CASE("every truncation of a texture binary is found") {
  const std::vector<std::uint8_t> whole = closed(GENERATE(false, true) ? kPalette : kGrey);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    CAPTURE(size);
    CHECK(status_of({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}) ==
          Status::kTruncated);
  }
}

TEST_CASE("a malformed texture binary gives the status that names its mistake") {
  CHECK(status_with(0, 'B') == Status::kUnsupported);
  CHECK(status_with(4, 0) == Status::kUnsupported);
  CHECK(status_with(4, 1) == Status::kUnsupported);
  CHECK(status_with(5, 1) == Status::kUnsupported);
  CHECK(status_with(6, 4) == Status::kCorrupted);   // no such layout
  CHECK(status_with(6, 1) == Status::kCorrupted);   // its palette is missing
  CHECK(status_with(7, 1) == Status::kCorrupted);   // grey has no alpha
  CHECK(status_with(8, 96) == Status::kCorrupted);  // size
  CHECK(status_with(12, 2) == Status::kCorrupted);  // 4 texels wide
  CHECK(status_with(12, 11) == Status::kCorrupted);
  CHECK(status_with(13, 4) == Status::kCorrupted);  // higher than its bytes
  CHECK(status_with(14, 0) == Status::kCorrupted);
  CHECK(status_with(14, 5) == Status::kCorrupted);
  for (const int sampler : {0x03, 0x0C, 0x20, 0x40, 0x80})  // no such wrap of u, v; unknown bits
    CHECK(status_with(15, static_cast<std::uint8_t>(sampler)) == Status::kCorrupted);
  CHECK(status_with(7, 2, kPalette) == Status::kCorrupted);  // no colour has two bits of alpha
  CHECK(status_with(7, 4, kPalette) == Status::kOk);
  CHECK(status_with(7, 0, kPalette) == Status::kOk);
}

TEST_CASE("a texture binary at an odd address is refused") {
  std::vector<std::uint8_t> bytes = closed(kGrey);
  bytes.insert(bytes.begin(), 0);
  StoredTexture texture;
  CHECK(view_texture_binary(std::span<const std::uint8_t>(bytes).subspan(1), texture) ==
        Status::kInvalidArgument);
  CHECK(texture.texels.empty());
}
