// SPDX-License-Identifier: MIT
// Model binaries written by hand: their parts, each reason to refuse one, and damaged bytes under a right
// checksum.
#include <arcspan/model/model_binary.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/model/chunk_bytes.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

#include <cstring>
#include <string_view>

using namespace arcspan;
using namespace arcspan::test;

namespace {

// Chunks of model() in the order of the file.
enum : std::size_t { kMesh0, kMesh1, kModel, kParts, kTexture0, kTexture1 };

/// The header of a mesh chunk; its size is to be put at offset 8.
Bytes mesh_header(std::uint16_t flags, std::uint32_t vertices, std::uint32_t triangles) {
  Bytes out{'A', 'R', 'C', 'M', 4, 0};
  append(out, flags, 2);
  append(out, 0, 4);
  append(out, vertices, 4);
  append(out, triangles, 4);
  append_u16(out, {0, 0, 0, 0, 0, 0});  // low and high
  return out;
}

Bytes closed_chunk(Bytes out) {
  out.resize((out.size() + 3) / 4 * 4);
  put(out, 8, out.size(), 4);
  return out;
}

/// Both sides of a triangle with 8-bit indices, planes, texture points and colours.
Bytes full_mesh() {
  Bytes out = mesh_header(15, 3, 2);
  append_u16(out, {4, 5, 6, -2, -32768, 6, 1, 32767, 6});             // positions
  append_u16(out, {0, 0, 1, 2, 32767, 0});                            // normals
  out.insert(out.end(), {2, 0, 1, 2, 1, 0});                          // indices
  out.insert(out.end(), {0xFB, 14, 0x12, 0x80});                      // scale of planes: -5, 14, 32786
  out.insert(out.end(), {0x81, 2, 0x7F, 0xFF, 0x7F, 0xFE, 0x81, 1});  // planes
  out.insert(out.end(), {12, 0, 0, 0});                               // scale of texture points
  append_u16(out, {0x1000, 1, -1, 2, -32768, 32767});                 // texture points
  out.insert(out.end(), {255, 1, 2, 3, 254, 4, 0, 5, 128});           // colours
  return closed_chunk(out);
}

/// Two triangles with 16-bit indices and nothing else.
Bytes plain_mesh() {
  Bytes out = mesh_header(0, 4, 2);
  append_u16(out, {0, 0, 0, 9, 0, 0, 9, 9, 0, 0, 9, 0});
  append_u16(out, {1, 2, 3, 4, 5, 6, 7, 8});
  append_u16(out, {0, 1, 2, 0, 2, 3});
  return closed_chunk(out);
}

Bytes texture_header(TexelLayout layout, std::uint8_t width_bits, std::uint8_t height_bits) {
  Bytes out{'A', 'R', 'C', 'T', 2, 0, static_cast<std::uint8_t>(layout), 0};
  append(out, 0, 4);
  out.insert(out.end(), {width_bits, height_bits, 1, 0});
  return out;
}

Bytes grey_texture() {
  Bytes out = texture_header(TexelLayout::kGray, 3, 3);
  for (int i = 0; i < 64; ++i) append(out, static_cast<unsigned>(3 * i), 1);
  return closed_chunk(out);
}

/// 16 colours, mirrored along v.
Bytes palette_texture() {
  Bytes out = texture_header(TexelLayout::kPalette4, 4, 3);
  out[15] = 8;
  for (int i = 0; i < 16; ++i) append(out, static_cast<unsigned>(0x1111 * i), 2);
  for (int i = 0; i < 64; ++i) append(out, static_cast<unsigned>(i), 1);
  return closed_chunk(out);
}

void append_sphere(Bytes& out, const BoundingSphere& sphere) {
  append_u16(out, {sphere.middle.x, sphere.middle.y, sphere.middle.z, sphere.radius});
}

constexpr BoundingSphere kAll{{-1, 2, -3}, 65535};
constexpr BoundingSphere kFirst{{1, -2, 3}, 40000};
constexpr BoundingSphere kSecond{{4, 4, 0}, 7};

Bytes model_chunk() {
  Bytes out;
  append(out, 4, 4);
  append_sphere(out, kAll);
  for (int i = 0; i < 4; ++i) append(out, 0x3FF0000000000000, 8);  // 1.0
  return out;
}

Bytes part_record(std::uint16_t flags, std::uint16_t texture, const BoundingSphere& sphere,
                  std::string_view name) {
  Bytes out;
  append_u16(out, {1, 2, 3, 4, 5, 6, 7, 8, 0x8000});
  append_u16(out, {256, flags, texture});
  append_sphere(out, sphere);
  out.insert(out.end(), name.begin(), name.end());
  out.resize(64);
  return out;
}

Bytes parts_chunk() {
  Bytes out = part_record(5, 1, kFirst, "of thirty-one characters, filled");
  out[63] = 0;
  const Bytes second = part_record(0, 0xFFFF, kSecond, "second");
  out.insert(out.end(), second.begin(), second.end());
  return out;
}

std::vector<TestChunk> model_chunks() {
  return {{"MESH", 0, full_mesh()},   {"MESH", 1, plain_mesh()},   {"MODL", 0, model_chunk()},
          {"PART", 0, parts_chunk()}, {"TXTR", 0, grey_texture()}, {"TXTR", 1, palette_texture()}};
}

Status status_of(const std::vector<TestChunk>& chunks) {
  const Bytes file = file_of(chunks);
  StoredModel model;
  const Status status = view_model_binary(file, model);
  if (!ok(status)) CHECK(model.part_count() == 0);
  return status;
}

/// The status with some bytes of a chunk changed.
Status status_with(std::size_t chunk, std::size_t at, std::uint64_t value, int bytes) {
  std::vector<TestChunk> chunks = model_chunks();
  put(chunks[chunk].bytes, at, value, bytes);
  return status_of(chunks);
}

Status status_without(std::size_t chunk) {
  std::vector<TestChunk> chunks = model_chunks();
  chunks.erase(chunks.begin() + static_cast<std::ptrdiff_t>(chunk));
  return status_of(chunks);
}

/// The status with a chunk of another size.
Status status_resized(std::size_t chunk, int by) {
  std::vector<TestChunk> chunks = model_chunks();
  Bytes& bytes = chunks[chunk].bytes;
  bytes.resize(bytes.size() + static_cast<std::size_t>(by));
  return status_of(chunks);
}

/// The sum of all that a part refers to, which a sanitizer sees.
std::int64_t sum_of(const ModelPart& part) {
  auto sum = static_cast<std::int64_t>(std::strlen(part.name));
  for (std::size_t i = 0; i < part.mesh.vertex_count(); ++i) {
    sum += part.mesh.position(i).x + part.mesh.normal(i).v + part.mesh.texture_point(i).u +
           part.mesh.colour(i).b;
  }
  for (std::size_t i = 0; i < part.mesh.triangle_count(); ++i) {
    const TriangleIndices t = part.mesh.triangle(i);
    CHECK(
        (t.a < part.mesh.vertex_count() && t.b < part.mesh.vertex_count() && t.c < part.mesh.vertex_count()));
    if (part.mesh.planes() != nullptr) sum += part.mesh.planes()[i].offset;
  }
  for (const std::uint8_t texel : part.texture.texels) sum += texel;
  for (const std::uint16_t colour : part.texture.palette) sum += colour;
  return sum;
}

}  // namespace

TEST_CASE("the parts of a model binary are used where they lie") {
  const Bytes file = file_of(model_chunks());
  StoredModel model;
  REQUIRE(ok(view_model_binary(file, model)));
  REQUIRE(model.part_count() == 2);
  CHECK(model.most_vertices() == 4);
  CHECK(model.sphere() == kAll);
  const ModelPart first = model.part(0);
  CHECK(std::string_view(first.name) == "of thirty-one characters, fille");
  CHECK(first.two_sided);
  CHECK(first.alpha == PartAlpha::kBlended);
  CHECK(first.sphere == kFirst);
  CHECK(first.material.ambient.b.raw() == 3);
  CHECK(first.material.diffuse.r.raw() == 4);
  CHECK(first.material.specular.g.raw() == 8);
  CHECK(first.material.specular.b.raw() == 0x8000);
  CHECK(first.material.shininess == 256);
  const ModelPart second = model.part(1);
  CHECK(std::string_view(second.name) == "second");
  CHECK_FALSE(second.two_sided);
  CHECK(second.alpha == PartAlpha::kOpaque);
  CHECK(second.sphere == kSecond);
  CHECK(second.texture.texels.empty());
}

TEST_CASE("the meshes of a model binary have all their arrays, or those that are there") {
  const Bytes file = file_of(model_chunks());
  StoredModel model;
  REQUIRE(ok(view_model_binary(file, model)));
  const MeshView full = model.part(0).mesh;
  REQUIRE(full.vertex_count() == 3);
  REQUIRE(full.triangle_count() == 2);
  CHECK(full.position(1) == ObjectPosition{-2, -32768, 6});
  CHECK(full.normal(2) == PackedNormal{32767, 0});
  CHECK(full.triangle(0).a == 2);
  CHECK(full.triangle(0).c == 1);
  CHECK(full.triangle(1).b == 1);
  REQUIRE(full.planes() != nullptr);
  CHECK(full.planes()[0] == FacePlane{-127, 2, 127, -1});
  CHECK(full.planes()[1] == FacePlane{127, -2, -127, 1});
  CHECK(full.plane_scale() == PlaneScale{-5, 14, 32786});
  CHECK(full.texture_scale() == TextureScale{12});
  CHECK(full.texture_point(2) == TexturePoint{-32768, 32767});
  CHECK(full.colour(2) == Rgb8{0, 5, 128});
  const MeshView plain = model.part(1).mesh;
  REQUIRE(plain.vertex_count() == 4);
  REQUIRE(plain.triangle_count() == 2);
  CHECK(plain.position(3) == ObjectPosition{0, 9, 0});
  CHECK(plain.normal(3) == PackedNormal{7, 8});
  CHECK(plain.triangle(1).b == 2);
  CHECK(plain.triangle(1).c == 3);
  CHECK(plain.planes() == nullptr);
  CHECK(plain.texture_point(0) == TexturePoint{});
  CHECK(plain.colour(0) == Rgb8{255, 255, 255});
}

TEST_CASE("the textures of a model binary are read where they lie") {
  const Bytes file = file_of(model_chunks());
  StoredModel model;
  REQUIRE(ok(view_model_binary(file, model)));
  const StoredTexture stored = model.part(0).texture;
  Texture<Palette4Texels<>> texture;
  REQUIRE(ok(view_texture(stored, texture)));
  CHECK(texture.size() == TextureSize{4, 3, 1});
  CHECK(texture.sampler() ==
        TextureSampler{TextureWrap::kRepeat, TextureWrap::kMirror, TextureFilter::kNearest});
  REQUIRE(stored.palette.size() == 16);
  CHECK(stored.palette[15] == 0xFFFF);
  CHECK(stored.texels[63] == 63);
}

TEST_CASE("chunks of other tags are left alone: a model binary may have more than a program knows") {
  std::vector<TestChunk> chunks = model_chunks();
  chunks.insert(chunks.begin() + kTexture0, {"SKIN", 1, {1, 2, 3}});
  chunks.insert(chunks.begin() + kModel, {"MESI", 0, Bytes(100, 0xFF)});
  chunks.insert(chunks.begin(), {"CLIP", 0, {}});
  chunks.push_back({"ZZZZ", 0xFFFFFFFF, {9}});
  const Bytes file = file_of(chunks);
  StoredModel model;
  REQUIRE(ok(view_model_binary(file, model)));
  CHECK(std::string_view(model.part(1).name) == "second");
  CHECK(model.part(1).mesh.vertex_count() == 4);
  CHECK(model.part(0).texture.palette.size() == 16);
  CHECK(model.chunks().size() == chunks.size());
  const std::span<const std::uint8_t> skin = model.chunks().find(chunk_tag('S', 'K', 'I', 'N'), 1);
  REQUIRE(skin.size() == 3);
  CHECK(skin[2] == 3);
  CHECK(model.chunks().find(chunk_tag('S', 'K', 'I', 'N'), 0).data() == nullptr);
}

TEST_CASE("a model binary may have no parts") {
  Bytes head = model_chunk();
  put(head, 0, 0, 4);
  CHECK(status_of({{"MODL", 0, head}, {"PART", 0, {}}}) == Status::kOk);
  CHECK(status_of({{"MODL", 0, head}}) == Status::kCorrupted);
  StoredModel none;
  CHECK(none.part_count() == 0);
  CHECK(none.most_vertices() == 0);
  CHECK(none.sphere() == BoundingSphere{});
}

TEST_CASE("a model binary needs its chunks, each of the right size") {
  REQUIRE(ok(status_of(model_chunks())));
  for (const std::size_t chunk : {kMesh0, kMesh1, kModel, kParts, kTexture0, kTexture1}) {
    CAPTURE(chunk);
    CHECK(status_without(chunk) == Status::kCorrupted);
    CHECK(status_resized(chunk, -4) == Status::kCorrupted);
    CHECK(status_resized(chunk, 4) == Status::kCorrupted);
  }
  CHECK(status_resized(kParts, -64) == Status::kCorrupted);  // one part, two meshes
  CHECK(status_resized(kParts, 64) == Status::kCorrupted);
  CHECK(status_of({}) == Status::kCorrupted);
  std::vector<TestChunk> chunks = model_chunks();
  chunks[kMesh1].number = 2;
  CHECK(status_of(chunks) == Status::kCorrupted);
  chunks = model_chunks();
  chunks[kModel].number = 1;
  CHECK(status_of(chunks) == Status::kCorrupted);
  chunks = model_chunks();
  std::swap(chunks[kMesh0].bytes, chunks[kMesh1].bytes);  // the largest part is the first
  CHECK(status_of(chunks) == Status::kOk);
  CHECK(status_with(kModel, 0, 3, 4) == Status::kCorrupted);  // vertices of the largest part
  CHECK(status_with(kModel, 0, 5, 4) == Status::kCorrupted);
}

TEST_CASE("materials, flags, textures and names of a model binary's parts are checked") {
  for (std::size_t at = 0; at < 18; at += 2) {
    CAPTURE(at);
    CHECK(status_with(kParts, at, 0x8000, 2) == Status::kOk);
    CHECK(status_with(kParts, at, 0x8001, 2) == Status::kCorrupted);
    CHECK(status_with(kParts, 64 + at, 0x8001, 2) == Status::kCorrupted);
  }
  CHECK(status_with(kParts, 18, 1, 2) == Status::kOk);
  CHECK(status_with(kParts, 18, 0, 2) == Status::kCorrupted);
  CHECK(status_with(kParts, 18, 257, 2) == Status::kCorrupted);
  CHECK(status_with(kParts, 20, 3, 2) == Status::kOk);
  CHECK(status_with(kParts, 20, 6, 2) == Status::kCorrupted);  // both masked and blended
  CHECK(status_with(kParts, 20, 8, 2) == Status::kCorrupted);
  CHECK(status_with(kParts, 20, 0x8000, 2) == Status::kCorrupted);
  CHECK(status_with(kParts, 22, 0, 2) == Status::kOk);
  CHECK(status_with(kParts, 22, 2, 2) == Status::kCorrupted);
  CHECK(status_with(kParts, 22, 0xFFFE, 2) == Status::kCorrupted);
  CHECK(status_with(kParts, 63, 'x', 1) == Status::kCorrupted);
  CHECK(status_with(kParts, 127, 'x', 1) == Status::kCorrupted);
}

TEST_CASE("the meshes and textures in a model binary are checked as those by themselves") {
  CHECK(status_with(kMesh0, 0, 'B', 1) == Status::kUnsupported);
  CHECK(status_with(kMesh1, 4, 5, 2) == Status::kUnsupported);   // the version
  CHECK(status_with(kMesh0, 6, 31, 2) == Status::kCorrupted);    // flags
  CHECK(status_with(kMesh0, 8, 1000, 4) == Status::kCorrupted);  // size
  CHECK(status_with(kMesh0, 12, 4, 4) == Status::kCorrupted);    // vertices
  CHECK(status_with(kMesh1, 16, 0xFFFFFFFF, 4) == Status::kCorrupted);
  CHECK(status_with(kMesh0, 62, 3, 1) == Status::kIndexOutOfRange);
  CHECK(status_with(kMesh1, 32 + 40 + 10, 4, 2) == Status::kIndexOutOfRange);
  CHECK(status_with(kMesh0, 68, 9, 1) == Status::kCorrupted);    // scale of planes
  CHECK(status_with(kMesh0, 70, 100, 2) == Status::kCorrupted);  // radius of planes
  CHECK(status_with(kMesh0, 80, 3, 1) == Status::kCorrupted);    // scale of texture points
  CHECK(status_with(kTexture0, 0, 'B', 1) == Status::kUnsupported);
  CHECK(status_with(kTexture1, 4, 1, 2) == Status::kUnsupported);  // the version
  CHECK(status_with(kTexture0, 6, 4, 1) == Status::kCorrupted);    // layout
  CHECK(status_with(kTexture0, 8, 1000, 4) == Status::kCorrupted);
  CHECK(status_with(kTexture0, 12, 4, 1) == Status::kCorrupted);   // width
  CHECK(status_with(kTexture1, 15, 32, 1) == Status::kCorrupted);  // sampler
}

TEST_CASE("a model binary is refused where its container is, and the model keeps its value") {
  Bytes file = file_of(model_chunks());
  StoredModel model;
  REQUIRE(ok(view_model_binary(file, model)));
  Bytes wrong = file;
  wrong[100] ^= 1;
  CHECK(view_model_binary(wrong, model) == Status::kCorrupted);
  wrong.resize(100);
  CHECK(view_model_binary(wrong, model) == Status::kTruncated);
  CHECK(view_model_binary({}, model) == Status::kTruncated);
  wrong = file_of(model_chunks());
  wrong[4] = 2;
  CHECK(view_model_binary(wrong, model) == Status::kUnsupported);
  REQUIRE(model.part_count() == 2);
  CHECK(std::string_view(model.part(1).name) == "second");
}

TEST_CASE("bytes that are changed under a right checksum are refused, or all parts can be read") {
  const Bytes good = file_of(model_chunks());
  Random random(45);
  const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random.bits() % n); };
  int accepted = 0;
  const int cases = share_of(40'000);
  for (int i = 0; i < cases; ++i) {
    Bytes file = good;
    for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
      // Numbers of structure are small, or those of other places.
      file[below(file.size() - 4)] =
          below(2) == 0 ? static_cast<std::uint8_t>(below(256)) : good[below(good.size())];
    }
    close(file);
    StoredModel model;
    if (!ok(view_model_binary(file, model))) continue;
    ++accepted;
    std::int64_t sum = 0;
    for (std::size_t part = 0; part < model.part_count(); ++part) sum += sum_of(model.part(part));
    CHECK(sum > -1'000'000);
  }
  CHECK(accepted > cases / 20);
  CHECK(accepted < cases);
}
