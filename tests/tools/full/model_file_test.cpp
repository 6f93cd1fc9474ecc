// SPDX-License-Identifier: MIT
// Parts, materials and colours of OBJ, MTL and PLY files.
#include <arcspan_tools/mesh/file/load.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <catch2/catch.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <algorithm>

using namespace arcspan::tools;
using namespace arcspan::test;

namespace {

using Lines = std::vector<std::string>;

/// Two triangles that meet at a right angle along the y axis.
constexpr const char* kFold = "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 1\n";

Model loaded(const std::string& obj, const std::string& mtl = "") {
  const TemporaryFolder folder;
  if (!mtl.empty()) (void)folder.file("a.mtl", mtl);
  return load_model_file(folder.file("a.obj", obj));
}

FileMaterial material(const std::string& statements) {
  return loaded(std::string(kFold) + "mtllib a.mtl\nusemtl m\nf 1 3 2\n", "newmtl m\n" + statements)
      .parts[0]
      .look.material;
}

/// The warning about wrong statements of a material file, from the number on and without the file's name.
std::string warning_about_mtl(const std::string& mtl) {
  const TemporaryFolder folder;
  (void)folder.file("a.mtl", mtl);
  const std::string obj = folder.file("a.obj", std::string(kFold) + "mtllib a.mtl\nusemtl m\nf 1 3 2\n");
  for (const std::string& warning : load_model_file(obj).warnings) {
    const std::string begin = "left out: wrong statements of materials ";
    const std::size_t name = warning.find((folder / "a.mtl") + ": ");
    if (warning.rfind(begin, 0) != 0 || name == std::string::npos) continue;
    return warning.substr(begin.size(), 3) + " " + warning.substr(name + (folder / "a.mtl").size() + 2);
  }
  return "(no warning)";
}

Model loaded_ply(const std::string& vertex_properties, const std::string& face_properties,
                 const std::string& body) {
  const TemporaryFolder folder;
  return load_model_file(folder.file(
      "a.ply",
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n" +
          vertex_properties + "element face 2\nproperty list uchar int vertex_indices\n" + face_properties +
          "end_header\n" + body));
}

}  // namespace

TEST_CASE("OBJ: a part for each group and material, with its names") {
  const Model model =
      loaded(std::string("mtllib a.mtl\n") + kFold +
                 "o car\ng body doors\nusemtl red\nf 1 3 2\ng wheels\nusemtl matt black\nf 1 2 4\nf 1 4 3\n"
                 "g body doors\nusemtl red\nf 4 2 3\n",
             "newmtl red\nKd 1 0 0\nnewmtl matt  black\nKd 0.1 0.1 0.1\n");
  REQUIRE(model.parts.size() == 2);
  CHECK(model.parts[0].look.names == Lines{"car", "body", "doors"});
  CHECK(model.parts[0].look.material.name == "red");
  CHECK(model.parts[0].look.material.colour == Vec3{1, 0, 0});
  CHECK(model.parts[0].mesh.triangles.size() == 2);
  CHECK(model.parts[1].look.names == Lines{"car", "wheels"});
  CHECK(model.parts[1].look.material.colour == Vec3{0.1, 0.1, 0.1});
  CHECK(model.parts[1].mesh.triangles.size() == 2);
  CHECK(model.triangle_count() == 4);
  CHECK(model.warnings.empty());
}

TEST_CASE("a group is selected by any of its names") {
  const std::string obj = std::string(kFold) + "o car\ng body\nf 1 3 2\ng wheels\nf 1 2 4\n";
  CHECK(select_parts(loaded(obj), "wheels", "m").parts.size() == 1);
  CHECK(select_parts(loaded(obj), "car", "m").parts.size() == 2);
  CHECK(message_of<Failure>([&] { (void)select_parts(loaded(obj), "wing", "m"); }) ==
        "m: no group 'wing' (there are: body, car, wheels)");
}

TEST_CASE("MTL: statements of a material") {
  CHECK(material("Kd 0.25 0.5 0.75\n").colour == Vec3{0.25, 0.5, 0.75});
  CHECK(material("Kd 0.25\n").colour == Vec3{0.25, 0.25, 0.25});
  CHECK_FALSE(material("Ns 10\n").colour);
  CHECK(material("Ks 0.5 0.25 0\nNs 31.6\n").specular == Vec3{0.5, 0.25, 0});
  CHECK(material("Ks 0.5 0.25 0\nNs 31.6\n").shininess == 32);
  CHECK(material("Ns 1000\n").shininess == 256);
  CHECK(material("Ns 0\n").shininess == 1);
  CHECK(material("Ke 0.1 0 0\n").emission == Vec3{0.1, 0, 0});
  // Grey ambient colours are what exporters write without a meaning.
  CHECK_FALSE(material("Ka 1 1 1\n").ambient_colour);
  CHECK_FALSE(material("Ka 0 0 0\n").ambient_colour);
  CHECK(material("Ka 0.1 0.2 0.3\n").ambient_colour == Vec3{0.1, 0.2, 0.3});
  CHECK(material("illum 0\n").unlit);
  CHECK_FALSE(material("illum 2\n").unlit);
  CHECK(material("Ks 1 1 1\nillum 1\n").specular == Vec3{0, 0, 0});
  CHECK(material("illum 1\nKs 1 1 1\n").specular == Vec3{0, 0, 0});
  CHECK(material("illum 2\nKs 1 1 1\n").specular == Vec3{1, 1, 1});
  CHECK(material("Kd 1 1 1\n").opacity == 1);
  CHECK(material("d 0.5\n").opacity == 0.5);
  CHECK(material("d -halo 0.25\n").opacity == 0.25);
  CHECK(material("Tr 0.25\n").opacity == 0.75);
  CHECK(material("d 2\n").opacity == 1);
  CHECK(material("d 0\n").opacity == 1);
}

TEST_CASE("MTL: what is not drawn gets a warning, once") {
  const auto warnings = [](const std::string& mtl) {
    return loaded(std::string(kFold) + "mtllib a.mtl\nusemtl m\nf 1 3 2\nusemtl n\nf 1 2 4\n",
                  "newmtl m\n" + mtl + "newmtl n\n" + mtl)
        .warnings;
  };
  CHECK(warnings("Kd 1 0 0\nNi 1.5\nTf 1 1 1\nd 1\nillum 2\n").empty());
  CHECK(warnings("map_Ks wood.png\nbump b.png\nillum 3\n") ==
        Lines{"left out: bump (2), illum 3 (2), map_Ks (2)"});
  CHECK(warnings("map_d holes.png\n") == Lines{"left out: opacity from another picture (map_d) (2)"});
  const Lines invisible = {"fully transparent materials (d 0, Tr 1) are drawn opaque"};
  CHECK(warnings("d 0\n") == invisible);
  CHECK(warnings("Tr 1\n") == invisible);
  CHECK(warnings("d 0.01\n").empty());
  CHECK(warnings("Kd 2 0 0\n") == Lines{"colours of materials above 1 are drawn as 1"});
  CHECK(warnings("Kd spectral a.rfl\n") == Lines{"left out: Kd spectral (2)"});
}

TEST_CASE("MTL: wrong statements are left out, with a warning that names the first one's file and line") {
  CHECK(warning_about_mtl("newmtl m\nKd 1 red 0\n") == "(1) line 2: 'red' is not a number");
  CHECK(warning_about_mtl("newmtl m\nKd 1 0\nKd 1 red 0\n") == "(2) line 2: a number is missing");
  CHECK(warning_about_mtl("newmtl m\nKd -1 0 0\n") == "(1) line 2: '-1' is not a colour (0...1)");
  CHECK(warning_about_mtl("newmtl m\nNs shiny\n") == "(1) line 2: 'shiny' is not a number");
  CHECK(warning_about_mtl("newmtl m\nillum 11\n") ==
        "(1) line 2: illumination model out of range (11; allowed are 0 to 10)");
  CHECK(warning_about_mtl("Kd 1 0 0\n") == "(1) line 1: 'Kd' before any newmtl");
  CHECK(warning_about_mtl("newmtl\n") == "(1) line 1: a material has no name");
  CHECK(warning_about_mtl("newmtl m\nmap_Kd\n") == "(1) line 2: 'map_Kd' names no file");
  CHECK(material("Kd 1 red 0\nKs 1 1 1\n").specular == Vec3{1, 1, 1});
  CHECK_FALSE(material("newmtl\nKd 1 0 0\n").colour);  // not of the material before it
}

TEST_CASE("a '#' in a name belongs to it if that exists, and starts a comment otherwise") {
  const std::string mtl = "newmtl M #1\nKd 1 0 0\nnewmtl M #2\nKd 0 1 0\nnewmtl plain # a note\nKd 0 0 1\n";
  const auto colour = [&mtl](const std::string& statement) {
    const Model model = loaded(std::string(kFold) + "mtllib a.mtl # all\n" + statement + "\nf 1 3 2\n", mtl);
    CHECK(model.warnings.size() == (model.parts[0].look.material.colour ? 0 : 1));
    return model.parts[0].look.material.colour;
  };
  CHECK(colour("usemtl M #1") == Vec3{1, 0, 0});
  CHECK(colour("usemtl M #2") == Vec3{0, 1, 0});
  CHECK(colour("usemtl M #1 # red # really") == Vec3{1, 0, 0});
  CHECK(colour("usemtl plain") == Vec3{0, 0, 1});
  CHECK(colour("usemtl plain # a note") == Vec3{0, 0, 1});
  CHECK(colour("usemtl plain # another") == Vec3{0, 0, 1});
  CHECK(colour("usemtl none # such") == std::nullopt);
  // Faces of one material stay together, whatever the comments are.
  const std::string same = "usemtl plain # x\nf 1 3 2\nusemtl plain\nf 1 2 4\n";
  CHECK(loaded(std::string(kFold) + "mtllib a.mtl\n" + same, mtl).parts.size() == 1);

  const TemporaryFolder folder;
  (void)folder.file("ha#sh.mtl", "newmtl m\nKd 1 0 0\nmap_Kd ch #1.ppm\n");
  (void)folder.file("a #2.mtl", "newmtl m\nKd 0 1 0\nmap_Kd b.ppm # no more\n");
  (void)folder.file("ch #1.ppm", "P6 1 1 255 \1\1\1");
  (void)folder.file("b.ppm", "P6 1 1 255 \2\2\2");
  for (const auto& [library, red] : {std::pair("ha#sh.mtl", 1), std::pair("ha#sh.mtl # m", 1),
                                     std::pair("a #2.mtl", 2), std::pair("none.mtl", 0)}) {
    const Model model = load_model_file(folder.file(
        "a.obj", std::string(kFold) + "vt 0 0\nmtllib " + library + "\no Box #1\nusemtl m\nf 1/1 3/1 2/1\n"));
    CAPTURE(library);
    CHECK(model.parts[0].look.names == Lines{"Box #1", "Box"});
    CHECK(model.warnings.size() == (red == 0 ? 1 : 0));
    if (red == 0) continue;
    REQUIRE(model.parts[0].look.material.texture != nullptr);
    CHECK(model.parts[0].look.material.texture->picture.pixels[0].r == red);
  }
}

TEST_CASE(
    "MTL files are read from the folder of the model only; what is missing is drawn in the default look") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "model");
  std::filesystem::create_directory(folder / "model/sub");
  (void)folder.file("outside.mtl", "newmtl m\nKd 1 0 0\n");
  (void)folder.file("model/sub/my own.mtl", "newmtl m\nKd 0 1 0\n");
  const auto model = [&](const std::string& library) {
    return load_model_file(
        folder.file("model/a.obj", std::string(kFold) + "mtllib " + library + "\nusemtl m\nf 1 3 2\n"));
  };
  CHECK(model("sub/my own.mtl").parts[0].look.material.colour == Vec3{0, 1, 0});
  CHECK(model("sub\\my own.mtl").parts[0].look.material.colour == Vec3{0, 1, 0});
  for (const std::string& outside : {std::string("../outside.mtl"), std::string("sub/../../outside.mtl"),
                                     folder / "outside.mtl", std::string("none.mtl")}) {
    CAPTURE(outside);
    const Model without = model(outside);
    CHECK_FALSE(without.parts[0].look.material.colour);
    REQUIRE(without.warnings.size() == 1);
    CHECK(without.warnings[0].find("(mtllib) from the model's folder") != std::string::npos);
  }
  CHECK(model("sub/my own.mtl\nusemtl unknown\nf 1 2 4").warnings ==
        Lines{"materials that are not defined (1) are drawn in the default look: 'unknown'"});
}

TEST_CASE("MTL: a picture is looked for beside the material file, then beside the model") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "sub");
  (void)folder.file("sub/a.mtl", "newmtl m\nmap_Kd t.ppm\n");
  const std::string obj =
      folder.file("a.obj", std::string(kFold) + "vt 0 0\nmtllib sub/a.mtl\nusemtl m\nf 1/1 3/1 2/1\n");
  (void)folder.file("t.ppm", "P6 1 1 255 \1\1\1");
  CHECK(load_model_file(obj).parts[0].look.material.texture->picture.pixels[0].r == 1);
  (void)folder.file("sub/t.ppm", "P6 1 1 255 \2\2\2");
  CHECK(load_model_file(obj).parts[0].look.material.texture->picture.pixels[0].r == 2);
  (void)folder.file("sub/a.mtl", "newmtl m\nmap_Kd ../t.ppm\n");
  const Model back = load_model_file(obj);
  CHECK(back.warnings.empty());
  REQUIRE(back.parts[0].look.material.texture != nullptr);
  CHECK(back.parts[0].look.material.texture->picture.pixels[0].r == 1);
}

TEST_CASE("OBJ: faces are smoothed within their group, and not at all by s off") {
  const auto normals = [](const std::string& first, const std::string& second) {
    const Model model = loaded(std::string(kFold) + first + "f 1 3 2\n" + second + "f 1 2 4\n");
    std::vector<Vec3> own = model.parts[0].mesh.normals;
    return own;
  };
  const auto count = [](const std::vector<Vec3>& all, Vec3 wanted) {
    return std::count_if(all.begin(), all.end(), [&](const Vec3& n) { return length(n - wanted) < 1e-9; });
  };
  const Vec3 half = normalised(Vec3{1, 0, 1});
  CHECK(count(normals("s 1\n", "s 1\n"), half) == 2);
  CHECK(count(normals("", ""), half) == 0);  // where the file says nothing, 90 degrees are an edge
  CHECK(count(normals("s 1\n", "s 2\n"), half) == 0);
  CHECK(count(normals("s 1\n", "s 2\n"), {0, 0, 1}) == 3);
  CHECK(count(normals("s off\n", ""), {1, 0, 0}) == 3);
  CHECK(count(normals("s 0\n", "s 0\n"), {0, 0, 1}) == 3);
  // Normals go on across parts: a ball of several colours stays round.
  const Model ball = loaded(std::string(kFold) + "s 1\ng a\nf 1 3 2\ng b\nf 1 2 4\n");
  REQUIRE(ball.parts.size() == 2);
  CHECK(count(ball.parts[0].mesh.normals, half) == 2);
  CHECK(count(ball.parts[1].mesh.normals, half) == 2);
}

TEST_CASE("OBJ: vertex colours, 0...1 or 0...255") {
  const std::string square = "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\nv 0 1 0 ";
  const Model same = loaded(square + "1 0 0\nf 1 2 3 4\n");
  REQUIRE(same.parts.size() == 1);
  CHECK(same.parts[0].look.material.colour == Vec3{1, 0, 0});
  CHECK(same.warnings.empty());
  const Model mixed = loaded(square + "0 0 1\nf 1 2 3\nf 1 3 4\n");
  REQUIRE(mixed.parts.size() == 2);
  CHECK(mixed.parts[1].look.material.colour == Vec3{170 / 255.0, 0, 85 / 255.0});
  CHECK(mixed.warnings ==
        Lines{"vertex colours that differ within a triangle are drawn as their mean (1 triangles)"});
  const Model bytes = loaded("v 0 0 0 255 51 0\nv 1 0 0 255 51 0\nv 1 1 0 255 51 0\nf 1 2 3\n");
  CHECK(bytes.parts[0].look.material.colour == Vec3{1, 0.2, 0});
  // A vertex without a colour leaves its triangles to their material.
  const Model some = loaded(square + "\nf 1 3 4\n");
  CHECK_FALSE(some.parts[0].look.material.colour);
  CHECK(some.warnings == Lines{"left out: vertex colours on some corners of a triangle only (1)"});
  const Model wrong = loaded(square + "x 0 0\nf 1 2 3\nf 1 3 4\n");
  CHECK(wrong.warnings == Lines{"left out: vertex colours on some corners of a triangle only (1), vertex "
                                "colours that are not finite numbers (1)"});
  CHECK(wrong.parts.size() == 2);
}

TEST_CASE("vertex colours are kept where they differ within triangles, if that is asked for") {
  const TemporaryFolder folder;
  const auto kept = [&folder](const std::string& obj) {
    return load_model_file(folder.file("a.obj", obj), TexturePointsOf::kTexturedParts, VertexColours::kKept);
  };
  const std::string square = "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\nv 0 1 0 0 0.2 1\n";
  const Model mixed = kept(square + "f 1 2 3\nf 1 3 4\n");
  REQUIRE(mixed.parts.size() == 1);
  CHECK(mixed.warnings.empty());
  CHECK(mixed.parts[0].look.material.colour == Vec3{1, 1, 1});
  REQUIRE(mixed.parts[0].mesh.colours.size() == 4);
  CHECK(std::count(mixed.parts[0].mesh.colours.begin(), mixed.parts[0].mesh.colours.end(),
                   arcspan::Rgb8{255, 0, 0}) == 3);
  CHECK(std::count(mixed.parts[0].mesh.colours.begin(), mixed.parts[0].mesh.colours.end(),
                   arcspan::Rgb8{0, 51, 255}) == 1);
  // One position in two colours is two vertices. A triangle without colours stays in its material.
  const Model split = kept(square + "v 1 0 0 0 1 0\nv 1 0 2\nf 1 2 4\nf 5 3 4\nf 1 2 6\n");
  REQUIRE(split.parts.size() == 2);
  CHECK(split.parts[0].mesh.colours.empty());
  CHECK(split.parts[0].mesh.triangles.size() == 1);
  CHECK(split.parts[1].mesh.positions.size() == 5);
  // Faces of one colour each need no interpolation, and may have any shading.
  const Model faces = kept(square + "f 1 2 3\n");
  CHECK(faces.parts[0].mesh.colours.empty());
  CHECK(faces.parts[0].look.material.colour == Vec3{1, 0, 0});
}

TEST_CASE("more vertex colours than 256 are drawn with the nearest ones") {
  std::string obj;
  std::string faces;
  for (int i = 0; i < 400; ++i) {
    const std::string colour = " 0 " + std::to_string((i % 200) / 200.0) + " " + (i < 200 ? "0" : "1") + "\n";
    const std::string x = std::to_string(i);
    obj += "v " + x + " 0 0" + colour + "v " + x + " 1 0" + colour + "v " + x + " 0 1" + colour;
    faces += "f -" + std::to_string(3 * (400 - i)) + " -" + std::to_string(3 * (400 - i) - 1) + " -" +
             std::to_string(3 * (400 - i) - 2) + "\n";
  }
  const Model model = loaded(obj + faces);
  CHECK(model.parts.size() > 32);
  CHECK(model.parts.size() <= 256);
  CHECK(model.triangle_count() == 400);
  REQUIRE(model.warnings.size() == 1);
  CHECK(model.warnings[0].find("of its colours, the nearest of ") == 0);
}

TEST_CASE("PLY: colours of vertices and of faces, as integers and as floats") {
  const std::string rgb = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  const std::string faces = "3 0 1 2\n3 0 2 3\n";
  const Model bytes =
      loaded_ply(rgb, "", "0 0 0 255 51 0\n1 0 0 255 51 0\n1 1 0 255 51 0\n0 1 0 255 51 0\n" + faces);
  REQUIRE(bytes.parts.size() == 1);
  CHECK(bytes.parts[0].look.material.colour == Vec3{1, 0.2, 0});
  CHECK(bytes.warnings.empty());
  const Model floats = loaded_ply("property float red\nproperty float green\nproperty float blue\n", "",
                                  "0 0 0 0 1 0.2\n1 0 0 0 1 0.2\n1 1 0 0 1 0.2\n0 1 0 0 1 0.2\n" + faces);
  CHECK(floats.parts[0].look.material.colour == Vec3{0, 1, 0.2});
  const Model short_names =
      loaded_ply("property uchar r\nproperty uchar g\nproperty uchar b\n", "",
                 "0 0 0 0 0 255\n1 0 0 0 0 255\n1 1 0 0 0 255\n0 1 0 0 0 255\n" + faces);
  CHECK(short_names.parts[0].look.material.colour == Vec3{0, 0, 1});
  const std::string wide =
      "property ushort diffuse_red\nproperty ushort diffuse_green\nproperty ushort diffuse_blue\n";
  const Model words =
      loaded_ply(wide, "", "0 0 0 65535 0 0\n1 0 0 65535 0 0\n1 1 0 65535 0 0\n0 1 0 65535 0 0\n" + faces);
  CHECK(words.parts[0].look.material.colour == Vec3{1, 0, 0});
  for (const std::string type : {"int", "uint"}) {  // of 32 bits, with bytes in them
    const std::string long_rgb =
        "property " + type + " red\nproperty " + type + " green\nproperty " + type + " blue\n";
    const Model longs =
        loaded_ply(long_rgb, "", "0 0 0 255 51 0\n1 0 0 255 51 0\n1 1 0 255 51 0\n0 1 0 255 51 0\n" + faces);
    CHECK(longs.parts[0].look.material.colour == Vec3{1, 0.2, 0});
  }
  const Model of_faces =
      loaded_ply("", rgb, "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 3 0 0 255\n");
  REQUIRE(of_faces.parts.size() == 2);
  CHECK(of_faces.parts[0].look.material.colour == Vec3{1, 0, 0});
  CHECK(of_faces.parts[1].look.material.colour == Vec3{0, 0, 1});
  CHECK(of_faces.parts[1].mesh.triangles.size() == 1);
}

TEST_CASE("colours and groups survive polygons, in whatever order the loader makes triangles of them") {
  std::string obj;
  for (int i = 0; i < 5; ++i) {
    const char* const corners[] = {"0 0", "4 0", "4 4", "2 1", "0 4"};
    for (const char* corner : corners) obj += std::string("v ") + corner + " " + std::to_string(i) + "\n";
    obj += "g g" + std::to_string(i) + "\nf -5 -4 -3 -2 -1\n";
  }
  const Model model = loaded(obj);
  REQUIRE(model.parts.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(model.parts[i].look.names == Lines{"g" + std::to_string(i)});
    CHECK(model.parts[i].mesh.triangles.size() == 3);
    for (const Vec3& p : model.parts[i].mesh.positions) CHECK(p.z == double(i));
  }
}
