// SPDX-License-Identifier: MIT
#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/mesh/file/load.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <catch2/catch.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <algorithm>
#include <cmath>

using namespace arcspan::tools;
using namespace arcspan::test;

namespace {

constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

// The message of loading the file, without the file's name.
std::string complaint(const std::string& name, const std::string& bytes) {
  const TemporaryFolder folder;
  const std::string path = folder.file(name, bytes);
  const std::string message = message_of<Failure>([&] { (void)load_mesh(path); });
  const std::string prefix = path + ": ";
  return message.rfind(prefix, 0) == 0 ? message.substr(prefix.size()) : "(without the name) " + message;
}

MeshData loaded(const std::string& name, const std::string& bytes) {
  const TemporaryFolder folder;
  return load_mesh(folder.file(name, bytes));
}

/// A Collada file of one polygon with six corners whose material is half transparent.
std::string collada_polygon(const std::string& corners) {
  const std::string accessor =
      "<technique_common><accessor source=\"#pa\" count=\"6\" stride=\"3\"><param name=\"X\" "
      "type=\"float\"/><param name=\"Y\" type=\"float\"/><param name=\"Z\" type=\"float\"/></accessor>"
      "</technique_common>";
  return "<COLLADA version=\"1.4.1\"><library_effects><effect id=\"e\"><profile_COMMON><technique sid=\"c\">"
         "<lambert><transparency><float>0.5</float></transparency></lambert></technique></profile_COMMON>"
         "</effect></library_effects><library_materials><material id=\"m\"><instance_effect url=\"#e\"/>"
         "</material></library_materials><library_geometries><geometry id=\"g\"><mesh><source id=\"p\">"
         "<float_array id=\"pa\" count=\"18\">" +
         corners + "</float_array>" + accessor +
         "</source><vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>"
         "<polylist material=\"m\" count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>"
         "<vcount>6</vcount><p>0 1 2 3 4 5</p></polylist></mesh></geometry></library_geometries>"
         "<library_visual_scenes><visual_scene id=\"s\"><node id=\"n\"><instance_geometry url=\"#g\">"
         "<bind_material><technique_common><instance_material symbol=\"m\" target=\"#m\"/>"
         "</technique_common></bind_material></instance_geometry></node></visual_scene>"
         "</library_visual_scenes><scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>";
}

double area_of(const MeshData& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3& a = mesh.positions[t[0]];
    area += length(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a)) / 2;
  }
  return area;
}

std::vector<std::string> warnings_of(const std::string& name, const std::string& bytes) {
  const TemporaryFolder folder;
  return load_model_file(folder.file(name, bytes)).warnings;
}

}  // namespace

TEST_CASE("OBJ polygons are triangulated and their normals face the front") {
  const MeshData mesh = loaded("a.obj", std::string(kSquare) + "f 1 2 3 4\n");
  CHECK(mesh.triangles.size() == 2);
  CHECK(mesh.positions.size() == 4);
  for (const Vec3& n : mesh.normals) CHECK(n == Vec3{0, 0, 1});
}

TEST_CASE("a concave polygon is covered once, whichever way it lies") {
  struct Polygon {
    std::vector<std::pair<double, double>> corners;
    double area;
  };
  const std::vector<Polygon> polygons = {
      {{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}, 10},
      {{{0, 0}, {2, 1}, {4, 0}, {2, 4}}, 6},                   // a quad
      {{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {0, 4}, {0, 2}}, 16},  // corners on edges
      {{{0, 0},
        {6, 0},
        {6, 6},
        {2, 6},
        {2, 2},
        {4, 2},
        {4, 4},
        {3, 4},
        {3, 3},
        {2.5, 3},
        {2.5, 5},
        {5, 5},
        {5, 1},
        {0, 1}},
       18},                                                                                     // a spiral
      {{{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}}, 32}};  // a hole
  for (const Polygon& polygon : polygons) {
    for (const int way : {0, 1, 2, 3, 4, 5}) {
      std::string obj;
      std::string face = "f";
      for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const auto [x, y] = polygon.corners[i];
        const double c[3] = {way < 3 ? x : y, way < 3 ? y : x, 7};
        for (int k = 0; k < 3; ++k) obj += (k == 0 ? "v " : " ") + std::to_string(c[(k + way) % 3]);
        obj += "\n";
        face += " " + std::to_string(i + 1);
      }
      CAPTURE(obj);
      const MeshData mesh = loaded("a.obj", obj + face);
      double area = 0;
      Vec3 sum;
      for (const auto& t : mesh.triangles) {
        const Vec3 twice =
            cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
        area += length(twice) / 2;
        sum = sum + twice * 0.5;
      }
      CHECK(area == Approx(polygon.area));
      CHECK(length(sum) == Approx(polygon.area));
    }
  }
}

TEST_CASE(
    "OBJ: vn normals, references of every form, negative ones, comments, continued lines, DOS line ends") {
  const std::string text =
      std::string("# square\r\nmtllib none.mtl\r\no x\r\n") + kSquare +
      "vt 0 0\nvn 0 0 1\nvn 0 1 0 # up\nusemtl m\ns 1\nf 1/1/2 \\\n 2//2 3/1/2\nf 1 -2 -1\n";
  const MeshData mesh = loaded("a.OBJ", text);
  REQUIRE(mesh.triangles.size() == 2);
  CHECK(mesh.normals[mesh.triangles[0][0]] == Vec3{0, 1, 0});
  CHECK(mesh.normals[mesh.triangles[1][0]] == Vec3{0, 0, 1});
  CHECK(mesh.positions[mesh.triangles[1][1]] == Vec3{1, 1, 0});
}

TEST_CASE("every wrong OBJ gets a line that names the place and the value") {
  const std::string square = kSquare;
  CHECK(complaint("a.obj", "") == "empty file");
  CHECK(complaint("a.obj", " \n\n") == "empty file");
  CHECK(complaint("a.obj", "hello world\n") == "not an OBJ mesh (no vertices)");
  CHECK(complaint("a.obj", square) == "no faces");
  CHECK(complaint("a.obj", square + "f 1 2 7\n") == "line 5: vertex index out of range (7; there are 4)");
  CHECK(complaint("a.obj", square + "f 1 2 0\n") == "line 5: vertex index out of range (0; there are 4)");
  CHECK(complaint("a.obj", square + "f 1 2 -5\n") == "line 5: vertex index out of range (-5; there are 4)");
  CHECK(complaint("a.obj", square + "f 1 2 x\n") == "line 5: 'x' is not a vertex index");
  CHECK(complaint("a.obj", square + "f 1 2 1/1/1/1\n") == "line 5: '1/1/1/1' is not a corner of a face");
  CHECK(complaint("a.obj", "v 0 zero 0\n" + square + "f 1 2 3\n") == "line 1: 'zero' is not a number");
  CHECK(complaint("a.obj", square + "v 0 nan 0\nf 1 2 5\n") == "line 5: 'nan' is not a finite number");
  CHECK(complaint("a.obj", square + "v 0 0 -1.#IND\nf 1 2 5\n") == "line 5: '-1.#IND' is not a number");
  CHECK(complaint("a.obj", square + "v 0 1e39 0\nf 1 2 5\n") ==
        "line 5: '1e39' is too large (the limit is 1e30)");
  CHECK(complaint("a.obj", square + "v 0 1e999 0\nf 1 2 5\n") ==
        "line 5: '1e999' is too large (the limit is 1e30)");
  CHECK(complaint("a.obj", square + "f 1 2 5\nv 1 2") == "line 6: a number is missing");
  CHECK(complaint("a.obj", square + "f 1 1 2\n") == "no faces with an area (1 dropped)");
  CHECK(complaint("a.obj", std::string("v \0\1\2", 5)) == "not a text file (byte 0 at offset 2)");
}

TEST_CASE("a mesh that is too large names the limit") {
  std::string many = kSquare;
  for (std::size_t i = 0; i <= kMaxTriangles; ++i) many += "f 1 2 3\n";
  CHECK(complaint("a.obj", many) == "too many triangles (more than 1048576, the limit)");
}

TEST_CASE("a part of many vertices becomes two meshes, but a single mesh has too many") {
  std::string vertices;
  std::string faces;
  for (int i = 0; i < 66'000; ++i) {
    vertices += "v 0 " + std::to_string(i % 300) + " " + std::to_string(i / 300) + "\n";
    if (i < 65'700 && i % 300 != 299)
      faces +=
          "f " + std::to_string(i + 1) + " " + std::to_string(i + 2) + " " + std::to_string(i + 301) + "\n";
  }
  CHECK(complaint("a.obj", vertices + faces) == "too many vertices (more than 65536, the limit)");
  const TemporaryFolder folder;
  const Model model = load_model_file(folder.file("a.obj", vertices + faces));
  REQUIRE(model.parts.size() == 1);
  const FixedModel fixed = to_fixed(model);
  REQUIRE(fixed.meshes.size() == 2);
  CHECK(fixed.meshes[0].positions.size() + fixed.meshes[1].positions.size() >= 65'999);
  CHECK(fixed.triangle_count() == model.triangle_count());
}

TEST_CASE("files that are not there or of no known kind") {
  const TemporaryFolder folder;
  CHECK(message_of<Failure>([&] { (void)load_mesh(folder / "none.obj"); }) ==
        (folder / "none.obj") + ": cannot read (no such file)");
  CHECK(message_of<Failure>([] { (void)load_mesh("picture.jpg"); }) ==
        "picture.jpg: not a mesh that can be read (.obj, .ply, .stl, .off, .gltf, .glb, .dae, .zae, .fbx, "
        ".3ds, .bin, "
        "sphere:32x16, torus:48x24)");
}

TEST_CASE("OFF: a cube, and what can be wrong with one") {
  const std::string head = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  CHECK(loaded("a.off", head + "4 0 1 2 3\n3 0 2 1 255 0 0\n").triangles.size() == 3);
  CHECK(complaint("a.off", "SOFF\n") == "line 1: expected OFF, not 'SOFF'");
  CHECK(complaint("a.off", "4OFF\n") == "line 1: only three dimensions can be read, not those of '4OFF'");
  CHECK(complaint("a.off", "OFF BINARY\n\1") == "line 1: a binary OFF file cannot be read");
  CHECK(complaint("a.off", head + "5000 0 1\n") ==
        "line 7: number of corners out of range (5000; allowed are 0 to 4096)");
  CHECK(complaint("a.off", "OFF\n") == "line 1: the file ends before its counts");
  CHECK(complaint("a.off", "OFF\n4 x 0\n") == "line 2: 'x' is not an integer (face count)");
  CHECK(complaint("a.off", "OFF\n4 9999999 0\n") ==
        "line 2: face count out of range (9999999; allowed are 1 to 1048576)");
  CHECK(complaint("a.off", head + "3 0 1 2\n") == "line 7: the file ends before face 2 of 2");
  CHECK(complaint("a.off", head + "3 0 1 4\n3 0 1 2\n") ==
        "line 7: vertex index out of range (4; allowed are 0 to 3)");
  CHECK(complaint("a.off", "OFF 2 1 0\n0 0 0\n0 inf 0\n3 0 1 0\n") ==
        "line 3: 'inf' is not a number up to 1e30 in vertex 2 of 2");
}

TEST_CASE("an empty mesh binary is refused") { CHECK(complaint("a.bin", "") == "empty file"); }

TEST_CASE("OFF: keywords of other programs, none at all, and line ends of old Macs") {
  const auto square = [](const std::string& keyword, const std::string& more) {
    return keyword + "4 1 0\n0 0 0" + more + "\n1 0 0" + more + "\n1 1 0" + more + "\n0 1 0" + more +
           "\n4 0 1 2 3\n";
  };
  const std::vector<std::string> colours = {"left out: vertex colours (4)"};
  for (const char* keyword : {"OFF\n", "off\n", "OFF ", "", "STOFF\n"}) {
    CAPTURE(keyword);
    CHECK(loaded("a.off", square(keyword, "")).triangles.size() == 2);
    CHECK(warnings_of("a.off", square(keyword, "")).empty());
  }
  CHECK(warnings_of("a.off", square("COFF\n", " 255 0 0 255")) == colours);
  CHECK(warnings_of("a.off", square("OFF\n", " 0.1 0.2 0.3")) == colours);
  CHECK(warnings_of("a.off", square("OFF\n", "") + "\n").empty());
  CHECK(warnings_of("a.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 7\n") ==
        std::vector<std::string>{"left out: face colours (1)"});
  const std::string coloured = square("CNOFF\n", " 0 0.6 0.8 255 0 0 255");
  for (const Vec3& n : loaded("a.off", coloured).normals) CHECK(length(n - Vec3{0, 0.6, 0.8}) < 1e-6);
  CHECK(warnings_of("a.off", coloured) == colours);
  std::string one_line = square("STCOFF ", " 9 9 9 9 9 9");
  std::replace(one_line.begin(), one_line.end(), '\n', ' ');
  CHECK(loaded("a.off", one_line).triangles.size() == 2);
  std::string mac = square("OFF\n", "");
  std::replace(mac.begin(), mac.end(), '\n', '\r');
  CHECK(loaded("a.off", mac).triangles.size() == 2);
}

TEST_CASE("STL: text and binary, and what can be wrong with them") {
  const std::string facet =
      "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\nendfacet\n";
  CHECK(loaded("a.stl", "solid a\n" + facet + facet + "endsolid a\n").triangles.size() == 2);
  CHECK(complaint("a.stl", "solid a\nendsolid a\n") == "no faces");
  CHECK(complaint("a.stl", "solid a\n" + facet) == "line 8: the file ends before endsolid");
  CHECK(complaint("a.stl", "solid a\n" + facet.substr(0, 40)) ==
        "line 4: the file ends before the rest of facet 1");
  CHECK(complaint("a.stl", "solid a\n" + facet.substr(0, 46)) ==
        "line 4: the file ends before the rest of facet 1");
  std::string wrong = "solid a\n" + facet + "endsolid a\n";
  wrong.insert(wrong.find(" outer"), " 0");
  CHECK(complaint("a.stl", wrong) == "line 3: expected 'outer', not '0' in the rest of facet 1");
  wrong = "solid a\n" + facet + "endsolid a\n";
  wrong.replace(wrong.find("1 0 0"), 1, "nan");
  CHECK(complaint("a.stl", wrong) == "line 5: 'nan' is not a number up to 1e30 in the rest of facet 1");
  const std::string neither = "not an STL mesh (neither text that begins with 'solid' nor binary)";
  CHECK(complaint("a.stl", "neither\n") == neither);
  CHECK(complaint("a.stl", std::string(100, 'v')) == neither);  // an OBJ file of another name

  std::string binary(84, '\0');
  binary[80] = 1;
  binary += std::string(50, '\0');
  const auto put = [&binary](std::size_t number, const char* bytes) {
    for (std::size_t i = 0; i < 4; ++i) binary[84 + 4 * number + i] = bytes[i];
  };
  put(6, "\x00\x00\x80\x3F");
  put(10, "\x00\x00\x80\x3F");
  const MeshData mesh = loaded("a.stl", binary);
  REQUIRE(mesh.triangles.size() == 1);
  CHECK(mesh.normals[0] == Vec3{0, 0, 1});
  CHECK(complaint("a.stl", binary.substr(0, 130)) == "truncated (130 bytes of 134 for 1 triangles)");
  // A header may say "solid", and bytes may follow.
  std::string solid = binary;
  solid.replace(0, 5, "solid");
  CHECK(loaded("a.stl", solid).triangles.size() == 1);
  CHECK(warnings_of("a.stl", solid + "more") ==
        std::vector<std::string>{"left out: bytes after the last of 1 triangles (4)"});
  CHECK(complaint("a.stl", solid.substr(0, 130)) == "truncated (130 bytes of 134 for 1 triangles)");
  CHECK(warnings_of("a.stl", solid).empty());
  solid[133] = static_cast<char>(0x80);
  CHECK(warnings_of("a.stl", solid) == std::vector<std::string>{"left out: face colours (1)"});
  put(10, "\x00\x00\xC0\x7F");
  CHECK(complaint("a.stl", binary) == "a coordinate of triangle 1 is not a finite number");
  binary[82] = 0x7F;
  CHECK(complaint("a.stl", binary) == "too many triangles (8323073; the limit is 1048576)");
}

TEST_CASE("STL: text in upper case, with a byte order mark, in UTF-16, and with line ends of old Macs") {
  std::string text =
      "SOLID A\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 0\nENDLOOP\nENDFACET\n"
      "ENDSOLID A\n";
  CHECK(loaded("a.stl", text).triangles.size() == 1);
  CHECK(loaded("a.stl", "\xEF\xBB\xBF" + text).triangles.size() == 1);
  std::string wide = "\xFF\xFE";
  for (const char c : text) wide += {c, '\0'};
  CHECK(loaded("a.stl", wide).triangles.size() == 1);
  std::replace(text.begin(), text.end(), '\n', '\r');
  CHECK(loaded("a.stl", text).triangles.size() == 1);
}

TEST_CASE("PLY: text and both byte orders give the same mesh") {
  const std::string header =
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const MeshData text = loaded(
      "a.ply", "ply\nformat ascii 1.0\ncomment C:\\\n" + header + "0 0 0 9\n1 0 0 9\n0 1 0 9\n3 0 1 2\n");
  const std::string zero(4, '\0');
  const std::string little_one("\0\0\x80\x3F", 4);
  const std::string big_one("\x3F\x80\0\0", 4);
  const auto body = [&zero](const std::string& one, const std::string& indices) {
    return zero + zero + zero + "r" + one + zero + zero + "r" + zero + one + zero + "r\3" + indices;
  };
  const MeshData little = loaded("a.ply", "ply\nformat binary_little_endian 1.0\n" + header +
                                              body(little_one, std::string("\0\0\0\0\1\0\0\0\2\0\0\0", 12)));
  const MeshData big = loaded("a.ply", "ply\nformat binary_big_endian 1.0\n" + header +
                                           body(big_one, std::string("\0\0\0\0\0\0\0\1\0\0\0\2", 12)));
  CHECK(text.positions == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(little.positions == text.positions);
  CHECK(big.positions == text.positions);
  CHECK(little.triangles == text.triangles);
  CHECK(big.triangles == text.triangles);
}

TEST_CASE("PLY: opacity of vertices is left out, with a warning") {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  CHECK(
      warnings_of("a.ply", header + "0 0 0 9 9 9 255\n1 0 0 9 9 9 255\n0 1 0 9 9 9 255\n3 0 1 2\n").empty());
  CHECK(warnings_of("a.ply", header + "0 0 0 9 9 9 255\n1 0 0 9 9 9 254\n0 1 0 9 9 9 0\n3 0 1 2\n") ==
        std::vector<std::string>{"left out: opacity of vertices (2)"});
}

TEST_CASE("a triangle has the mean of its colours after each is limited; sharp edges are those of faces") {
  const TemporaryFolder folder;
  const std::string file = "v 0 0 0 510 -255 0\nv 1 0 0 0 255 0\nv 0 1 0 0 255 255\nf 1 2 3\n";
  const Model model =
      load_model_file(folder.file("a.obj", file), TexturePointsOf::kTexturedParts, VertexColours::kMean);
  CHECK(length(model.parts[0].look.material.colour.value() - Vec3{1, 2, 1} * (1.0 / 3)) < 1e-6);
  CHECK(model.crease_degrees == 40);
}

TEST_CASE("PLY: what can be wrong with one") {
  const std::string head = "ply\nformat ascii 1.0\n";
  const std::string vertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
  const std::string body = "end_header\n0 0 0\n1 0 0\n0 1 0\n";
  CHECK(complaint("a.ply", "nothing\n") == "line 1: expected 'ply'");
  CHECK(complaint("a.ply", "ply\nformat text 1.0\n") == "line 2: 'text' is not a format");
  CHECK(complaint("a.ply", head + vertices) == "line 6: the file ends before end_header");
  CHECK(complaint("a.ply", head + "element vertex -1\n") ==
        "line 3: number of elements out of range (-1; allowed are 0 to 2147483647)");
  CHECK(complaint("a.ply", head + "property half x\n") == "line 3: a property before any element");
  CHECK(complaint("a.ply", head + "element vertex 3\nproperty half x\n") == "line 4: 'half' is not a type");
  CHECK(complaint("a.ply", head + vertices + body) == "no faces");
  CHECK(complaint("a.ply", head + faces + "end_header\n3 0 1 2\n") == "no vertices");
  CHECK(complaint("a.ply", head + vertices + vertices + body) == "two elements are named 'vertex'");
  CHECK(complaint("a.ply", head + vertices + faces + body) == "line 12: the file ends before face 1 of 1");
  CHECK(complaint("a.ply", head + vertices + faces + body + "3 0 1 3\n") ==
        "line 13: vertex index out of range (3; allowed are 0 to 2) in face 1 of 1");
  CHECK(complaint("a.ply", head + vertices + "element face 1\nproperty list int int vertex_indices\n" + body +
                               "4097 0\n") ==
        "line 13: too many corners (4097; the limit is 4096) in face 1 of 1");
  CHECK(complaint("a.ply", head + vertices + faces + "end_header\n0 0 0\n1 no 0\n0 1 0\n3 0 1 2\n") ==
        "line 11: a coordinate is not a number up to 1e30 in vertex 2 of 3");
  CHECK(complaint("a.ply", head + "element vertex 9\nproperty float x\n" + faces + "end_header\n1\n") ==
        "line 7: the vertices have no x, y and z");
  CHECK(complaint("a.ply", "ply\nformat binary_little_endian 1.0\n" + vertices + faces +
                               "end_header\n\1\2\3") == "line 9: the file ends before vertex 1 of 3");
}

TEST_CASE("PLY: faces before vertices, triangle strips, free line breaks, and line ends of old Macs") {
  const std::string head = "ply\nformat ascii 1.0\n";
  const std::string vertices = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string faces = "element face 2\nproperty list uchar int vertex_indices\n";
  const std::string strips = "element tristrips 1\nproperty list int int vertex_indices\n";
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
  const std::string ordered = head + vertices + faces + "end_header\n" + points + "3 0 1 2\n3 2 1 3\n";
  const MeshData expected = loaded("a.ply", ordered);
  REQUIRE(expected.triangles.size() == 2);
  std::string mac = ordered;
  std::replace(mac.begin(), mac.end(), '\n', '\r');
  for (const std::string& same :
       {head + faces + vertices + "end_header\n3 0 1 2\n3 2 1 3\n" + points,
        head + vertices + strips + "end_header\n" + points + "4 0 1 2 3\n",
        head + vertices + strips + "end_header\n" + points + "8 0 1 2 -1 2 1 3 -1\n",
        head + vertices + strips + "end_header\n" + points + "7 0 1 2 2 2 1 3\n",
        head + vertices + faces + "end_header\n0 0\n0 1 0 0\n0 1 0 1 1\n\n0 3 0\n1 2 3 2 1\n3\n",
        head + vertices + faces + "end_header\n0 0 0 1 0 0 0 1 0 1 1 0 3 0 1 2 3 2 1 3\n", mac}) {
    CAPTURE(same);
    const MeshData mesh = loaded("a.ply", same);
    CHECK(mesh.positions == expected.positions);
    CHECK(mesh.triangles == expected.triangles);
    CHECK(mesh.normals == expected.normals);
  }
  // A line may hold more than the header says if each element has its own.
  const std::string more = "0 0 0 9\n1 0 0 9\n0 1 0 9\n1 1 0 9\n3 0 1 2 7\n3 2 1 3\n";
  CHECK(loaded("a.ply", head + vertices + faces + "end_header\n" + more).triangles == expected.triangles);
  CHECK(complaint("a.ply", head + vertices + strips + "end_header\n" + points + "3 0 1 4\n") ==
        "line 14: vertex index out of range (4; allowed are -1 to 3) in tristrips 1 of 1");
  CHECK(complaint("a.ply",
                  head + vertices + faces + "end_header\n0 0 0 1 0 0\n0 1 0 1 1 0\n3 0 1 2 3 2 1 3 9\n") ==
        "line 12: more numbers than its counts announce");
  CHECK(complaint("a.ply", "ply\nformat binary_little_endian 1.0\n" + vertices + strips + "end_header\n" +
                               std::string("\xFF\xFF\xFF\x7E", 4) + std::string(44, '\0') +
                               std::string("\3\0\0\0\0\0\0\0\1\0\0\0\2\0\0\0", 16)) ==
        "line 9: a coordinate is not a number up to 1e30 in vertex 1 of 4");
}

TEST_CASE("OBJ: line ends of old Macs, and a face of too many corners") {
  std::string text = std::string(kSquare) + "f 1 2 3 4\n";
  std::replace(text.begin(), text.end(), '\n', '\r');
  CHECK(loaded("a.obj", text).triangles.size() == 2);
  std::string polygon;
  for (int i = 0; i < 4097; ++i) {
    const double angle = i * 2 * std::acos(-1.0) / 4097;
    polygon += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
  }
  polygon += "f";
  for (int i = 1; i <= 4096; ++i) polygon += " " + std::to_string(i);
  CHECK(loaded("a.obj", polygon).triangles.size() > 4000);
  CHECK(complaint("a.obj", polygon + " 4097") ==
        "line 4098: a face has too many corners (4097; the limit is 4096)");
  std::string many = polygon + "\n";
  for (int i = 0; i < 8; ++i) many += many.substr(many.find('f'));
  CHECK(complaint("a.obj", many + many.substr(many.find('f'))) ==
        "too many triangles (more than 1048576, the limit)");
}

TEST_CASE("Collada: a concave polygon keeps its notch") {
  CHECK(area_of(loaded("a.dae", collada_polygon("0 0 0 2 0 0 2 1 0 1 1 0 1 2 0 0 2 0"))) == Approx(3));
}

TEST_CASE("Collada: opacity is left out, with a warning") {
  CHECK(warnings_of("a.dae", collada_polygon("0 0 0 2 0 0 3 1 0 2 2 0 0 2 0 -1 1 0")) ==
        std::vector<std::string>{"left out: opacity of materials (1)"});
}

TEST_CASE("Collada: a constant material shows its emission without light") {
  std::string text = collada_polygon("0 0 0 2 0 0 3 1 0 2 2 0 0 2 0 -1 1 0");
  const std::string lambert = "<lambert><transparency><float>0.5</float></transparency></lambert>";
  text.replace(text.find(lambert), lambert.size(),
               "<constant><emission><color>0.25 0.5 0.75 1</color></emission></constant>");
  const TemporaryFolder folder;
  const FileMaterial material = load_model_file(folder.file("a.dae", text)).parts[0].look.material;
  CHECK(material.unlit);
  CHECK(material.colour == Vec3{0.25, 0.5, 0.75});
  CHECK(material.emission == Vec3{});
}

TEST_CASE("Collada: nodes without a mesh are no faces") {
  CHECK(complaint("a.dae",
                  "<COLLADA version=\"1.4.1\"><library_visual_scenes><visual_scene id=\"s\"><node id=\"n\">"
                  "<translate>1 0 0</translate></node></visual_scene></library_visual_scenes><scene>"
                  "<instance_visual_scene url=\"#s\"/></scene></COLLADA>") == "no faces");
}

TEST_CASE("a small mesh far from the origin keeps its shape") {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
      "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "5000000 0 0\n5000000.3 0 0\n5000000.3 0.1 0\n3 0 1 2\n";
  const std::string obj = "v 5000000 0 0\nv 5000000.3 0 0\nv 5000000.3 0.1 0\nf 1 2 3\n";
  for (const MeshData& mesh : {loaded("a.ply", ply), loaded("a.obj", obj)}) {
    REQUIRE(mesh.positions.size() == 3);
    CHECK(mesh.positions[1].x - mesh.positions[0].x == Approx(0.3).margin(1e-6));
  }
}

TEST_CASE("what a picture does not need is left out, with one warning that names it and its number") {
  const std::string square = kSquare;
  const auto left_out = [](const std::string& obj) {
    const std::vector<std::string> warnings = warnings_of("a.obj", obj);
    return warnings.size() == 1 ? warnings[0] : std::to_string(warnings.size()) + " warnings";
  };
  CHECK(warnings_of("a.obj", square + "g a\ns 1\nf 1 2 3\ns off\nf 1 3 4\n").empty());
  CHECK(left_out(square + "cstype bspline\nsurf 0 1 0 1 1 2 3 4\nl 1 2\np 1\nf 1 2 3\n") ==
        "left out: curves and free-form surfaces (1), lines and points (2)");
  const std::string two = "left out: faces with fewer than three corners (1)";
  CHECK(left_out(square + "f 1 2\nf 1 2 3\n") == two);
  CHECK(warnings_of("a.off", "OFF 3 2 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 2\n")[0] == two);
  CHECK(warnings_of("a.ply",
                    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                    "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
                    "0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 2\n")[0] == two);
  for (const char* wrong : {"nan", "-1.#IND", "1.#QNAN", "inf", "no", "1e99"}) {
    CAPTURE(wrong);
    CHECK(left_out(square + "v 0 0 " + wrong + "\nf 1 2 3\n") ==
          "left out: positions that are not finite numbers, which no face uses (1)");
    CHECK(left_out(square + "vt 0 " + std::string(wrong) + "\nvt 0 0\nf 1/1 2/2 3\n") ==
          "left out: texture coordinates that are not finite numbers (1)");
    CHECK(left_out(square + "vn 0 0 " + wrong + "\nf 1//1 2 3\n") ==
          "left out: normals that are not finite numbers (1)");
  }
  CHECK(
      left_out(square + "f 1/5 2/x 3//9\n") ==
      "left out: normals of corners that do not exist (1), texture coordinates of corners that do not exist "
      "(2)");
}

namespace {

/// A triangle of each format whose first coordinate is `number`.
std::string triangle(const std::string& format, const std::string& number) {
  if (format == "obj") return "v " + number + " 0 0\nv 4 0 0\nv 4 1 " + number + "\nf 1 2 3\nv 9 9 9\n";
  if (format == "off") return "OFF 3 1 0\n" + number + " 0 0\n4 0 0\n4 1 " + number + "\n3 0 1 2\n";
  if (format == "stl") {
    return "solid\nfacet normal 0 0 1\nouter loop\nvertex " + number + " 0 0\nvertex 4 0 0\nvertex 4 1 " +
           number + "\nendloop\nendfacet\nendsolid\n";
  }
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty double y\nproperty float z\n"
         "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
         number + " 0 0\n4 0 0\n4 1 " + number + "\n3 0 1 2\n";
}

}  // namespace

TEST_CASE("every spelling of a number gives the mesh of the plain one, in every text format") {
  const std::string zeros(400, '0');
  const std::vector<std::string> of_half = {".5",
                                            "+.5",
                                            "+0.5",
                                            "00.5",
                                            ".5e0",
                                            ".5E+00",
                                            "5e-1",
                                            "5.e-1",
                                            "50.0e-02",
                                            "0.5000000000000000000000000",
                                            "5000000000000000000000000e-25",
                                            "0.0000000000000000000000005e24",
                                            "5" + zeros + "e-401",
                                            "0." + zeros + "5e400",
                                            "0.49999999999999999999999999999999"};
  const std::vector<std::string> of_less = {"-2", "-2.", "-02", "-2e0", "-.2e1", "-20e-1", "-2.0", "-0.02E2"};
  for (const char* format : {"obj", "off", "stl", "ply"}) {
    const auto mesh = [&](const std::string& number) {
      return loaded(std::string("a.") + format, triangle(format, number));
    };
    for (const auto& [plain, spellings] : {std::pair(0.5, of_half), std::pair(-2.0, of_less)}) {
      for (const std::string& spelling : spellings) {
        CAPTURE(format, spelling);
        const MeshData found = mesh(spelling);
        CHECK(found.positions == std::vector<Vec3>{{plain, 0, 0}, {4, 0, 0}, {4, 1, plain}});
        CHECK(found.triangles.size() == 1);
      }
    }
    for (const char* wrong :
         {"0,5", "0.5f", "0x1p-1", "1/2", "+-0.5", "--2", "e5", ".", "-", "5e", "0.5d0"}) {
      CAPTURE(format, wrong);
      CHECK(complaint(std::string("a.") + format, triangle(format, wrong)).find("line ") == 0);
    }
  }
}

TEST_CASE("a text whose lines break elsewhere is the same mesh") {
  for (const char* format : {"off", "stl", "ply"}) {
    std::string text = triangle(format, "0.5");
    const std::size_t header = std::string(format) == "ply" ? text.find("end_header") + 11 : 0;
    std::replace(text.begin() + static_cast<std::ptrdiff_t>(header), text.end(), '\n', ' ');
    CAPTURE(text);
    CHECK(loaded(std::string("a.") + format, text).positions ==
          std::vector<Vec3>{{0.5, 0, 0}, {4, 0, 0}, {4, 1, 0.5}});
  }
  // Without lines of their own faces have no colours, and colours of vertices have four numbers.
  CHECK(loaded("a.off", "CNOFF 3 1 0 0 0 0 0 0 1 9 9 9 9 1 0 0 0 0 1 9 9 9 9 0 1 0 0 0 1 9 9 9 9 3 0 1 2")
            .triangles.size() == 1);
}

TEST_CASE("real meshes of the loader's own collection") {
  const std::string folder = "/usr/share/assimp/models/";
  if (!std::filesystem::exists(folder)) return;
  for (const char* name :
       {"OBJ/box.obj", "OBJ/box_UTF16BE.obj", "OBJ/WusonOBJ.obj", "OBJ/spider.obj", "OBJ/concave_polygon.obj",
        "OFF/Wuson.off", "PLY/Wuson.ply", "PLY/cube_binary.ply", "STL/Spider_ascii.stl",
        "STL/Spider_binary.stl", "STL/triangle_with_two_solids.stl"}) {
    CAPTURE(name);
    const MeshData mesh = load_mesh(folder + name);
    CHECK(mesh.triangles.size() >= 2);
    CHECK(mesh.positions.size() == mesh.normals.size());
    for (const Vec3& n : mesh.normals) CHECK(length(n) == Approx(1.0).margin(1e-9));
  }
  for (const char* name : {"OBJ/point_cloud.obj", "OFF/invalid.off", "PLY/pond.0.ply",
                           "invalid/OutOfMemory.off", "invalid/empty.obj", "invalid/malformed.obj"}) {
    CAPTURE(name);
    CHECK_THROWS_AS(load_mesh(folder + name), Failure);
  }
  CHECK(load_mesh(folder + "STL/Spider_ascii.stl").triangles.size() ==
        load_mesh(folder + "STL/Spider_binary.stl").triangles.size());
}
