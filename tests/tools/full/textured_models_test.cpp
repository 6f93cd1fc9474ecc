// SPDX-License-Identifier: MIT
// Textures of model files, and what `arcspan mesh` and `arcspan render` make of them.
#include <arcspan/model/model_binary.hpp>

#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/mesh/compile/simplify.hpp>
#include <arcspan_tools/mesh/file/load.hpp>
#include <arcspan_tools/output/mesh_writer.hpp>
#include <arcspan_tools/output/texture_writer.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <catch2/catch.hpp>
#include <sign.hpp>  // made by the build from models/sign.obj
#include <tests/tools/command_run.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

using namespace arcspan;
using namespace arcspan::tools;
using namespace arcspan::test;

namespace {

const std::string kSign = ARCSPAN_MODELS "/sign.obj";
const std::string kTiles = ARCSPAN_MODELS "/tiles.ppm";

constexpr TextureSampler kClamped{TextureWrap::kClamp, TextureWrap::kClamp};

/// A square of two faces, the second with a texture coordinate of its own, and its material.
const std::string kSquare =
    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 3 0.25\n"
    "usemtl m\nf 1/1 2/2 3/3\nf 1/5 3/3 4/4\n";

Model loaded(const std::string& obj, const std::string& mtl,
             TexturePointsOf points = TexturePointsOf::kTexturedParts) {
  const TemporaryFolder folder;
  (void)folder.file("a.mtl", mtl);
  (void)folder.file("tiles.ppm", contents(kTiles));
  return load_model_file(folder.file("a.obj", obj), points);
}

}  // namespace

TEST_CASE("an OBJ with a texture: its picture, points with v down, vertices split at seams") {
  const Model model = loaded(kSquare, "newmtl m\nKd 0.5 0.5 0.5\nmap_Kd tiles.ppm\n");
  CHECK(model.warnings.empty());
  REQUIRE(model.parts.size() == 1);
  const FileMaterial& material = model.parts[0].look.material;
  REQUIRE(material.texture != nullptr);
  CHECK(material.texture->picture.width == 16);
  CHECK(material.colour == Vec3{0.5, 0.5, 0.5});
  CHECK(material.alpha_mode == AlphaMode::kOpaque);
  const MeshData& mesh = model.parts[0].mesh;
  REQUIRE(mesh.positions.size() == 5);  // the corner at the origin has two texture points
  REQUIRE(mesh.texture_points.size() == 5);
  CHECK(mesh.texture_points[mesh.triangles[0][0]] == Uv{0, 1});
  CHECK(mesh.texture_points[mesh.triangles[0][2]] == Uv{1, 0});
  CHECK(mesh.texture_points[mesh.triangles[1][0]] == Uv{3, 0.75});
}

TEST_CASE("OBJ: of paths on the exporter's machine the last parts are looked for beside the model") {
  for (const std::string folder : {"/home/me/my tex/", "C:\\Users\\my tex\\", "C:/Users/me/", "../tex/"}) {
    const Model model = loaded(kSquare, "newmtl m\nmap_Kd " + folder + "tiles.ppm\n");
    CHECK(model.warnings.empty());
    CHECK(model.parts[0].look.material.texture != nullptr);
    if (folder == "../tex/") continue;
    const Model library = loaded("mtllib " + folder + kSquare.substr(7), "newmtl m\nmap_Kd tiles.ppm\n");
    CHECK(library.warnings.empty());
    CHECK(library.parts[0].look.material.texture != nullptr);
  }
}

TEST_CASE("texture coordinates that nothing uses split no vertex") {
  const Model model = loaded(kSquare, "newmtl m\n");
  CHECK(model.parts[0].mesh.positions.size() == 4);
  CHECK(model.parts[0].mesh.texture_points.empty());
  const Model all = loaded(kSquare, "newmtl m\n", TexturePointsOf::kAllParts);
  CHECK(all.parts[0].mesh.positions.size() == 5);
}

TEST_CASE("what is wrong with a model's textures is left out, with a warning") {
  using Lines = std::vector<std::string>;
  CHECK(loaded(kSquare, "newmtl m\nmap_Kd none.png\n").warnings ==
        Lines{"left out: textures (1): 'none.png' (not in the model's folder)"});
  const Model options =
      loaded(kSquare, "newmtl m\nKd 0 0 0\nmap_Kd -s 2 2 1 -clamp on -blendv on tiles.ppm\n");
  CHECK(options.warnings == Lines{"left out: map_Kd -blendv (1), map_Kd -s (1)"});
  CHECK(options.parts[0].look.material.sampler == kClamped);
  CHECK(options.parts[0].look.material.texture != nullptr);
  CHECK(options.parts[0].look.material.colour == Vec3{1, 1, 1});  // black would hide it
  const Model bare =
      loaded("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl m\nf 1 2 3\n", "newmtl m\nmap_Kd tiles.ppm\n");
  CHECK(bare.parts[0].look.material.texture == nullptr);
  CHECK(bare.warnings ==
        Lines{"parts with a texture but without texture coordinates are drawn without it (1)"});
  const Model far = loaded("vt 5000 0\n" + kSquare + "f 1/1 2/2 3/3\n", "newmtl m\nmap_Kd tiles.ppm\n");
  CHECK(far.parts[0].look.material.texture == nullptr);
  const Lines far_away{
      "parts whose texture coordinates are more than 4000 apart, or 2000 from a clamped texture, are drawn "
      "without their texture (1)"};
  CHECK(far.warnings == far_away);
  const std::string beyond = "vt 2100 0\nvt 2101 0\nvt 2100 1\n" + kSquare + "f 1/1 2/2 3/3\n";
  CHECK(loaded(beyond, "newmtl m\nmap_Kd -clamp off tiles.ppm\n").warnings.empty());
  CHECK(loaded(beyond, "newmtl m\nmap_Kd -clamp on tiles.ppm\n").warnings == far_away);
  const std::string tiles = contents(kTiles);
  for (const std::string& picture :
       {tiles.substr(0, 100), std::string("GIF89a"), std::string("RIFF----WEBPVP8 "), std::string()}) {
    const TemporaryFolder folder;
    (void)folder.file("a.mtl", "newmtl m\nmap_Kd tiles.ppm\n");
    (void)folder.file("tiles.ppm", picture);
    const Model model = load_model_file(folder.file("a.obj", kSquare));
    CHECK(model.triangle_count() == 2);
    CHECK(model.parts[0].look.material.texture == nullptr);
    REQUIRE(model.warnings.size() == 1);
    CHECK(model.warnings[0].starts_with("left out: textures (1): 'tiles.ppm' ("));
  }
}

TEST_CASE("texture points have as many fraction bits as their range leaves, wherever they lie") {
  const auto scaled = [](double offset, double factor) {
    Model model = loaded(kSquare, "newmtl m\nmap_Kd tiles.ppm\n");
    for (Uv& p : model.parts[0].mesh.texture_points) p = {offset + factor * p.u, factor * p.v};
    return to_fixed(model).meshes[0];
  };
  CHECK(scaled(0, 0.3).texture_scale.fraction_bits == 15);
  CHECK(scaled(0, 1).texture_scale.fraction_bits == 13);  // 0...3, moved to -1...2
  const FixedMesh far = scaled(1000, 1);
  CHECK(far.texture_scale.fraction_bits == 13);
  CHECK(far.texture_points == scaled(0, 1).texture_points);
  CHECK(scaled(0, 1300).texture_scale.fraction_bits == 4);
}

TEST_CASE("texture points are moved only as far as their texture repeats") {
  const auto first_of = [](double offset, TextureWrap u, TextureWrap v) {
    Model model = loaded(kSquare, "newmtl m\nmap_Kd tiles.ppm\n");
    for (Uv& p : model.parts[0].mesh.texture_points) p = {offset + p.u, offset + p.v};
    model.parts[0].look.material.sampler = {u, v};
    const FixedMesh mesh = to_fixed(model).meshes[0];
    const double bits = mesh.texture_scale.fraction_bits;
    return Uv{mesh.texture_points[0].u / std::exp2(bits), mesh.texture_points[0].v / std::exp2(bits)};
  };
  // Coordinates of 0 ... 3 and of 0 ... 1, the first of them 0 and 1.
  CHECK(first_of(0, TextureWrap::kRepeat, TextureWrap::kRepeat) == Uv{-1, 1});
  CHECK(first_of(7, TextureWrap::kRepeat, TextureWrap::kMirror) == Uv{-1, 2});
  CHECK(first_of(7, TextureWrap::kMirror, TextureWrap::kClamp) == Uv{-1, 8});
  CHECK(first_of(6, TextureWrap::kClamp, TextureWrap::kMirror) == Uv{6, 1});
}

TEST_CASE("a model with a sampler is the same as a header, as a binary and compiled again") {
  const TemporaryFolder folder;
  (void)folder.file("tiles.ppm", contents(kTiles));
  (void)folder.file("a.mtl", "newmtl m\nmap_Kd -clamp on tiles.ppm\n");
  const std::string obj = folder.file("a.obj", kSquare);
  const std::string bin = folder / "a.bin";
  REQUIRE(run("mesh " + obj + " -o " + bin).status == 0);
  CHECK(load_model_file(bin).parts[0].look.material.sampler == kClamped);
  REQUIRE(run("mesh " + bin + " -o " + (folder / "again.bin")).status == 0);
  CHECK(contents(folder / "again.bin") == contents(bin));
  CHECK(run("mesh " + obj + " -o hpp:-")
            .out.find("        .with({arcspan::TextureWrap::kClamp, arcspan::TextureWrap::kClamp});\n") !=
        std::string::npos);
  (void)folder.file("a.mtl", "newmtl m\nmap_Kd tiles.ppm\n");
  const auto picture = [&](const std::string& model) {
    REQUIRE(run("render " + model + " -o " + (folder / "p.ppm") + " --size 64x48").status == 0);
    return contents(folder / "p.ppm");
  };
  CHECK(picture(obj) != picture(bin));
}

TEST_CASE("a binary is drawn with the mip levels that it stores") {
  const TemporaryFolder folder;
  (void)folder.file("tiles.ppm", contents(kTiles));
  (void)folder.file("a.mtl", "newmtl m\nmap_Kd tiles.ppm\n");
  const std::string obj = folder.file("a.obj", kSquare);
  const auto drawn = [&](const std::string& levels) {
    const std::string bin = folder / "a.bin";
    REQUIRE(run("mesh " + obj + " --texture-size 64 --texture-format rgb565 --texture-levels " + levels +
                " -o " + bin)
                .status == 0);
    const FileTexture texture = *load_model_file(bin).parts[0].look.material.texture;
    REQUIRE(texture.smaller);
    int width = texture.picture.width;
    for (const RgbaImage& level : *texture.smaller) CHECK(level.width == (width /= 2));
    CHECK(texture.smaller->empty() == (levels == "1"));
    REQUIRE(run("render " + bin + " -o " + (folder / "p.ppm") + " --size 16x12").status == 0);
    return contents(folder / "p.ppm");
  };
  CHECK(drawn("1") != drawn("all"));
}

TEST_CASE("a PLY has texture coordinates of its vertices") {
  const TemporaryFolder folder;
  const std::string path = folder.file(
      "a.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property float s\nproperty float t\nelement face 1\nproperty list uchar int vertex_indices\n"
      "end_header\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 0.75\n3 0 1 2\n");
  const Model model = load_model_file(path, TexturePointsOf::kAllParts);
  REQUIRE(model.parts[0].mesh.texture_points.size() == 3);
  CHECK(model.parts[0].mesh.texture_points[2] == Uv{0, 0.25});
  CHECK(run("render " + path + " -o " + (folder / "a.png") + " --texture " + kTiles).status == 0);
}

TEST_CASE("simplification keeps the seams of a texture, in each of its ways") {
  Model model = load_model_file("sphere:32x16");
  MeshData& mesh = model.parts[0].mesh;
  for (const Vec3& p : mesh.positions) mesh.texture_points.push_back({p.x > 0 ? 1 - p.y : p.y, p.y});
  for (const Simplification how :
       {Simplification::kWithNormals, Simplification::kByPosition, Simplification::kByCells}) {
    const Simplified few = simplify(model, how, 400, 60, "test");
    const MeshData& left = few.model.parts[0].mesh;
    CHECK(left.triangles.size() <= 400);
    REQUIRE(left.texture_points.size() == left.positions.size());
    for (std::size_t i = 0; i < left.positions.size(); ++i) {
      CHECK(left.texture_points[i].v == Approx(left.positions[i].y));  // moved with its vertex
    }
  }
}

TEST_CASE("the header of a model has its texture points and its textures") {
  REQUIRE(std::size(sign::kParts) == 2);
  MeshView board;
  REQUIRE(ok(sign::kParts[0].make_view(board)));
  CHECK(board.planes() != nullptr);
  CHECK(board.texture_scale().fraction_bits == 14);
  const FixedModel model = to_fixed(load_model_file(kSign));
  REQUIRE(board.vertex_count() == model.meshes[0].positions.size());
  CHECK(sign::kParts[0].texture == &sign::texture_1::kTexture);
  CHECK(sign::kParts[1].texture == nullptr);
  CHECK(sign::kParts[0].alpha == PartAlpha::kOpaque);
  // In a fourth level the halves of the board, which are islands, would have a texel each.
  STATIC_REQUIRE(sign::texture_1::kTexture.size() == TextureSize{4, 3, 3});
  MeshView post;
  REQUIRE(ok(sign::kParts[1].make_view(post)));
  CHECK(post.texture_point(0) == TexturePoint{});
}

TEST_CASE("the library reads the textures of the model binary that was written") {
  const FixedModel model = to_fixed(load_model_file(kSign));
  const ModelTextures textures = make_textures(model, {find_texture_format("pal4").value()});
  REQUIRE(textures.textures.size() == 1);
  CHECK(textures.bytes() == textures.textures[0].bytes());
  const std::string text = model_binary_file(model, textures);
  CHECK(text.size() == model_bytes(CompiledOutput::kBinary, model, false, textures));
  const std::vector<std::uint8_t> good(text.begin(), text.end());
  StoredModel stored;
  REQUIRE(ok(view_model_binary(good, stored)));
  REQUIRE(stored.part_count() == 2);
  const arcspan::ModelPart board = stored.part(0);
  Texture<Palette4Texels<>> texture;
  REQUIRE(ok(view_texture(board.texture, texture)));
  CHECK(texture.size() == TextureSize{4, 3, 1});
  CHECK(stored.part(1).texture.texels.empty());
  for (std::size_t i = 0; i < board.mesh.vertex_count(); ++i) {
    CHECK(board.mesh.texture_point(i) == model.meshes[0].texture_points[i]);
  }
  for (std::size_t at = 0; at < good.size(); ++at) {
    std::vector<std::uint8_t> wrong = good;
    wrong[at] ^= 0x10;
    CHECK_FALSE(ok(view_model_binary(wrong, stored)));
    wrong.resize(at);
    CHECK_FALSE(ok(view_model_binary(wrong, stored)));
  }
}

TEST_CASE("mesh: textures in both forms, in any format, and left out") {
  const TemporaryFolder folder;
  const std::string bin = folder / "sign.bin";
  const CommandRun made = run("mesh " + kSign + " -o " + bin + " --stats " + (folder / "s.json"));
  CHECK(made.err.empty());
  CHECK(made.out.find("  texture 1: 16x8 texels, pal8, levels: 1, 640 bytes\n") != std::string::npos);
  CHECK(contents(folder / "s.json").find("\"format\": \"pal8\"") != std::string::npos);
  REQUIRE(run("mesh " + bin + " -o " + (folder / "again.bin")).status == 0);
  CHECK(contents(folder / "again.bin") == contents(bin));
  REQUIRE(run("mesh " + kSign + " -o " + (folder / "big.bin") +
              " --texture-format rgb565 --texture-size 64x32 --texture-levels all")
              .status == 0);
  CHECK(contents(folder / "big.bin").size() > contents(bin).size() + 2 * 64 * 32);
  REQUIRE(run("mesh " + kSign + " -o " + (folder / "none.hpp") + " --no-textures").status == 0);
  CHECK(contents(folder / "none.hpp").find("Texture") == std::string::npos);
  (void)folder.file("a.mtl", "newmtl m\nmap_Kd wide.ppm\n");
  (void)folder.file("wide.ppm", "P6 256 8 255\n" + std::string(256 * 8 * 3, 'a'));
  CHECK(run("mesh " + folder.file("a.obj", kSquare + "g texture_1\nf 1/1 2/2 4/4\n") + " -o " +
            (folder / "w.hpp"))
            .out.find("  texture 1: 128x8 texels, pal8") != std::string::npos);
  const std::string header = contents(folder / "w.hpp");
  CHECK(header.find("namespace texture_1 {") != std::string::npos);
  CHECK(header.find("namespace texture_1_2 {") != std::string::npos);
  const std::string lamp = ARCSPAN_MODELS "/lamp.obj";
  CHECK(run("mesh " + lamp + " -o " + (folder / "t.hpp") + " --texture " + kTiles).err ==
        "arcspan: " + lamp + ": has no texture coordinates for --texture\n");
}

TEST_CASE("mesh: a masked texture keeps its alpha in pal8, and gray loses it with a warning") {
  const TemporaryFolder folder;
  std::string picture("\0\0\2\0\0\0\0\0\0\0\0\0\10\0\10\0\40\10", 18);  // TGA of 8x8 pixels with alpha
  for (int i = 0; i < 64; ++i) picture += i < 32 ? std::string("\1\2\3\0", 4) : "\1\2\3\377";
  (void)folder.file("a.tga", picture);
  (void)folder.file("a.mtl", "newmtl m\nKd 1 1 1\nmap_Kd a.tga\nmap_d a.tga\n");
  const std::string obj = folder.file("a.obj", kSquare);
  const auto mesh_in = [&](const std::string& format) {
    return run("mesh " + obj + " -o " + (folder / "a.bin") + " --texture-format " + format);
  };
  const CommandRun masked = mesh_in("pal8");
  CHECK(masked.err.empty());
  CHECK(masked.out.find(" texels, pal8-5551,") != std::string::npos);
  const CommandRun gray = mesh_in("gray");
  CHECK(gray.err ==
        "arcspan: warning: " + obj + ": the opacity of textures is not written: the format gray has none\n");
  CHECK(gray.out.find(" texels, gray,") != std::string::npos);
}

TEST_CASE("mesh and texture: mip levels end where islands of the texture would have less than two texels") {
  const TemporaryFolder folder;
  (void)folder.file("a.mtl", "newmtl m\nmap_Kd tiles.ppm\n");
  (void)folder.file("tiles.ppm", contents(kTiles));
  // Cells of an atlas of 4x4, of which the squares show two that lie side by side, and the whole texture.
  const auto squares = [](const std::string& cell) {
    return "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nvt 0 0\nvt 0.25 0\nvt 0.25 "
           "0.25\n"
           "vt 0 0.25\nvt 0.5 0\nvt 0.5 0.25\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl m\n" +
           cell;
  };
  const auto levels = [&](const std::string& cell) {
    const std::string obj = folder.file("a.obj", squares(cell));
    const CommandRun made =
        run("mesh " + obj + " -o " + (folder / "a.hpp") + " --texture-size 64 --texture-levels all");
    const std::size_t at = made.out.find("levels: ");
    return std::pair(made.out.substr(at + 8, 1),
                     made.out.find("left out, in which islands") != std::string::npos);
  };
  CHECK(levels("f 1/1 2/7 3/8 4/9\n") == std::pair(std::string("7"), false));
  CHECK(levels("f 1/1 2/2 3/3 4/4\nf 2/5 5/2 6/3 3/6\n") == std::pair(std::string("4"), true));
  // Squares that go on in the texture as they do in space are one island of 32x16 texels.
  CHECK(levels("f 1/1 2/2 3/3 4/4\nf 2/2 5/5 6/6 3/3\n") == std::pair(std::string("4"), true));
  CHECK(levels("f 1/1 2/1 3/1 4/1\n") == std::pair(std::string("1"), true));

  RgbaImage leaves(64, 64);
  for (Rgba8& c : leaves.pixels) c.a = 0;
  for (int i = 0; i < 64; ++i) leaves.pixels[static_cast<std::size_t>((8 + i / 8) * 64 + 8 + i % 8)].a = 255;
  leaves.pixels[0].a = 255;  // a speck
  TextureOptions options{*find_texture_format("rgba5551")};
  options.levels = 0;
  const MadeTexture made = make_texture(leaves, options, "leaves").texture;
  CHECK(made.size.levels == 3);
  CHECK(left_out_text(made) == "4 levels are left out, in which islands would have less than two texels\n");
}

TEST_CASE("render: the texels are where the texture points say") {
  const TemporaryFolder folder;
  const std::string camera =
      " --size 200x200 --eye 0,2,9 --target 0,2,0 --fov 40 --light 0,0,1 --specular 0 --format rgb888 ";
  const auto drawn = [&](const std::string& model, const std::string& shading) {
    const CommandRun made = run("render " + model + camera + "-o " + (folder / "a.ppm") + shading);
    INFO(made.err);
    REQUIRE(made.status == 0);
    return read_image(folder / "a.ppm");
  };
  const std::string shading = GENERATE("flat", "gouraud", "arc");
  const Image image = drawn(kSign, " --shading " + shading);
  // The left half of the board shows the columns 0 to 7 of tiles.ppm, the right half 8 to 15: four tiles of
  // one unit, 30.5 pixels wide. Their upper half is coloured, the lower one black.
  const auto tile = [&image](int number, int row) { return image.at(100 - 46 + 30 * number, row); };
  CHECK((tile(0, 90).r > 180 && tile(0, 90).g < 40 && tile(0, 90).b < 40));
  CHECK((tile(1, 90).g > 180 && tile(1, 90).r < 40));
  CHECK((tile(2, 90).b > 180 && tile(2, 90).r < 40));
  CHECK((tile(3, 90).r > 180 && tile(3, 90).g > 180 && tile(3, 90).b > 180));
  for (int i = 0; i < 4; ++i) CHECK(tile(i, 120).g < 40);
  const Rgb8 post = image.at(100, 170);  // has no texture
  CHECK((post.r > post.g && post.g > post.b && post.b > 40));
  if (shading != "arc") return;
  // So do the binary, and a picture in place of the file's.
  REQUIRE(run("mesh " + kSign + " -o " + (folder / "s.bin")).status == 0);
  CHECK(drawn(folder / "s.bin", "").at(54, 90).r > 180);
  const std::string grey = folder.file("grey.pgm", "P5\n8 8\n255\n" + std::string(64, '\x80'));
  const Rgb8 replaced = drawn(kSign, " --texture " + grey).at(54, 90);
  CHECK(std::abs(replaced.r - replaced.g) <= 4);  // 5-6-5
  CHECK(run("render " + kSign + " -o " + (folder / "b.png") + " --shading phong").err ==
        "arcspan: warning: " + kSign + ": textures are not drawn by --shading phong\n");
}

TEST_CASE("rgb565 with exchanged bytes shows the colours of rgb565, whatever computes on pixels") {
  const TemporaryFolder folder;
  const std::string options =
      GENERATE(as<std::string>(), "", " --alpha 0.5", " --fog 5,8", " --matcap " ARCSPAN_MODELS "/tiles.ppm");
  const auto drawn = [&](const std::string& format) {
    const CommandRun made = run("render " + kSign + options + " --size 80x80 --no-dither --format " + format +
                                " -o " + (folder / "a.ppm"));
    INFO(made.err);
    REQUIRE(made.status == 0);
    return read_image(folder / "a.ppm");
  };
  CHECK((drawn("rgb565_swapped") == drawn("rgb565")));
}

TEST_CASE("a picture is wrapped around generated meshes, with a seam that no triangle crosses") {
  const std::string name = GENERATE("sphere:16x8", "torus:16x8");
  const Model model = load_model_file(name, TexturePointsOf::kAllParts);
  const MeshData& mesh = model.parts[0].mesh;
  CHECK(model.triangle_count() == load_model_file(name).triangle_count());
  REQUIRE(mesh.texture_points.size() == mesh.positions.size());
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Uv a = mesh.texture_points[t[i]];
      const Uv b = mesh.texture_points[t[(i + 1) % 3]];
      CHECK(std::abs(a.u - b.u) <= 1.0 / 16 + 1e-9);
      CHECK(std::abs(a.v - b.v) <= 1.0 / 8 + 1e-9);
    }
  }
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3& p = mesh.positions[i];
    if (p.z > 0.9 && std::abs(p.y) < 0.1) {
      CHECK(mesh.texture_points[i].u == Approx(0.5 + std::asin(p.x / std::hypot(p.x, p.z)) / 6.2831853));
    }
  }
}

TEST_CASE("Collada: of several texture coordinates those are drawn that the material binds") {
  const auto source = [](const std::string& id, const std::string& numbers, const std::string& axes) {
    std::string params;
    for (const char axis : axes) params += "<param name='" + std::string(1, axis) + "' type='float'/>";
    return "<source id='" + id + "'><float_array id='" + id + "a' count='" + std::to_string(3 * axes.size()) +
           "'>" + numbers + "</float_array><technique_common><accessor source='#" + id +
           "a' count='3' stride='" + std::to_string(axes.size()) + "'>" + params +
           "</accessor></technique_common></source>";
  };
  const auto first_u = [&](int first, int bound) {
    const auto input = [](const std::string& set, const std::string& from) {
      return "<input semantic='TEXCOORD' source='#" + from + "' offset='0' set='" + set + "'/>";
    };
    const TemporaryFolder folder;
    (void)folder.file("tiles.ppm", contents(kTiles));
    const Model model = load_model_file(folder.file(
        "a.dae",
        "<COLLADA version='1.4.1'><library_images><image id='i'><init_from>tiles.ppm</init_from></image>"
        "</library_images><library_effects><effect id='e'><profile_COMMON><newparam sid='f'><surface "
        "type='2D'><init_from>i</init_from></surface></newparam><newparam sid='t'><sampler2D><source>f"
        "</source></sampler2D></newparam><technique sid='c'><lambert><diffuse><texture texture='t' "
        "texcoord='UV'/></diffuse></lambert></technique></profile_COMMON></effect></library_effects>"
        "<library_materials><material id='m'><instance_effect url='#e'/></material></library_materials>"
        "<library_geometries><geometry id='g'><mesh>" +
            source("p", "0 0 0 1 0 0 0 1 0", "XYZ") + source("u", "0.25 0 0.5 0 0.25 0.5", "ST") +
            source("w", "0.75 0 1 0 0.75 0.5", "ST") +
            "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices><triangles material='m' "
            "count='1'><input semantic='VERTEX' source='#v' offset='0'/>" +
            input(std::to_string(first), "u") + input(std::to_string(first + 1), "w") +
            "<p>0 1 2</p></triangles></mesh></geometry></library_geometries><library_visual_scenes>"
            "<visual_scene id='s'><node id='n'><instance_geometry url='#g'><bind_material>"
            "<technique_common><instance_material symbol='m' target='#m'><bind_vertex_input semantic='UV' "
            "input_semantic='TEXCOORD' input_set='" +
            std::to_string(bound) +
            "'/></instance_material></technique_common></bind_material></instance_geometry></node>"
            "</visual_scene></library_visual_scenes><scene><instance_visual_scene url='#s'/></scene>"
            "</COLLADA>"));
    const MeshData& mesh = model.parts[0].mesh;
    return mesh.texture_points.at(mesh.triangles[0][0]).u;
  };
  CHECK(first_u(0, 0) == 0.25);
  CHECK(first_u(0, 1) == 0.75);
  CHECK(first_u(1, 1) == 0.25);
  CHECK(first_u(1, 2) == 0.75);
  CHECK(first_u(0, 7) == 0.25);  // there are no such ones
}

TEST_CASE("Collada and 3DS: nodes, materials and textures as the loader reads them") {
  const std::string folder = "/usr/share/assimp/models/";
  if (!std::filesystem::exists(folder)) return;
  const Model duck = load_model_file(folder + "Collada/duck.dae");
  CHECK(duck.warnings.empty());
  REQUIRE(duck.parts.size() == 1);
  CHECK(duck.triangle_count() == 4212);
  const FileMaterial& material = duck.parts[0].look.material;
  REQUIRE(material.texture != nullptr);
  CHECK(material.texture->picture.width == 512);
  CHECK(material.colour == Vec3{1, 1, 1});
  REQUIRE(duck.parts[0].mesh.texture_points.size() == duck.vertex_count());
  const Model cube = load_model_file(folder + "3DS/cube_with_diffuse_texture.3DS");
  CHECK(cube.triangle_count() == 12);
  REQUIRE(cube.parts[0].look.material.texture != nullptr);
  CHECK_FALSE(cube.parts[0].mesh.texture_points.empty());
  const TemporaryFolder files;
  const std::string text = contents(folder + "Collada/duck.dae");
  const std::string lone = files.file("duck.dae", text);
  CHECK(load_model_file(lone).warnings ==
        std::vector<std::string>{"left out: textures (1): 'duckCM.tga' (not in the model's folder)"});
  const std::string cut = files.file("cut.dae", text.substr(0, text.size() / 2));
  CHECK(message_of<Failure>([&] { (void)load_model_file(cut); }).starts_with(cut + ": cannot be read: "));
}
