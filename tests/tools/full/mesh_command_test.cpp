// SPDX-License-Identifier: MIT
// `arcspan mesh` as a user runs it.
#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/mesh/file/load.hpp>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <tests/tools/command_run.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <string>
#include <vector>

using namespace arcspan::tools;
using namespace arcspan::test;

TEST_CASE("mesh writes a header, figures and a picture of before and after") {
  const TemporaryFolder folder;
  const std::string out = folder / "my torus.hpp";
  const CommandRun made = run("mesh torus:48x24 -o '" + out + "' --max-bytes 8192 --stats " +
                              (folder / "s.json") + " --picture " + (folder / "p.png"));
  REQUIRE(made.status == 0);
  CHECK(made.err.empty());
  const auto json = nlohmann::json::parse(contents(folder / "s.json"));
  CHECK(json["model"]["triangles"] == 2304);
  CHECK(json["model"]["vertices"] == 1152);
  CHECK(json["mesh"]["bytes"].get<int>() <= 8192);
  const auto& shares = json["mesh"]["bytes_of"];
  CHECK(shares["positions"] == 6 * json["mesh"]["vertices"].get<int>());
  CHECK(shares["indices"] == 6 * json["mesh"]["triangles"].get<int>());
  CHECK(made.out.find(json["mesh"]["bytes"].dump() + " bytes, 16-bit indices\n") != std::string::npos);
  const std::string header = contents(out);
  CHECK(header.find("namespace my_torus {") != std::string::npos);
  CHECK(header.find("std::uint16_t kIndices[]") != std::string::npos);
  const Image picture = read_image(folder / "p.png");
  CHECK(picture.width == 640);
  CHECK(picture.height == 240);
  CHECK(folder.size() == 3);
}

TEST_CASE("a mesh binary can be rendered, and compiled into a header") {
  const TemporaryFolder folder;
  const std::string bin = folder / "a.bin";
  REQUIRE(run("mesh torus:24x12 -o " + bin).status == 0);
  // The binary's units are steps; from where the camera stands by itself both look alike.
  REQUIRE(run("render " + bin + " -o " + (folder / "a.ppm")).status == 0);
  REQUIRE(run("render torus:24x12 -o " + (folder / "b.ppm")).status == 0);
  const CommandRun compared = run("diff " + (folder / "a.ppm") + " " + (folder / "b.ppm"));
  INFO(compared.out);
  CHECK(std::stod(compared.out.substr(compared.out.find("mean ") + 5)) < 0.1);
  REQUIRE(run("mesh " + bin + " -o " + (folder / "a.hpp")).status == 0);
  CHECK(contents(folder / "a.hpp").find("namespace a {") != std::string::npos);
}

TEST_CASE("mesh writes planes if they are asked for, and counts them") {
  const TemporaryFolder folder;
  const std::string plain = folder / "plain.bin";
  const std::string planed = folder / "planed.bin";
  REQUIRE(run("mesh torus:24x12 -o " + plain).status == 0);
  const CommandRun made = run("mesh torus:24x12 --planes -o " + planed + " --stats " + (folder / "s.json"));
  REQUIRE(made.status == 0);
  CHECK(made.out.find(" bytes, 16-bit indices, planes\n") != std::string::npos);
  const auto json = nlohmann::json::parse(contents(folder / "s.json"));
  CHECK(json["mesh"]["planes"] == true);
  CHECK(json["mesh"]["bytes"] == contents(planed).size());
  CHECK(contents(planed).size() == contents(plain).size() + 4 + 4 * 576);
  // They are a firmware's: read back, the mesh is the same.
  for (const std::string& bin : {plain, planed}) {
    REQUIRE(run("mesh " + bin + " -o " + (folder / "again.bin")).status == 0);
    REQUIRE(run("mesh " + bin + " --planes -o " + (folder / "again-planed.bin")).status == 0);
    CHECK(contents(folder / "again.bin") == contents(plain));
    CHECK(contents(folder / "again-planed.bin") == contents(planed));
  }
  const std::string limited = folder / "limited.bin";
  REQUIRE(run("mesh torus:24x12 --planes --max-bytes 4000 -o " + limited).status == 0);
  CHECK(contents(limited).size() <= 4000);
}

TEST_CASE("mesh writes neighbours if they are asked for, counts them, and reads its binary again") {
  const TemporaryFolder folder;
  const std::string outlined = folder / "outlined.bin";
  const CommandRun made =
      run("mesh torus:24x12 --outlines -o " + outlined + " --stats " + (folder / "s.json"));
  REQUIRE(made.status == 0);
  CHECK(made.out.find(" bytes, 16-bit indices, neighbours\n") != std::string::npos);
  CHECK(contents(outlined).starts_with("ARCP"));
  const auto json = nlohmann::json::parse(contents(folder / "s.json"));
  CHECK(json["mesh"]["neighbours"] == true);
  CHECK(json["mesh"]["bytes"] == contents(outlined).size());
  CHECK(json["mesh"]["bytes_of"]["neighbours"] <= 576 * 7 / 2);
  CHECK(run("mesh " + outlined + " -o " + (folder / "again.hpp")).status == 0);
  const std::string limited = folder / "limited.hpp";
  REQUIRE(
      run("mesh torus:24x12 --outlines --max-bytes 4000 -o " + limited + " --stats " + (folder / "l.json"))
          .status == 0);
  CHECK(nlohmann::json::parse(contents(folder / "l.json"))["mesh"]["bytes"] <= 4000);
  REQUIRE(run("mesh torus:24x12 --outlines --c --name ring -o " + (folder / "c.cpp")).status == 0);
  CHECK(contents(folder / "c.cpp").find(", ring_arrays::make_neighbours},\n") != std::string::npos);
}

TEST_CASE(
    "a budget of bytes shrinks textures before it takes triangles, and the report says what takes what") {
  const TemporaryFolder folder;
  const std::string tiles = folder.file("big.ppm", "P6\n128 128\n255\n" + std::string(3 * 128 * 128, 'k'));
  const auto made = [&](const std::string& more) {
    const CommandRun run_of = run("mesh torus:24x12 --texture " + tiles + " -o " + (folder / "a.bin") +
                                  " --stats " + (folder / "s.json") + more);
    INFO(run_of.err);
    REQUIRE(run_of.status == 0);
    const auto json = nlohmann::json::parse(contents(folder / "s.json"));
    std::size_t sum = 0;
    for (const auto& share : json["mesh"]["bytes_of"]) sum += share.get<std::size_t>();
    CHECK(sum == json["mesh"]["bytes"]);
    CHECK(sum == contents(folder / "a.bin").size());
    CHECK(json["ram_at_320x240"]["depths"] == 153600);
    CHECK((run_of.out.find("shrunk") != std::string::npos) == (more.find(" --max-bytes") == 0));
    return json;
  };
  const auto whole = made("");
  CHECK(whole["textures"][0]["width"] == 128);
  const std::size_t mesh = whole["mesh"]["bytes"].get<std::size_t>() - 128 * 128;
  const auto half = made(" --max-bytes " + std::to_string(mesh + 64 * 64));
  CHECK(half["textures"][0]["width"] == 64);
  CHECK(half["mesh"]["triangles"] == whole["mesh"]["triangles"]);
  const auto least = made(" --max-bytes " + std::to_string(mesh));
  CHECK(least["textures"][0]["width"] == 32);
  CHECK(least["mesh"]["triangles"] < whole["mesh"]["triangles"]);
  // A size that was asked for stays.
  const auto fixed = made(" --texture-size 64 --max-bytes " + std::to_string(mesh));
  CHECK(fixed["textures"][0]["width"] == 64);
}

TEST_CASE("a budget of bytes does not count the textures of parts that simplification removes") {
  const TemporaryFolder folder;
  const std::string texels = "P6\n32 32\n255\n" + std::string(3 * 32 * 32, 'k');
  (void)folder.file("a.ppm", texels);
  (void)folder.file("b.ppm", texels);
  (void)folder.file("m.mtl", "newmtl a\nmap_Kd a.ppm\nnewmtl b\nmap_Kd b.ppm\n");
  // A plate, and a speck on it with a texture of its own.
  const std::string obj = folder.file("m.obj",
                                      "mtllib m.mtl\nv 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nv 4 4 1\nv 4.1 4 1\n"
                                      "v 4 4.1 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl a\n"
                                      "f 1/1 2/2 3/3 4/4\nusemtl b\nf 5/1 6/2 7/4\n");
  const CommandRun made = run("mesh " + obj + " --max-triangles 2 --max-bytes 2000 -o " + (folder / "m.bin") +
                              " --stats " + (folder / "s.json"));
  INFO(made.err);
  REQUIRE(made.status == 0);
  const auto stats = nlohmann::json::parse(contents(folder / "s.json"));
  CHECK(stats["textures"].size() == 1);
  CHECK(stats["mesh"]["triangles"] == 2);
}

TEST_CASE("a damaged mesh binary is refused in one line") {
  const TemporaryFolder folder;
  const std::string bin = folder / "a.bin";
  REQUIRE(run("mesh torus:24x12 -o " + bin).status == 0);
  std::string bytes = contents(bin);
  bytes[100] = static_cast<char>(bytes[100] ^ 1);
  const std::string bad = folder.file("b.bin", bytes);
  CHECK(run("mesh " + bad + " -o " + (folder / "c.hpp")).err ==
        "arcspan: " + bad + ": the mesh binary is damaged (corrupted)\n");
  const std::string cut = folder.file("d.bin", bytes.substr(0, 200));
  CHECK(run("render " + cut + " -o " + (folder / "c.png")).err ==
        "arcspan: " + cut + ": the mesh binary is damaged (truncated)\n");
  const std::string foreign = folder.file("e.bin", "GIF89a and so on, for some forty bytes or more");
  CHECK(run("mesh " + foreign + " -o " + (folder / "c.hpp")).err ==
        "arcspan: " + foreign + ": not a mesh binary of version 1 to 4\n");
  CHECK(folder.size() == 4);
}

TEST_CASE("mesh in a pipe: the result on standard output, the report on standard error") {
  const TemporaryFolder folder;
  const CommandRun header = run("mesh sphere:8x4 -o -");
  CHECK(header.status == 0);
  CHECK(header.out.find("#pragma once") != std::string::npos);
  CHECK(header.out.find("namespace sphere_8x4 {") != std::string::npos);
  CHECK(header.err.find("8-bit indices") != std::string::npos);
  REQUIRE(run("mesh sphere:8x4 -o " + (folder / "a.bin")).status == 0);
  CHECK(run("mesh sphere:8x4 -o bin:-").out == contents(folder / "a.bin"));
}

TEST_CASE("mesh warns of triangles that shading has to split") {
  const CommandRun coarse = run("mesh sphere:6x3 -o bin:-");
  CHECK(coarse.status == 0);
  CHECK(coarse.err.find("arcspan: warning: sphere:6x3: ") != std::string::npos);
  CHECK(run("mesh sphere:32x16 -o bin:-").err.find("warning") == std::string::npos);
}

TEST_CASE("mesh: wrong arguments and limits out of reach leave nothing behind") {
  struct Case {
    const char* arguments;
    int status;
    const char* complaint;
  };
  const Case wrong = GENERATE(values<Case>({
      {"--max-bytes 0", 2, "--max-bytes: expected an integer 1...1000000000, not '0'"},
      {"--max-triangles many", 2, "--max-triangles: expected an integer 1...1000000000, not 'many'"},
      {"--crease 181", 2, "--crease: expected a number 0...180, not '181'"},
      {"--name 3d", 2, "--name: '3d' cannot name a namespace"},
      {"--picture p.gif", 1, "p.gif: a picture's name must end in .png, .ppm or .pgm"},
  }));
  CAPTURE(wrong.arguments);
  const TemporaryFolder folder;
  const CommandRun refused = run("mesh torus:8x8 -o " + (folder / "a.hpp") + " " + wrong.arguments);
  CHECK(refused.status == wrong.status);
  CHECK(refused.err == "arcspan: " + std::string(wrong.complaint) + "\n");
  CHECK(run("mesh torus:8x8 -o " + (folder / "a.txt")).err ==
        "arcspan: " + (folder / "a.txt") + ": a compiled mesh's name must end in .hpp, .h or .bin\n");
  CHECK(run("mesh torus:8x8 --max-bytes 9 -o " + (folder / "a.hpp")).status == 1);
  CHECK(folder.size() == 0);
}

TEST_CASE("mesh: names of parts that a binary has no room for are cut at a character, and stay different") {
  const TemporaryFolder folder;
  const std::string longest(30, 'a');
  std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const char* end : {"\u00fc", "bc", "bd"}) obj += "o " + longest + end + "\nf 1 2 3\n";
  const std::string binary = folder / "a.bin";
  REQUIRE(run("mesh " + folder.file("a.obj", obj) + " -o " + binary).status == 0);
  std::vector<std::string> names;
  for (const ModelPart& part : load_model_file(binary).parts) names.push_back(part.look.names.back());
  CHECK(names == std::vector<std::string>{longest, longest + "b", std::string(29, 'a') + "a2"});
}
