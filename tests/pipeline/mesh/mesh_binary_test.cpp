// SPDX-License-Identifier: MIT
#include <arcspan/mesh/crc32.hpp>
#include <arcspan/mesh/mesh_binary.hpp>

#include <catch2/catch.hpp>

#include <cstring>
#include <string_view>
#include <vector>

using namespace arcspan;

namespace {

// Written by hand from docs/mesh-binary.md: one triangle, 8-bit indices, three bytes of padding.
const std::vector<std::uint8_t> kTriangle{
    'A',  'R',  'C',  'M',                                       // magic
    1,    0,    1,    0,                                         // version, flags: 8-bit indices
    72,   0,    0,    0,    3,    0,    0, 0, 1,    0,    0, 0,  // size, vertices, triangles
    0xFE, 0xFF, 0x00, 0x80, 0x06, 0x00,                          // low (-2, -32768, 6)
    0x04, 0x00, 0xFF, 0x7F, 0x06, 0x00,                          // high (4, 32767, 6)
    0x04, 0x00, 0x05, 0x00, 0x06, 0x00,                          // positions
    0xFE, 0xFF, 0x00, 0x80, 0x06, 0x00, 1, 0, 0xFF, 0x7F, 6, 0,
    0,    0,    0,    0,    1,    0,    2, 0, 0xFF, 0x7F, 0, 0,  // normals
    2,    0,    1,    0,    0,    0,                             // indices, padding
};

// The same with a plane, version 2.
const std::vector<std::uint8_t> kTriangleWithPlane = [] {
  std::vector<std::uint8_t> bytes = kTriangle;
  bytes[4] = 2;
  bytes[6] = 3;
  bytes[8] = 80;
  const std::uint8_t planes[] = {0xFB, 14, 0x12, 0x80,
                                 0x81, 2,  0x7F, 0xFF};  // -5, 14, 32786; -127, 2, 127, -1
  bytes.insert(bytes.end(), std::begin(planes), std::end(planes));
  return bytes;
}();

// That with texture points of 12 fraction bits, version 3.
const std::vector<std::uint8_t> kTriangleWithTexturePoints = [] {
  std::vector<std::uint8_t> bytes = kTriangleWithPlane;
  bytes[4] = 3;
  bytes[6] = 7;
  bytes[8] = 96;
  const std::uint8_t points[] = {12, 0, 0, 0, 0, 0x10, 1, 0, 0xFF, 0xFF, 2, 0, 0, 0x80, 0xFF, 0x7F};
  bytes.insert(bytes.end(), std::begin(points), std::end(points));
  return bytes;
}();

// That with colours, version 4.
const std::vector<std::uint8_t> kTriangleWithColours = [] {
  std::vector<std::uint8_t> bytes = kTriangleWithTexturePoints;
  bytes[4] = 4;
  bytes[6] = 15;
  bytes[8] = 108;
  const std::uint8_t colours[] = {255, 1, 2, 3, 254, 4, 0, 5, 128, 0, 0, 0};
  bytes.insert(bytes.end(), std::begin(colours), std::end(colours));
  return bytes;
}();

// Bytes at an even address, with a right checksum.
class Binary {
 public:
  explicit Binary(std::vector<std::uint8_t> bytes) : bytes_(std::move(bytes)) {
    const std::uint32_t crc = crc32(bytes_);
    for (int i = 0; i < 4; ++i) bytes_.push_back(static_cast<std::uint8_t>(crc >> (8 * i)));
  }
  Status view(MeshView& mesh, MeshBounds* bounds = nullptr) const {
    return view_mesh_binary(bytes_, mesh, bounds);
  }
  Status status() const {
    MeshView mesh;
    return view(mesh);
  }
  [[nodiscard]] std::vector<std::uint8_t>& bytes() { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
};

Binary changed(std::size_t at, std::uint8_t value, std::vector<std::uint8_t> bytes = kTriangle) {
  bytes.at(at) = value;
  return Binary(bytes);
}

}  // namespace

TEST_CASE("the checksum is the CRC-32 of zlib and PNG") {
  const std::string_view text = "123456789";
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  CHECK(crc32(bytes) == 0xCBF43926);
  CHECK(crc32({}) == 0);
}

TEST_CASE("a mesh binary is used where it lies") {
  const Binary binary(kTriangle);
  MeshView mesh;
  MeshBounds bounds;
  REQUIRE(ok(binary.view(mesh, &bounds)));
  REQUIRE(mesh.vertex_count() == 3);
  REQUIRE(mesh.triangle_count() == 1);
  CHECK(mesh.position(0) == ObjectPosition{4, 5, 6});
  CHECK(mesh.position(1) == ObjectPosition{-2, -32768, 6});
  CHECK(mesh.position(2) == ObjectPosition{1, 32767, 6});
  CHECK(mesh.normal(1) == PackedNormal{1, 2});
  CHECK(mesh.normal(2) == PackedNormal{32767, 0});
  CHECK(mesh.triangle(0).a == 2);
  CHECK(mesh.triangle(0).b == 0);
  CHECK(mesh.triangle(0).c == 1);
  CHECK(bounds.low == ObjectPosition{-2, -32768, 6});
  CHECK(bounds.high == ObjectPosition{4, 32767, 6});
}

TEST_CASE("a mesh binary may have planes") {
  const Binary binary(kTriangleWithPlane);
  MeshView mesh;
  REQUIRE(ok(binary.view(mesh)));
  CHECK(mesh.triangle_count() == 1);
  REQUIRE(mesh.planes() != nullptr);
  CHECK(mesh.planes()[0] == FacePlane{-127, 2, 127, -1});
  CHECK(mesh.plane_scale() == PlaneScale{-5, 14, 32786});

  MeshView plain;
  REQUIRE(ok(Binary(kTriangle).view(plain)));
  CHECK(plain.planes() == nullptr);
  REQUIRE(ok(changed(4, 2).view(plain)));  // version 2 need not have any
  CHECK(plain.planes() == nullptr);

  const std::size_t scale_at = kTriangle.size();
  CHECK(changed(scale_at, 9, kTriangleWithPlane).status() == Status::kCorrupted);
  CHECK(changed(scale_at + 1, 18, kTriangleWithPlane).status() == Status::kCorrupted);
  CHECK(changed(scale_at + 3, 0x7F, kTriangleWithPlane).status() == Status::kCorrupted);  // beyond reach
  CHECK(changed(6, 7, kTriangleWithPlane).status() == Status::kCorrupted);                // an unknown flag
  CHECK(changed(6, 1, kTriangleWithPlane).status() == Status::kCorrupted);  // too long without planes
  CHECK(changed(scale_at, 9, kTriangleWithPlane).view(mesh) == Status::kCorrupted);
  CHECK(mesh.plane_scale() == PlaneScale{-5, 14, 32786});  // left alone
}

TEST_CASE("a mesh binary may have texture points") {
  const Binary binary(kTriangleWithTexturePoints);
  MeshView mesh;
  REQUIRE(ok(binary.view(mesh)));
  CHECK(mesh.texture_scale() == TextureScale{12});
  CHECK(mesh.texture_point(0) == TexturePoint{0x1000, 1});
  CHECK(mesh.texture_point(1) == TexturePoint{-1, 2});
  CHECK(mesh.texture_point(2) == TexturePoint{-32768, 32767});
  REQUIRE(mesh.planes() != nullptr);
  CHECK(mesh.planes()[0] == FacePlane{-127, 2, 127, -1});

  const std::size_t scale_at = kTriangleWithPlane.size();
  CHECK(changed(scale_at, 3, kTriangleWithTexturePoints).status() == Status::kCorrupted);
  CHECK(changed(scale_at, 16, kTriangleWithTexturePoints).status() == Status::kCorrupted);
  CHECK(changed(scale_at + 1, 1, kTriangleWithTexturePoints).status() == Status::kCorrupted);
  CHECK(changed(6, 3, kTriangleWithTexturePoints).status() == Status::kCorrupted);  // too long without them
  CHECK(changed(6, 15, kTriangleWithTexturePoints).status() == Status::kCorrupted);
  CHECK(changed(4, 2, kTriangleWithTexturePoints).status() == Status::kCorrupted);
  std::vector<std::uint8_t> without_planes = kTriangleWithTexturePoints;
  without_planes.erase(without_planes.begin() + static_cast<std::ptrdiff_t>(kTriangle.size()),
                       without_planes.begin() + static_cast<std::ptrdiff_t>(kTriangleWithPlane.size()));
  without_planes[6] = 5;
  without_planes[8] = 88;
  const Binary shorter(without_planes);
  REQUIRE(ok(shorter.view(mesh)));
  CHECK(mesh.planes() == nullptr);
  CHECK(mesh.texture_point(1) == TexturePoint{-1, 2});
}

TEST_CASE("a mesh binary may have colours") {
  MeshView mesh;
  const Binary coloured(kTriangleWithColours);  // the view refers to it
  REQUIRE(ok(coloured.view(mesh)));
  CHECK(mesh.colour(0) == Rgb8{255, 1, 2});
  CHECK(mesh.colour(1) == Rgb8{3, 254, 4});
  CHECK(mesh.colour(2) == Rgb8{0, 5, 128});
  CHECK(mesh.texture_point(2) == TexturePoint{-32768, 32767});
  CHECK(changed(6, 7, kTriangleWithColours).status() == Status::kCorrupted);  // too long without them
  CHECK(changed(6, 31, kTriangleWithColours).status() == Status::kCorrupted);
  CHECK(changed(4, 3, kTriangleWithColours).status() == Status::kCorrupted);
  // Without planes and texture points.
  std::vector<std::uint8_t> bare = kTriangleWithColours;
  bare.erase(bare.begin() + static_cast<std::ptrdiff_t>(kTriangle.size()),
             bare.begin() + static_cast<std::ptrdiff_t>(kTriangleWithTexturePoints.size()));
  bare[6] = 9;
  bare[8] = 84;
  const Binary without_others(bare);
  REQUIRE(ok(without_others.view(mesh)));
  CHECK(mesh.colour(1) == Rgb8{3, 254, 4});
  CHECK(mesh.texture_point(2) == TexturePoint{});
}

TEST_CASE("a mesh binary may be followed by anything") {
  Binary binary(kTriangle);
  binary.bytes().resize(4096, 0xFF);
  CHECK(binary.status() == Status::kOk);
}

TEST_CASE("every changed bit of a mesh binary is found") {
  const std::vector<std::uint8_t> bytes = GENERATE(kTriangle, kTriangleWithPlane, kTriangleWithTexturePoints);
  for (std::size_t bit = 0; bit < 8 * (bytes.size() + 4); ++bit) {
    CAPTURE(bit);
    Binary binary(bytes);
    binary.bytes()[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
    CHECK_FALSE(ok(binary.status()));
  }
}

TEST_CASE("every truncation of a mesh binary is found") {
  const std::vector<std::uint8_t> bytes = GENERATE(kTriangle, kTriangleWithPlane, kTriangleWithTexturePoints);
  const Binary whole(bytes);
  for (std::size_t size = 0; size < bytes.size() + 4; ++size) {
    CAPTURE(size);
    Binary binary = whole;
    binary.bytes().resize(size);
    CHECK(binary.status() == Status::kTruncated);
  }
}

TEST_CASE("a malformed mesh binary gives the status that names its mistake, and the view keeps its value") {
  CHECK(changed(0, 'B').status() == Status::kUnsupported);
  CHECK(changed(4, 0).status() == Status::kUnsupported);
  CHECK(changed(4, 5).status() == Status::kUnsupported);
  CHECK(changed(6, 2).status() == Status::kCorrupted);      // planes in version 1
  CHECK(changed(8, 76).status() == Status::kCorrupted);     // size
  CHECK(changed(12, 4).status() == Status::kCorrupted);     // vertices
  CHECK(changed(15, 0xFF).status() == Status::kCorrupted);  // more than there can be
  CHECK(changed(19, 0xFF).status() == Status::kCorrupted);  // triangles whose size does not fit 32 bits
  CHECK(changed(62, 3).status() == Status::kIndexOutOfRange);
  MeshView mesh;
  MeshBounds bounds{{1, 2, 3}, {4, 5, 6}};
  REQUIRE(ok(Binary(kTriangle).view(mesh)));
  CHECK(changed(62, 3).view(mesh, &bounds) == Status::kIndexOutOfRange);
  CHECK(mesh.triangle_count() == 1);
  CHECK(bounds.low == ObjectPosition{1, 2, 3});
}

TEST_CASE("a mesh binary at an odd address is refused") {
  Binary binary(kTriangle);
  binary.bytes().insert(binary.bytes().begin(), 0);
  MeshView mesh;
  CHECK(view_mesh_binary(std::span(binary.bytes()).subspan(1), mesh) == Status::kInvalidArgument);
}
