// SPDX-License-Identifier: MIT
// glTF: nodes, primitives, materials, and what can be wrong with them.
#include <arcspan_tools/mesh/file/load.hpp>
#include <arcspan_tools/mesh/gltf/base64.hpp>
#include <arcspan_tools/mesh/gltf/gltf_material.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/srgb.hpp>
#include <catch2/catch.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <algorithm>
#include <cstring>
#include <numbers>

using arcspan::TextureFilter;
using arcspan::TextureSampler;
using arcspan::TextureWrap;
using namespace arcspan::tools;
using namespace arcspan::test;
using nlohmann::json;

namespace {

using Lines = std::vector<std::string>;

template <class T>
std::string bytes_of(std::initializer_list<T> values) {
  std::string bytes(values.size() * sizeof(T), '\0');
  std::memcpy(bytes.data(), values.begin(), bytes.size());
  return bytes;
}

/// The buffer of square(): four positions, their colours, six indices of 16 bits.
std::string buffer() {
  return bytes_of<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) +
         bytes_of<float>({1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0}) + bytes_of<std::uint16_t>({0, 1, 2, 0, 2, 3});
}

/// A square of two triangles in the plane z = 0 with a red material.
json square() {
  return json::parse(R"({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"name": "square", "mesh": 0}],
    "meshes": [{"name": "sheet",
      "primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
    "materials": [{"name": "red",
      "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0, 0, 1], "metallicFactor": 0, "roughnessFactor": 0.5}}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
      {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"},
      {"bufferView": 0, "byteOffset": 48, "componentType": 5126, "count": 4, "type": "VEC3"}],
    "bufferViews": [{"buffer": 0, "byteLength": 96}, {"buffer": 0, "byteOffset": 96, "byteLength": 12}],
    "buffers": [{"uri": "a%20b.bin", "byteLength": 108}]})");
}

Model loaded(const json& gltf, const std::string& bin = buffer()) {
  const TemporaryFolder folder;
  (void)folder.file("a b.bin", bin);
  return load_model_file(folder.file("a.gltf", gltf.dump()));
}

Model patched(const char* pointer, const json& value) {
  json gltf = square();
  gltf[json::json_pointer(pointer)] = value;
  return loaded(gltf);
}

std::string complaint(const std::string& text, const std::string& bin = buffer(),
                      const std::string& name = "a.gltf") {
  const TemporaryFolder folder;
  (void)folder.file("a b.bin", bin);
  const std::string path = folder.file(name, text);
  const std::string message = message_of<Failure>([&] { (void)load_model_file(path); });
  const std::string prefix = path + ": ";
  return message.rfind(prefix, 0) == 0 ? message.substr(prefix.size()) : "(without the name) " + message;
}

std::string complaint(const char* pointer, const json& value) {
  json gltf = square();
  gltf[json::json_pointer(pointer)] = value;
  return complaint(gltf.dump());
}

std::vector<Vec3> normals_of(const Model& model) { return model.parts[0].mesh.normals; }

std::string little(std::size_t value) { return bytes_of<std::uint32_t>({static_cast<std::uint32_t>(value)}); }

std::string glb(const json& gltf, const std::string& bin) {
  std::string text = gltf.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::string chunks =
      little(text.size()) + "JSON" + text + little(bin.size()) + std::string("BIN\0", 4) + bin;
  return "glTF" + little(2) + little(12 + chunks.size()) + chunks;
}

}  // namespace

TEST_CASE("glTF: a mesh with its names and its material") {
  const Model model = loaded(square());
  REQUIRE(model.parts.size() == 1);
  CHECK(model.parts[0].look.names == Lines{"sheet", "square"});
  CHECK(model.parts[0].look.material.name == "red");
  CHECK(model.parts[0].mesh.triangles.size() == 2);
  CHECK(model.parts[0].mesh.positions.size() == 4);
  for (const Vec3& n : model.parts[0].mesh.normals) CHECK(n == Vec3{0, 0, 1});
  CHECK(model.warnings.empty());
}

TEST_CASE("glTF: a .glb, a buffer in base64, and one in a file are the same") {
  const Model file = loaded(square());
  json gltf = square();
  gltf["buffers"][0].erase("uri");
  const TemporaryFolder folder;
  const Model binary = load_model_file(folder.file("a.glb", glb(gltf, buffer())));
  gltf["buffers"][0]["uri"] =
      "data:application/octet-stream;base64,"
      "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAAAAAAAAgD8AAAAAAACAPwAAAAAAAAAAAACAPwAAAAAAAAAAAACAPw"
      "AA"
      "AAAAAAAAAACAPwAAAAAAAAAAAAABAAIAAAACAAMA";
  const Model embedded = loaded(gltf);
  CHECK(binary.parts[0].mesh.positions == file.parts[0].mesh.positions);
  CHECK(embedded.parts[0].mesh.positions == file.parts[0].mesh.positions);
  CHECK(embedded.parts[0].mesh.triangles == file.parts[0].mesh.triangles);
}

TEST_CASE("base64") {
  CHECK(from_base64("aGVsbG8=") == "hello");
  CHECK(from_base64("aGVsbG8") == "hello");
  CHECK(from_base64("") == "");
  CHECK_FALSE(from_base64("aGVsb"));
  CHECK_FALSE(from_base64("aGV!"));
}

TEST_CASE("glTF: nodes put meshes in their place; a mirror keeps the front in front") {
  json gltf = square();
  gltf["nodes"] = json::parse(R"([{"children": [1, 2], "translation": [10, 0, 0]},
    {"mesh": 0, "rotation": [0.7071067811865476, 0, 0, 0.7071067811865476], "scale": [2, 2, 2]},
    {"mesh": 0, "matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1]}])");
  const Model model = loaded(gltf);
  REQUIRE(model.parts.size() == 1);  // the same look
  const MeshData& mesh = model.parts[0].mesh;
  REQUIRE(mesh.triangles.size() == 4);
  const auto corner = [&](std::size_t triangle, std::size_t i) {
    return mesh.positions[mesh.triangles[triangle][i]];
  };
  // A quarter turn about x takes y to z and z to -y.
  CHECK(length(corner(0, 2) - Vec3{12, 0, 2}) < 1e-12);
  CHECK(length(mesh.normals[mesh.triangles[0][0]] - Vec3{0, -1, 0}) < 1e-12);
  CHECK(length(corner(2, 1) - Vec3{9, 1, 5}) < 1e-12);
  CHECK(length(mesh.normals[mesh.triangles[2][0]] - Vec3{0, 0, 1}) < 1e-12);
  const Vec3 area = cross(corner(2, 1) - corner(2, 0), corner(2, 2) - corner(2, 0));
  CHECK(area.z > 0);
}

TEST_CASE("glTF: normals turn with the inverse transposed matrix") {
  json gltf = square();
  gltf["nodes"][0]["scale"] = {1, 1, 4};
  gltf["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = 2;
  std::string bin = buffer();
  bin.replace(48, 48, bytes_of<float>({0, .6f, .8f, 0, .6f, .8f, 0, .6f, .8f, 0, .6f, .8f}));
  const Vec3 expected = normalised(Vec3{0, 0.6, 0.2});
  for (const Vec3& n : normals_of(loaded(gltf, bin))) CHECK(length(n - expected) < 1e-6);
}

TEST_CASE("glTF: strips, fans, unindexed and sparse primitives; without normals they are flat") {
  const Model listed = loaded(square());
  const std::string strip = buffer().substr(0, 96) + bytes_of<std::uint16_t>({0, 1, 3, 2, 0, 0});
  json gltf = square();
  gltf["accessors"][1]["count"] = 4;
  gltf["meshes"][0]["primitives"][0]["mode"] = 5;
  CHECK(loaded(gltf, strip).parts[0].mesh.triangles.size() == 2);
  for (const Vec3& n : normals_of(loaded(gltf, strip))) CHECK(n == Vec3{0, 0, 1});
  gltf["meshes"][0]["primitives"][0]["mode"] = 6;
  gltf["meshes"][0]["primitives"][0].erase("indices");
  CHECK(loaded(gltf).parts[0].mesh.positions == listed.parts[0].mesh.positions);
  CHECK(loaded(gltf).parts[0].mesh.triangles == listed.parts[0].mesh.triangles);
  gltf["meshes"][0]["primitives"][0]["mode"] = 1;
  CHECK(complaint(gltf.dump()) == "no faces");
  json sparse = square();
  sparse["accessors"][0]["sparse"] =
      json::parse(R"({"count": 1, "indices": {"bufferView": 1, "byteOffset": 4, "componentType": 5123},
                     "values": {"bufferView": 0, "byteOffset": 52}})");
  const std::vector<Vec3> positions = loaded(sparse).parts[0].mesh.positions;
  CHECK(std::count(positions.begin(), positions.end(), Vec3{0, 0, 1}) > 0);
  CHECK(std::count(positions.begin(), positions.end(), Vec3{1, 1, 0}) == 0);
  // Both triangles are in one plane, so a fold is needed to see that its edge is sharp.
  std::string fold = buffer();
  fold.replace(36, 12, bytes_of<float>({0, 1, 1}));
  CHECK(loaded(square(), fold).parts[0].mesh.positions.size() == 6);
}

TEST_CASE("glTF: colours are linear, and become display values") {
  CHECK(to_srgb(0.0) == 0);
  CHECK(to_srgb(1.0) == Approx(1));
  CHECK(to_srgb(0.5) == Approx(0.735357).epsilon(1e-5));
  CHECK(to_srgb(0.002) == Approx(0.02584));
  const FileMaterial red = loaded(square()).parts[0].look.material;
  REQUIRE(red.colour);
  CHECK(red.colour->x == Approx(to_srgb(0.5)));
  CHECK(red.colour->y == 0);
  // Vertex colours are multiplied by the base colour before.
  const FileMaterial vertices =
      patched("/meshes/0/primitives/0/attributes/COLOR_0", 2).parts[0].look.material;
  CHECK(vertices.colour->x == Approx(to_srgb(0.5)).margin(0.002));
  CHECK(vertices.shininess == red.shininess);
}

TEST_CASE("glTF: metallic and roughness as Phong's model") {
  const FileMaterial plastic = phong_of({0.5, 0.5, 0.5}, 0, 0.5).material;
  CHECK(plastic.colour->x == Approx(to_srgb(0.5)));
  CHECK(plastic.shininess == 30);
  CHECK(plastic.specular->x == Approx(to_srgb(0.16)));
  const FileMaterial metal = phong_of({0.8, 0.4, 0}, 1, 0.5).material;
  CHECK(metal.colour->x == Approx(to_srgb(0.4)));
  CHECK(metal.specular->x == Approx(1));
  CHECK(metal.specular->z == 0);
  CHECK(phong_of({1, 1, 1}, 0, 1).material.shininess == 1);
  CHECK(phong_of({1, 1, 1}, 0, 0).material.shininess == 256);
  const FileMaterial old = patched("/materials/0/extensions", json::parse(R"({
      "KHR_materials_pbrSpecularGlossiness":
        {"diffuseFactor": [0, 1, 0, 1], "specularFactor": [0, 0, 0], "glossinessFactor": 0.5}})"))
                               .parts[0]
                               .look.material;
  CHECK(*old.colour == Vec3{0, to_srgb(1.0), 0});
  CHECK(*old.specular == Vec3{0, 0, 0});
  CHECK(old.shininess == 30);
}

TEST_CASE("glTF: unlit, two-sided and glowing materials") {
  CHECK_FALSE(loaded(square()).parts[0].look.material.unlit);
  CHECK_FALSE(loaded(square()).parts[0].look.material.two_sided);
  CHECK(patched("/materials/0/extensions", {{"KHR_materials_unlit", json::object()}})
            .parts[0]
            .look.material.unlit);
  CHECK(patched("/materials/0/doubleSided", true).parts[0].look.material.two_sided);
  CHECK(patched("/materials/0/emissiveFactor", {0, 0.5, 0}).parts[0].look.material.emission ==
        Vec3{0, to_srgb(0.5), 0});
}

TEST_CASE("glTF: of an unlit material only the base colour counts") {
  const json unlit = {{"KHR_materials_unlit", json::object()}};
  const auto look = [&unlit](const json& factors) {
    json gltf = square();
    gltf["materials"][0] = {
        {"extensions", unlit}, {"emissiveFactor", {1, 0, 0}}, {"pbrMetallicRoughness", factors}};
    return loaded(gltf).parts[0].look.material;
  };
  const FileMaterial green = look({{"baseColorFactor", {0, 1, 0, 1}}});
  CHECK(*green.colour == to_srgb(Vec3{0, 1, 0}));
  CHECK(green.emission == Vec3{});
  CHECK(*look({{"metallicFactor", 0.5}}).colour == to_srgb(Vec3{1, 1, 1}));
}

TEST_CASE("glTF: a colour or a normal of a vertex that is not finite is left out") {
  json gltf = square();
  gltf["meshes"][0]["primitives"][0]["attributes"] = {{"POSITION", 0}, {"COLOR_0", 2}, {"NORMAL", 2}};
  std::string bin = buffer();
  bin.replace(48 + 16, 4, bytes_of<float>({std::numeric_limits<float>::quiet_NaN()}));
  CHECK(loaded(gltf, bin).warnings == Lines{"left out: normals that are not finite numbers (1), vertex "
                                            "colours that are not finite numbers (1)"});
}

TEST_CASE("glTF: alpha modes of materials with a texture and without") {
  const auto material = [](const json& base, const json& changes) {
    json gltf = square();
    gltf["materials"][0].merge_patch(changes);
    gltf["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = base;
    return loaded(gltf).parts[0].look.material;
  };
  const json quarter = {1, 1, 1, 0.25};
  CHECK(material(quarter, json::object()).opacity == 1);
  CHECK(material(quarter, {{"alphaMode", "BLEND"}}).opacity == 0.25);
  CHECK(material({1, 1, 1}, {{"alphaMode", "BLEND"}}).opacity == 1);
  CHECK(material(quarter, {{"alphaMode", "FOO"}}).opacity == 1);
  CHECK(patched("/materials/0/alphaMode", "FOO").warnings == Lines{"left out: unknown alpha modes (1)"});
  CHECK(material(quarter, {{"alphaMode", "MASK"}}).opacity == 0);
  CHECK(material(quarter, {{"alphaMode", "MASK"}, {"alphaCutoff", 0.2}}).opacity == 1);
  CHECK(material({1, 1, 1}, {{"alphaMode", "MASK"}, {"alphaCutoff", 1}}).opacity == 1);
  CHECK(material({1, 1, 1}, {{"alphaMode", "MASK"}, {"alphaCutoff", 1.5}}).opacity == 0);
  CHECK(material(quarter, {{"alphaMode", "BLEND"}}).alpha_mode == AlphaMode::kBlend);
}

TEST_CASE("glTF: opacity of vertices is left out, with a warning where it would be seen") {
  json gltf = square();
  gltf["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = 3;
  gltf["accessors"].push_back(
      {{"bufferView", 2}, {"componentType", 5121}, {"normalized", true}, {"count", 4}, {"type", "VEC4"}});
  gltf["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 108}, {"byteLength", 16}});
  gltf["buffers"][0]["byteLength"] = 124;
  const std::string bin = buffer() + "\xFF\xFF\xFF\xFF\xFF\xFF\xFF\x40\xFF\xFF\xFF\xFF\xFF\xFF\xFF\x40";
  CHECK(loaded(gltf, bin).warnings.empty());
  gltf["materials"][0]["alphaMode"] = "BLEND";
  CHECK(loaded(gltf, bin).warnings == Lines{"left out: opacity of vertices (2)"});
}

TEST_CASE("glTF: what is not drawn is named once") {
  json gltf = square();
  gltf["materials"][0]["normalTexture"] = {{"index", 0}};
  gltf["materials"][0]["alphaMode"] = "BLEND";
  gltf["materials"][0]["extensions"] = {{"KHR_materials_clearcoat", json::object()}};
  gltf["animations"] = json::array({json::object()});
  gltf["nodes"][0]["extensions"] = {{"EXT_mesh_gpu_instancing", json::object()}};
  gltf["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 0}});
  gltf["cameras"] = json::array({json::object()});
  CHECK(
      loaded(gltf).warnings ==
      Lines{
          "an animation is left out: animations[0]: 'samplers' is missing",
          "left out: EXT_mesh_gpu_instancing (1), KHR_materials_clearcoat (1), cameras (1), points and lines "
          "(1), textures other than the base colour's (1)"});
}

TEST_CASE("glTF: corners that make no whole triangle are said") {
  json gltf = square();
  gltf["accessors"][1]["count"] = 5;
  const Model model = loaded(gltf);
  CHECK(model.triangle_count() == 1);
  CHECK(model.warnings == Lines{"left out: incomplete triangles (1)"});
  json fan = square();
  fan["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"indices", 1}, {"mode", 6}});
  CHECK(loaded(fan).warnings.empty());
  fan["accessors"].push_back(fan["accessors"][1]);
  fan["accessors"][3]["count"] = 2;
  fan["meshes"][0]["primitives"][1]["indices"] = 3;
  CHECK(loaded(fan).warnings == Lines{"left out: incomplete triangles (1)"});
}

TEST_CASE("glTF: a primitive without a material is white") {
  json gltf = square();
  gltf["meshes"][0]["primitives"][0].erase("material");
  CHECK(loaded(gltf).parts[0].look.material.colour == Vec3{to_srgb(1.0), to_srgb(1.0), to_srgb(1.0)});
}

TEST_CASE("glTF: a skinned mesh is where its joints are, wherever its own node is") {
  json gltf = square();
  gltf["nodes"] = json::parse(R"([{"mesh": 0, "skin": 0, "translation": [100, 0, 0]},
    {"translation": [0, 5, 0], "children": [2]},
    {"rotation": [0, 0, 0.7071067811865476, 0.7071067811865476]}])");
  gltf["scenes"][0]["nodes"] = {0, 1};
  gltf["skins"] = json::array({{{"joints", {1, 2}}, {"inverseBindMatrices", 5}}});
  gltf["meshes"][0]["primitives"][0]["attributes"] = {{"POSITION", 0}, {"JOINTS_0", 3}, {"WEIGHTS_0", 4}};
  const auto accessor = [&gltf](int type, std::size_t count, const char* of, std::size_t from,
                                std::size_t bytes) {
    gltf["accessors"].push_back({{"bufferView", gltf["bufferViews"].size()},
                                 {"componentType", type},
                                 {"count", count},
                                 {"type", of}});
    gltf["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", from}, {"byteLength", bytes}});
  };
  accessor(5121, 4, "VEC4", 108, 16);
  accessor(5126, 4, "VEC4", 124, 64);
  accessor(5126, 2, "MAT4", 188, 128);
  gltf["buffers"][0]["byteLength"] = 316;
  // The first corner hangs on joint 0, the second on 1, the third on both, the fourth on 0 with weights
  // whose sum is not 1. Joint 1 turns a quarter about z; its inverse bind matrix moves by 1 along x and z.
  const std::string bin = buffer() +
                          bytes_of<std::uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}) +
                          bytes_of<float>({1, 0, 0, 0, 1, 0, 0, 0, .5f, .5f, 0, 0, .5f, 0, 0, 0}) +
                          bytes_of<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}) +
                          bytes_of<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 1, 1});
  const Model model = loaded(gltf, bin);
  const MeshData& mesh = model.parts[0].mesh;
  const auto corner = [&](std::size_t triangle, std::size_t i) {
    return mesh.positions[mesh.triangles[triangle][i]];
  };
  CHECK(length(corner(0, 0) - Vec3{0, 5, 0}) < 1e-12);
  CHECK(length(corner(0, 1) - Vec3{0, 7, 1}) < 1e-12);      // (2, 0, 1), turned
  CHECK(length(corner(0, 2) - Vec3{0, 6.5, 0.5}) < 1e-12);  // (1, 6, 0) and (-1, 7, 1)
  CHECK(length(corner(1, 2) - Vec3{0, 6, 0}) < 1e-12);
  CHECK(model.warnings.empty());
  gltf["skins"][0]["joints"] = {1};
  CHECK(complaint(gltf.dump(), bin) ==
        "meshes[0].primitives[0].attributes.JOINTS_0: a joint is out of range");
  gltf["skins"][0]["joints"] = {1, 2};
  gltf["scenes"][0]["nodes"] = {0};
  CHECK(complaint(gltf.dump(), bin) == "skins[0].joints[0]: is a node that is not in the scene");
}

TEST_CASE("glTF: the texture of the base colour, beside the file or within it") {
  // A picture of one grey pixel, and texture coordinates in place of the colours.
  const std::string picture = std::string("P5\n1 1\n255\n") + '\x80';
  json gltf = square();
  gltf["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}, {"texCoord", 1}};
  gltf["materials"][0]["alphaMode"] = "MASK";
  gltf["materials"][0]["alphaCutoff"] = 0.25;
  gltf["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"] = 3;
  gltf["accessors"].push_back({{"bufferView", 2}, {"componentType", 5126}, {"count", 4}, {"type", "VEC2"}});
  gltf["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 108}, {"byteLength", 32}});
  gltf["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 140}, {"byteLength", picture.size()}});
  gltf["buffers"][0]["byteLength"] = 140 + picture.size();
  gltf["textures"] = json::array({{{"source", 0}}});
  gltf["images"] = json::array({{{"uri", "grey.pgm"}}});
  const std::string bin = buffer() + bytes_of<float>({0, 0, 1, 0, 1, 0.5, 0, 0.5}) + picture;
  const TemporaryFolder folder;
  (void)folder.file("a b.bin", bin);
  (void)folder.file("grey.pgm", picture);
  const auto check = [](const Model& model) {
    CHECK(model.warnings.empty());
    const FileMaterial& material = model.parts[0].look.material;
    REQUIRE(material.texture != nullptr);
    CHECK(material.texture->picture.at(0, 0) == Rgba8{128, 128, 128, 255});
    CHECK(material.alpha_mode == AlphaMode::kMask);
    CHECK(material.alpha_cutoff == 0.25);
    REQUIRE(model.parts[0].mesh.texture_points.size() == 4);
    CHECK(model.parts[0].mesh.texture_points[2] == Uv{1, 0.5});
  };
  check(load_model_file(folder.file("beside.gltf", gltf.dump())));
  gltf["images"][0] = {{"bufferView", 3}, {"mimeType", "image/png"}};
  check(load_model_file(folder.file("within.gltf", gltf.dump())));
  gltf["images"][0] = {{"uri", "data:image/png;base64,UDUKMSAxCjI1NQqA"}};
  check(load_model_file(folder.file("data.gltf", gltf.dump())));
  json hidden = gltf;  // by the alpha of its base colour
  hidden["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0};
  CHECK(load_model_file(folder.file("hidden.gltf", hidden.dump())).parts[0].look.material.alpha_cutoff > 1);

  json& info = gltf["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
  info["extensions"]["KHR_texture_transform"] = {
      {"offset", {0.5, 0.25}}, {"scale", {2, 4}}, {"rotation", std::numbers::pi / 2}};
  const Uv moved = load_model_file(folder.file("moved.gltf", gltf.dump())).parts[0].mesh.texture_points[2];
  CHECK(moved.u == Approx(0.5 + 4 * 0.5));
  CHECK(moved.v == Approx(0.25 - 2 * 1));

  gltf["images"][0] = {{"uri", "none.png"}};
  const Model without = load_model_file(folder.file("none.gltf", gltf.dump()));
  CHECK(without.warnings == Lines{"left out: textures (1): 'none.png' (not in the model's folder)"});
  CHECK(without.parts[0].mesh.texture_points.empty());
  for (const char* wrong : {"data:,P5", "data:image/webp;base64,UklGRgAAAABXRUJQ"}) {
    gltf["images"][0] = {{"uri", wrong}};
    const Model drawn = load_model_file(folder.file("wrong.gltf", gltf.dump()));
    CHECK(drawn.triangle_count() == 2);
    REQUIRE(drawn.warnings.size() == 1);
    CHECK(drawn.warnings[0].starts_with("left out: textures (1): 'images[0]' ("));
  }

  gltf["images"][0] = {{"uri", "data:image/png;base64,UDUKMSAxCjI1NQqA"}};
  gltf["textures"][0]["sampler"] = 0;
  const auto read = [&](const json& sampler) {
    gltf["samplers"] = json::array({sampler});
    return load_model_file(folder.file("sampler.gltf", gltf.dump()));
  };
  const auto sampler_of = [&](const json& sampler) {
    const Model model = read(sampler);
    CHECK(model.warnings.empty());
    return model.parts[0].look.material.sampler;
  };
  constexpr auto kRepeat = TextureWrap::kRepeat;
  constexpr auto kBilinear = TextureFilter::kBilinear;
  CHECK(sampler_of(json::object()) == TextureSampler{});
  CHECK(sampler_of({{"wrapS", 10497}, {"magFilter", 9728}, {"minFilter", 9986}}) == TextureSampler{});
  CHECK(sampler_of({{"wrapS", 33071}}) == TextureSampler{TextureWrap::kClamp, kRepeat});
  CHECK(sampler_of({{"wrapT", 33648}}) == TextureSampler{kRepeat, TextureWrap::kMirror});
  for (const json& linear : {json{{"magFilter", 9729}}, json{{"minFilter", 9987}}, json{{"minFilter", 9985}},
                             json{{"magFilter", 9729}, {"minFilter", 9987}}}) {
    CHECK(sampler_of(linear) == TextureSampler{kRepeat, kRepeat, kBilinear});
  }
  const Model unlike = read({{"magFilter", 9729}, {"minFilter", 9984}, {"wrapS", 10000}});
  CHECK(unlike.warnings ==
        Lines{"left out: filters of textures that differ far away (1), unknown wrapping of "
              "textures, which repeat (1)"});
  CHECK(unlike.parts[0].look.material.sampler == TextureSampler{kRepeat, kRepeat, kBilinear});
}

TEST_CASE("glTF 1.0: lists by name, Phong's materials as they are") {
  const json gltf = json::parse(R"({
    "asset": {"version": "1.0"}, "scene": "s", "scenes": {"s": {"nodes": ["n"]}},
    "nodes": {"n": {"name": "node", "meshes": ["m"]}},
    "meshes": {"m": {"primitives": [{"attributes": {"POSITION": "p"}, "indices": "i", "material": "green"}]}},
    "materials": {"green": {"values": {"diffuse": [0, 0.5, 0, 1], "specular": [0.25, 0, 0, 1], "shininess": 300}}},
    "accessors": {"p": {"bufferView": "v", "byteOffset": 0, "byteStride": 12, "componentType": 5126, "count": 4,
        "type": "VEC3"},
      "i": {"bufferView": "v", "byteOffset": 96, "componentType": 5123, "count": 6, "type": "SCALAR"}},
    "bufferViews": {"v": {"buffer": "b", "byteOffset": 0, "byteLength": 108}},
    "buffers": {"b": {"uri": "a b.bin", "byteLength": 108}}})");
  const Model model = loaded(gltf);
  REQUIRE(model.parts.size() == 1);
  CHECK(model.parts[0].mesh.positions == loaded(square()).parts[0].mesh.positions);
  CHECK(model.parts[0].look.material.colour == Vec3{0, 0.5, 0});
  CHECK(model.parts[0].look.material.specular == Vec3{0.25, 0, 0});
  CHECK(model.parts[0].look.material.shininess == 256);
}

TEST_CASE("glTF: every wrong file gets a line that names the place and the value") {
  CHECK(complaint("{") ==
        "not a glTF file: parse error at line 1, column 2: syntax error while parsing object key - "
        "unexpected end of "
        "input; expected string literal");
  CHECK(complaint("[]") == "not a glTF file");
  CHECK(complaint("{}") == "'asset' is missing");
  CHECK(complaint("/asset/version", "3.0") == "asset.version: '3.0' cannot be read (1.0 and 2.x can)");
  CHECK(complaint("/extensionsRequired", {"KHR_draco_mesh_compression"}) ==
        "needs the extension 'KHR_draco_mesh_compression', which cannot be read");
  CHECK(complaint("/scene", 3) == "scene: there is no scenes[3]");
  CHECK(complaint("/nodes/0/mesh", "x") == "nodes[0].mesh: there is no 'x' in meshes");
  CHECK(complaint("/nodes/0/children", {0}) == "nodes[0]: is a child of two nodes, or of itself");
  CHECK(complaint("/nodes/0/matrix", {1, 2}) == "nodes[0].matrix: is not an array of 16 numbers");
  CHECK(complaint("/nodes/0/rotation", {0, 0, 0, 0}) == "nodes[0].rotation: is no rotation");
  CHECK(complaint("/nodes/0/translation", {1e300, 1e300, 1e300})
            .find("POSITION: a coordinate is not a number up to 1e30") != std::string::npos);
  CHECK(complaint("/meshes/0/primitives/0/mode", 7) ==
        "meshes[0].primitives[0].mode: is not an integer 0 to 6 (7)");
  CHECK(complaint("/meshes/0/primitives/0/attributes", json::object()) ==
        "meshes[0].primitives[0].attributes: 'POSITION' is missing");
  CHECK(complaint("/meshes/0/primitives/0/material", 1) ==
        "meshes[0].primitives[0].material: there is no materials[1]");
  CHECK(complaint("/accessors/0/count", 9) == "accessors[0]: reaches beyond its buffer view");
  CHECK(complaint("/accessors/0/count", 3) ==
        "meshes[0].primitives[0].indices: index out of range (3; there are 3 vertices)");
  CHECK(complaint("/accessors/0/count", -1) == "accessors[0].count: is not an integer 0 to 4194304 (-1)");
  CHECK(complaint("/accessors/0/type", "VEC2") ==
        "accessors[0].type: elements of 2 components do not fit here");
  CHECK(complaint("/accessors/0/componentType", 1) == "accessors[0].componentType: is not a component type");
  CHECK(complaint("/bufferViews/0/byteLength", 999) == "bufferViews[0]: reaches beyond its buffer");
  CHECK(complaint("/buffers/0/byteLength", 999) == "buffers[0]: has 108 bytes of 999");
  CHECK(complaint("/buffers/0/uri", "../x.bin") ==
        "buffers[0].uri: cannot read '../x.bin' in the model's folder");
  CHECK(complaint("/buffers/0/uri", "data:;base64,?") == "buffers[0].uri: is not data in base64");
  CHECK(complaint("/materials/0/pbrMetallicRoughness/baseColorFactor", {1, "x", 1}) ==
        "materials[0].pbrMetallicRoughness.baseColorFactor[1]: is not a number");
  std::string infinite = buffer();
  infinite.replace(0, 4, std::string("\0\0\x80\x7F", 4));
  CHECK(complaint(square().dump(), infinite).find("a coordinate is not a number up to 1e30") !=
        std::string::npos);
}

TEST_CASE("glTF: damaged .glb files") {
  json gltf = square();
  gltf["buffers"][0].erase("uri");
  const std::string good = glb(gltf, buffer());
  CHECK(complaint(good.substr(0, 15), "", "a.glb") == "truncated");
  CHECK(complaint(good.substr(0, 99), "", "a.glb").find("truncated (99 bytes of ") == 0);
  std::string old = good;
  old[4] = 1;
  CHECK(complaint(old, "", "a.glb") == "a .glb of version 1 cannot be read");
  std::string longer = good;
  longer[14] = 1;
  CHECK(complaint(longer, "", "a.glb") == "a chunk is longer than the file");
  CHECK(complaint("glTF" + little(2) + little(20) + little(0) + std::string("BIN\0", 4), "", "a.glb") ==
        "no JSON chunk");
}

TEST_CASE("glTF: models of the loader's own collection") {
  const std::string folder = "/usr/share/assimp/models/";
  if (!std::filesystem::exists(folder)) return;
  const Model truck = load_model_file(folder + "glTF/CesiumMilkTruck/CesiumMilkTruck.gltf");
  REQUIRE(truck.parts.size() == 5);
  CHECK(truck.triangle_count() == 3624);
  CHECK(truck.warnings == Lines{"left out: animations (2)"});
  const Model engine = load_model_file(folder + "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb");
  CHECK(engine.parts.size() > 29);
  CHECK(engine.triangle_count() == 110'336);
  for (const char* name : {"BoxTextured-glTF/BoxTextured.gltf", "BoxTextured-glTF-Binary/BoxTextured.glb",
                           "BoxTextured-glTF-Embedded/BoxTextured.gltf",
                           "BoxTextured-glTF-pbrSpecularGlossiness/BoxTextured.gltf",
                           "BoxBadNormals-glTF-Binary/BoxBadNormals.glb",
                           "glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_05.gltf",
                           "cameras/Cameras.gltf", "simple_skin/simple_skin.gltf"}) {
    CAPTURE(name);
    CHECK(load_model_file(folder + "glTF2/" + name).triangle_count() >= 2);
  }
  for (const char* name :
       {"BoxWithInfinites-glTF-Binary/BoxWithInfinites.glb", "IndexOutOfRange/IndexOutOfRange.gltf",
        "MissingBin/BoxTextured.gltf", "RecursiveNodes/RecursiveNodes.gltf", "draco/2CylinderEngine.gltf",
        "SchemaFailures/sceneWrongType.gltf", "TestNoRootNode/SceneWithoutNodes.gltf"}) {
    CAPTURE(name);
    CHECK_THROWS_AS(load_model_file(folder + "glTF2/" + name), Failure);
  }
}
