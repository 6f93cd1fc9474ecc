// SPDX-License-Identifier: MIT
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/texture/texture.hpp>

#include <catch2/catch.hpp>

#include <array>
#include <cstdint>
#include <vector>

using namespace arcspan;

TEST_CASE("a texture refuses sizes and memory that do not fit, and stays as it was") {
  const std::vector<std::uint16_t> words(64 * 16 + 32 * 8, 7);
  Texture<DirectTexels<>> texture;
  const Texture<DirectTexels<>> before = texture;
  const auto refused = [&](std::size_t count, const TextureSize& size, std::span<const std::uint16_t> palette,
                           Status expected) {
    CHECK(Texture<DirectTexels<>>::make({words.data(), count}, size, texture, palette) == expected);
    CHECK(texture.size() == before.size());
    CHECK(texture.at(0) == before.at(0));
  };
  refused(words.size(), {2, 4, 1}, {}, Status::kInvalidArgument);
  refused(words.size(), {11, 4, 1}, {}, Status::kInvalidArgument);
  refused(words.size(), {6, 4, 0}, {}, Status::kInvalidArgument);
  refused(words.size(), {6, 4, 6}, {}, Status::kInvalidArgument);  // the fifth level has one row
  refused(words.size(), {6, 4, 2}, words, Status::kInvalidArgument);
  refused(words.size() - 1, {6, 4, 2}, {}, Status::kBufferTooSmall);
  REQUIRE(Texture<DirectTexels<>>::make(words, {6, 4, 2}, texture) == Status::kOk);
  CHECK(texture.at(0) == words.data());
  CHECK(texture.at(texture.size().texels(1)) == words.data() + 64 * 16);

  const std::vector<std::uint8_t> bytes(32);
  Texture<Palette4Texels<>> small;
  CHECK(Texture<Palette4Texels<>>::make(bytes, {3, 3, 1}, small, {words.data(), 15}) ==
        Status::kBufferTooSmall);
  CHECK(Texture<Palette4Texels<>>::make({bytes.data(), 31}, {3, 3, 1}, small, {words.data(), 16}) ==
        Status::kBufferTooSmall);
  CHECK(Texture<Palette4Texels<>>::make(bytes, {3, 3, 1}, small, {words.data(), 16}) == Status::kOk);
  CHECK(Texture<Palette4Texels<>>::words({3, 3, 4}) == 43);  // 85 texels
}

TEST_CASE("every stored colour becomes the nearest 5-6-5 pixel with the same top bits, and an alpha") {
  for (std::uint32_t s = 0; s < 65536; ++s) {
    const auto stored = static_cast<std::uint16_t>(s);
    REQUIRE(OpaqueColour::rgb565(stored) == stored);
    const std::uint32_t one = Alpha1Colour::rgb565(stored);
    REQUIRE((one >> 11) == (s >> 11));
    REQUIRE((one >> 6 & 31) == (s >> 6 & 31));
    REQUIRE((one & 31) == (s & 31));
    const std::uint32_t opaque = (s >> 5) & 1u;
    if (opaque != 0) REQUIRE((one >> 5 & 1) == (s >> 10 & 1));  // the sixth bit of green repeats the first
    REQUIRE(Alpha1Colour::alpha(stored) == 16 * opaque);
    const std::uint32_t four = Alpha4Colour::rgb565(stored);
    const auto repeated = [&](std::uint32_t level, unsigned bits) {
      return (level * ((1u << bits) - 1) + 7) / 15;
    };
    REQUIRE((four >> 11) == repeated(s >> 12, 5));
    const auto near = [](std::uint32_t a, std::uint32_t b) { return a <= b + 1 && b <= a + 1; };
    REQUIRE(near(four >> 5 & 63, repeated(s >> 8 & 15, 6)));
    REQUIRE((four & 31) == repeated(s >> 4 & 15, 5));
    REQUIRE(Alpha4Colour::alpha(stored) == ((s & 15) == 15 ? 16 : (s & 15) + ((s & 15) >= 8 ? 1 : 0)));
  }
}

TEST_CASE("texels of four bits lie left to right from the upper bits on; grey levels keep theirs") {
  const std::array<std::uint8_t, 2> bytes{0x12, 0xEF};
  std::array<std::uint16_t, 16> palette{};
  for (std::size_t i = 0; i < palette.size(); ++i) palette[i] = static_cast<std::uint16_t>(100 + i);
  CHECK(Palette4Texels<>::stored(bytes.data(), palette.data(), 0) == 101);
  CHECK(Palette4Texels<>::stored(bytes.data(), palette.data(), 1) == 102);
  CHECK(Palette4Texels<>::stored(bytes.data(), palette.data(), 2) == 114);
  CHECK(Palette4Texels<>::stored(bytes.data(), palette.data(), 3) == 115);
  for (std::uint32_t level = 0; level < 256; ++level) {
    const auto byte = static_cast<std::uint8_t>(level);
    const std::uint16_t pixel = GrayTexels::stored(&byte, nullptr, 0);
    CHECK((pixel >> 11) == level >> 3);
    CHECK((pixel >> 5 & 63) == level >> 2);
    CHECK((pixel & 31) == level >> 3);
  }
}

TEST_CASE("a mesh takes one texture point and one colour per vertex, and has defaults without them") {
  const std::array<ObjectPosition, 3> positions{};
  const std::array<PackedNormal, 3> normals{};
  const std::array<std::uint8_t, 3> indices{0, 1, 2};
  MeshView mesh;
  REQUIRE(MeshView::make(positions, normals, indices, mesh) == Status::kOk);
  CHECK(mesh.texture_point(2) == TexturePoint{});
  CHECK(mesh.colour(2) == Rgb8{255, 255, 255});

  const std::array<TexturePoint, 3> points{{{1, 2}, {3, 4}, {5, 6}}};
  const MeshView plain = mesh;
  CHECK(mesh.attach(std::span<const TexturePoint>(points).first(2), TextureScale{12}) ==
        Status::kInvalidArgument);
  CHECK(mesh.attach(points, TextureScale{3}) == Status::kInvalidArgument);
  CHECK(mesh.attach(points, TextureScale{16}) == Status::kInvalidArgument);
  CHECK(mesh == plain);
  REQUIRE(mesh.attach(points, TextureScale{15}) == Status::kOk);
  CHECK(mesh.texture_point(1) == TexturePoint{3, 4});
  CHECK(mesh.texture_scale().fraction_bits == 15);

  const std::array<Rgb8, 3> colours{{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}};
  CHECK(mesh.attach(std::span<const Rgb8>(colours).first(2)) == Status::kInvalidArgument);
  REQUIRE(mesh.attach(colours) == Status::kOk);
  CHECK(mesh.colour(2) == Rgb8{7, 8, 9});
}
