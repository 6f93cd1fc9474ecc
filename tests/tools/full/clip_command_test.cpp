// SPDX-License-Identifier: MIT
// Clips in `arcspan render`, `turntable` and `mesh`, as a user runs them.
#include <arcspan/mesh/crc32.hpp>

#include <arcspan_tools/command/played_model.hpp>
#include <arcspan_tools/image/difference.hpp>
#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <catch2/catch.hpp>
#include <tests/tools/command_run.hpp>
#include <tests/tools/scene_rig.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <algorithm>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

using namespace arcspan::tools;
using namespace arcspan::test;

namespace {

std::string bending(const TemporaryFolder& folder, float end = 1, double last = 0) {
  GltfRig rig = bending_tube(5);
  rig.clip("bend");
  rig.channel(2, "rotation", {0, end / 2, end},
              rig.quadruples(joined({turn_z(0), turn_z(70), turn_z(last)})));
  return folder.file("tube.glb", rig.glb());
}

std::string bending_collada(const TemporaryFolder& folder) {
  ColladaTube tube(5);
  tube.channel("upper/turn.ANGLE", {0, .5f, 1}, {0, 70, 0});
  return folder.file("tube.dae", tube.text());
}

}  // namespace

TEST_CASE("render draws a pose of a clip, and a sheet of all clips") {
  const TemporaryFolder folder;
  const std::string draw = "render " + bending(folder) + " --size 40x30 -o " + (folder / "a.png");
  CHECK(run(draw).err == "arcspan: warning: " + (folder / "tube.glb") +
                             ": clips are not played, the model stands at rest: bend (1 s); see --pose\n");
  const Image at_rest = read_image(folder / "a.png");
  const CommandRun bent = run(draw + " --pose bend@0.5");
  REQUIRE(bent.status == 0);
  CHECK(bent.err.empty());
  CHECK(read_image(folder / "a.png") != at_rest);
  REQUIRE(run(draw + " --pose bend@1").status == 0);
  const Image at_end = read_image(folder / "a.png");
  REQUIRE(run(draw + " --pose bend@0").status == 0);
  CHECK(read_image(folder / "a.png") == at_end);
  REQUIRE(run(draw + " --clips").status == 0);
  const Image sheet = read_image(folder / "a.png");
  CHECK(sheet.width == 6 + 8 * 46);
  CHECK(sheet.height == 6 + 30 + 24 + 6);
  CHECK(run(draw + " --pose bend@2").err ==
        "arcspan: --pose: 2 is after the end of the clip 'bend' at 1 s\n");
  CHECK(run(draw + " --pose walk@0").err ==
        "arcspan: " + (folder / "tube.glb") + ": no clip 'walk' (there are: bend (1 s))\n");
  CHECK(run(draw + " --pose bend").err == "arcspan: --pose: expected CLIP@SECONDS or rest, not 'bend'\n");
}

TEST_CASE("a clip ends, for --pose too, where the list of clips says") {
  const TemporaryFolder folder;
  const std::string picture = " --size 40x30 -o " + (folder / "a.png");
  REQUIRE(run("render " + bending(folder, 1, 40) + picture + " --pose bend@1").status == 0);
  const Image at_end = read_image(folder / "a.png");
  const std::string draw = "render " + bending(folder, 25.f / 24, 40) + picture;
  CHECK(run(draw).err.find("bend (1.04167 s)") != std::string::npos);
  REQUIRE(run(draw + " --pose bend@1.04167").status == 0);
  CHECK(read_image(folder / "a.png") == at_end);
  REQUIRE(run(draw + " --pose bend@0").status == 0);
  CHECK(read_image(folder / "a.png") != at_end);
  CHECK(run(draw + " --pose bend@1.04168").err ==
        "arcspan: --pose: 1.04168 is after the end of the clip 'bend' at 1.04167 s\n");
}

TEST_CASE("turntable plays a clip") {
  const TemporaryFolder folder;
  const std::string turn = "turntable " + bending(folder) + " --size 40x30 --frames 4 -o ";
  REQUIRE(run(turn + (folder / "still/")).status == 0);
  const CommandRun played = run(turn + (folder / "played/") + " --clip bend");
  REQUIRE(played.status == 0);
  CHECK(played.err.empty());
  CHECK(read_image(folder / "still/frame-0002.png") != read_image(folder / "played/frame-0002.png"));
}

// As `arcspan show --clip` without --turntable takes them.
TEST_CASE("without a number of pictures a clip has those that its length takes") {
  const TemporaryFolder folder;
  RenderOptions options;
  options.mesh = bending(folder, 1.5);
  CHECK(PlayedModel(options, 0, 10).frames() == 1);
  options.clip = "bend";
  CHECK(PlayedModel(options, 4, 10).frames() == 4);
  CHECK(PlayedModel(options, 0, 0.1).frames() == 2);
  CHECK_THROWS_AS(PlayedModel(options, 0, 1e6), Failure);
  PlayedModel played(options, 0, 10);
  REQUIRE(played.frames() == 15);
  const FixedMesh at_rest = played.frame(0).meshes[0];
  CHECK(played.frame(7).meshes[0].positions != at_rest.positions);  // bent by 70 degrees after half the time
  CHECK(played.frame(0).meshes[0].positions == at_rest.positions);
}

TEST_CASE("a model binary is posed as the file that it was made of") {
  const TemporaryFolder folder;
  const std::string file = GENERATE(false, true) ? bending_collada(folder) : bending(folder);
  const std::string binary = folder / "tube.bin";
  REQUIRE(run("mesh " + file + " -o " + binary).status == 0);
  const auto drawn = [&](const std::string& command) {
    const CommandRun done = run(command + (folder / "a.png"));
    INFO(command << done.err);
    REQUIRE(done.status == 0);
    return read_image(folder / "a.png");
  };
  for (const std::string& how : std::vector<std::string>{"--pose bend@0.5", "--pose bend@0.2", "--clips"}) {
    // At 40x30 the last bit of the unit, which the two do not share, decides a pixel.
    const std::string options = " --size 44x33 " + how + " -o ";
    CHECK(drawn("render " + binary + options) == drawn("render " + file + options));
  }
  for (const char* command : {"render ", "turntable --frames 2 "}) {
    const std::string draw = command + binary + " --size 40x30";
    CHECK(drawn(draw + " -o ") == drawn(draw + " --pose rest -o "));
  }
  const std::string still = " --size 40x30 --eye 3,2,5 -o ";
  CHECK(drawn("render " + binary + still) != drawn("render " + binary + " --pose bend@0.5" + still));
  CHECK(run("render " + binary + still + (folder / "a.png")).err ==
        "arcspan: warning: " + binary +
            ": clips are not played, the model stands at rest: bend (1 s); see --pose\n");
  for (const char* command : {"turntable ", "simulate "}) {
    const std::string frames =
        command == std::string("turntable ") ? " --frames 4" : " --turntable 4 --panel ssd1306";
    REQUIRE(run(command + binary + frames + " --clip bend -o " + (folder / "bin/")).status == 0);
    REQUIRE(run(command + file + frames + " --clip bend -o " + (folder / "glb/")).status == 0);
    CHECK(contents(folder / "bin/frame-0002.png") == contents(folder / "glb/frame-0002.png"));
    std::filesystem::remove_all(folder / "bin");
    std::filesystem::remove_all(folder / "glb");
  }
  CHECK(run("render " + binary + " --pose walk@0 -o " + (folder / "b.png")).err ==
        "arcspan: " + binary + ": no clip 'walk' (there are: bend (1 s))\n");
}

TEST_CASE("a warning names a clip that moves nothing of the model") {
  const TemporaryFolder folder;
  GltfRig rig = bending_tube(5);
  rig.json["nodes"].push_back({{"name", "lamp"}});
  rig.json["scenes"][0]["nodes"].push_back(4);
  rig.clip("swing");
  rig.channel(4, "translation", {0, 1}, rig.vectors({0, 0, 0, 1, 0, 0}));
  const std::string file = folder.file("tube.glb", rig.glb());
  const CommandRun made = run("mesh " + file + " -o " + (folder / "tube.bin"));
  CHECK(made.status == 0);
  CHECK(made.err.find("clips that move nothing of the model are left out (1): 'swing'\n") !=
        std::string::npos);
}

TEST_CASE("a clip whose name is cut in a binary is played by its own, and a warning says what is cut") {
  const TemporaryFolder folder;
  GltfRig rig = bending_tube(5);
  const std::string name = std::string(31, 'a') + "bend";
  rig.clip(name.c_str());
  rig.channel(2, "rotation", {0, 1}, rig.quadruples(joined({turn_z(0), turn_z(70)})));
  const std::string file = folder.file("tube.glb", rig.glb());
  const CommandRun made = run("mesh " + file + " -o " + (folder / "tube.bin"));
  CHECK(made.status == 0);
  CHECK(made.err.find("names of clips and nodes are cut after 31 bytes (1): 'aaa") != std::string::npos);
  const std::string frames = "turntable " + file + " --size 40x30 --frames 2 --clip " + name + " -o ";
  REQUIRE(run(frames + (folder / "played/")).status == 0);
  REQUIRE(run("turntable " + file + " --size 40x30 --frames 2 -o " + (folder / "still/")).status == 0);
  CHECK(contents(folder / "played/frame-0001.png") != contents(folder / "still/frame-0001.png"));
}

TEST_CASE("mesh writes a model binary that moves as it is at rest, and says so") {
  const TemporaryFolder folder;
  const std::string binary = folder / "tube.bin";
  REQUIRE(run("mesh " + bending(folder) + " -o " + binary).status == 0);
  const CommandRun again = run("mesh " + binary + " -o " + (folder / "again.bin"));
  CHECK(again.status == 0);
  CHECK(again.err.find("its joints and clips are not written again") != std::string::npos);
  CHECK(contents(folder / "again.bin").find("SKIN") == std::string::npos);
}

TEST_CASE("a model binary whose animation contradicts itself is refused") {
  const TemporaryFolder folder;
  const std::string binary = folder / "tube.bin";
  REQUIRE(run("mesh " + bending(folder) + " -o " + binary).status == 0);
  std::string bytes = contents(binary);
  // The chunk's tag in the list of chunks: without its node list a skin has no nodes.
  const std::size_t at = bytes.find("NODE");
  REQUIRE(at != std::string::npos);
  bytes[at + 3] = 'F';
  const std::size_t end = bytes.size() - 4;
  const std::uint32_t sum =
      arcspan::crc32(std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), end));
  for (std::size_t i = 0; i < 4; ++i) bytes[end + i] = static_cast<char>(sum >> (8 * i) & 0xFF);
  const std::string damaged = folder.file("damaged.bin", bytes);
  const CommandRun refused = run("render " + damaged + " -o " + (folder / "a.png"));
  CHECK(refused.status != 0);
  CHECK(refused.err.find(damaged + ": its animation is damaged (") != std::string::npos);
}

TEST_CASE("a clip that mirrors is drawn with its fronts, and mesh warns that a device cannot") {
  const TemporaryFolder folder;
  GltfRig rig;
  rig.json["nodes"] = {{{"mesh", 0}, {"name", "leaf"}, {"scale", {-1, 1, 1}}}};
  rig.json["meshes"] = {
      {{"primitives", {{{"attributes", {{"POSITION", rig.vectors({0, 0, 0, 1, 0, 0, 0, 1, 0})}}}}}}}};
  const std::string still = folder.file("still.glb", rig.glb());
  rig.json["nodes"][0].erase("scale");
  rig.clip("flip");
  rig.channel(0, "scale", {0, 1}, rig.vectors({1, 1, 1, -1, 1, 1}), "STEP");
  const std::string moving = folder.file("moving.glb", rig.glb());
  const auto drawn = [&](const std::string& model) {
    const std::string picture = folder / "a.png";
    REQUIRE(
        run("render " + model + " --size 40x30 --eye 0,0,3 --target 0,0,0 --fov 40 -o " + picture).status ==
        0);
    return read_image(picture);
  };
  const Image wanted = drawn(still);
  const auto mean = [&](const std::string& model) { return difference(drawn(model), wanted).mean; };
  CHECK(mean(moving + " --pose flip@0") > 5);
  CHECK(mean(moving + " --pose flip@1") < 1);
  const CommandRun made = run("mesh " + moving + " -o " + (folder / "a.bin"));
  CHECK(made.err == "arcspan: warning: " + moving +
                        ": the clip 'flip' mirrors the node 'leaf', whose triangles show their backs then\n");
  const CommandRun baked = run("mesh " + moving + " --pose flip@1 -o " + (folder / "b.bin"));
  CHECK(baked.status == 0);
  CHECK(baked.err.empty());
}

TEST_CASE("a rig that cannot be stored is drawn all the same, and a warning says why") {
  const TemporaryFolder folder;
  GltfRig rig = bending_tube(5);
  rig.clip("bend");
  rig.channel(2, "rotation", {0, 1}, rig.quadruples(joined({turn_z(0), turn_z(70)})));
  rig.json["nodes"][0]["matrix"] = {1, 0, 0, 0, .5, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  rig.json["nodes"][0].erase("scale");
  const std::string file = folder.file("sheared.glb", rig.glb());
  const CommandRun drawn = run("render " + file + " --size 40x30 --pose bend@1 -o " + (folder / "a.png"));
  CHECK(drawn.status == 0);
  CHECK(drawn.err.find(": posed in doubles, because a device cannot: ") != std::string::npos);
}

TEST_CASE("what cannot be read of a character is one line") {
  const TemporaryFolder folder;
  const auto refused = [&](GltfRig rig, const char* pointer, const nlohmann::json& value) {
    rig.json[nlohmann::json::json_pointer(pointer)] = value;
    const CommandRun done = run("mesh " + folder.file("a.glb", rig.glb()) + " -o " + (folder / "a.bin"));
    CHECK(done.status != 0);
    CHECK(done.out.empty());
    CHECK_FALSE(std::filesystem::exists(folder / "a.bin"));
    return done.err.substr(std::min(done.err.size(), ("arcspan: " + (folder / "a.glb") + ": ").size()));
  };
  const GltfRig rig = bending_tube(5);
  CHECK(refused(rig, "/extensionsRequired", {"KHR_draco_mesh_compression"}) ==
        "needs the extension 'KHR_draco_mesh_compression', which cannot be read\n");
  CHECK(refused(rig, "/extensionsRequired", {"EXT_meshopt_compression"}) ==
        "needs the extension 'EXT_meshopt_compression', which cannot be read\n");
  CHECK(refused(rig, "/accessors/0/count", 4'000'000'000u) ==
        "accessors[0].count: is not an integer 0 to 4194304 (4000000000)\n");
  const CommandRun fbx =
      run("mesh " + folder.file("a.fbx", "Kaydara FBX Binary") + " -o " + (folder / "a.bin"));
  CHECK(fbx.status != 0);
  CHECK(fbx.err.find("a.fbx: cannot be read: ") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(folder / "a.bin"));
  const std::string old =
      "; FBX 6.1.0\nFBXHeaderExtension: {\nFBXVersion: 6100\n}\nObjects: {\n}\nConnections: {\n}\n";
  CHECK(run("mesh " + folder.file("b.fbx", old) + " -o " + (folder / "b.bin")).err ==
        "arcspan: " + (folder / "b.fbx") +
            ": FBX before version 7.1 cannot be read; export it as FBX 2011 or later\n");
}

TEST_CASE("mesh keeps clips, or bakes a pose") {
  const TemporaryFolder folder;
  const std::string compile = "mesh " + bending(folder) + " -o ";
  const CommandRun kept = run(compile + (folder / "a.bin"));
  REQUIRE(kept.status == 0);
  CHECK(kept.out.find("moves: 3 nodes, 2 joints, 0 morph targets; vertices with 1, 2, 3 and 4 weights: ") !=
        std::string::npos);
  CHECK(kept.out.find("  clip bend: 1 s, 1 channels, ") != std::string::npos);
  CHECK(kept.out.find("error of what is stored: ") != std::string::npos);
  REQUIRE(run(compile + (folder / "a.hpp")).status == 0);
  CHECK(contents(folder / "a.hpp").find("alignas(4) inline constexpr std::uint8_t kModel[] = {") !=
        std::string::npos);
  const CommandRun baked = run(compile + (folder / "b.bin") + " --pose bend@0.5");
  REQUIRE(baked.status == 0);
  CHECK(baked.out.find("moves: ") == std::string::npos);
  CHECK(contents(folder / "b.bin").find("SKIN") == std::string::npos);
  CHECK(run(compile + (folder / "c.bin") + " --planes").err ==
        "arcspan: --planes: needs --pose with a model that moves: planes do not\n");
}

/// The bytes of the words of a C header, as a little-endian machine has them.
std::string bytes_of_header(const std::string& header) {
  std::string bytes;
  for (std::size_t at = header.find("0x"); at != std::string::npos; at = header.find("0x", at + 1)) {
    const unsigned long word = std::stoul(header.substr(at + 2, 8), nullptr, 16);
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(word >> (8 * i) & 255u);
  }
  return bytes;
}

TEST_CASE("a header for C has the binary, also of a model that moves; a source for C stands at rest") {
  const TemporaryFolder folder;
  for (const std::string& model : {bending(folder), std::string("sphere:16x8")}) {
    CAPTURE(model);
    const CommandRun made = run("mesh " + model + " --c -o " + (folder / "a.h"));
    REQUIRE(made.status == 0);
    CHECK(made.err.find("rest") == std::string::npos);
    REQUIRE(run("mesh " + model + " -o " + (folder / "a.bin")).status == 0);
    const std::string header = contents(folder / "a.h");
    CHECK(header.find("\nstatic const uint32_t a[] = {\n") != std::string::npos);
    CHECK(bytes_of_header(header) == contents(folder / "a.bin"));
  }
  const CommandRun named = run("mesh sphere:16x8 --c --name ball -o h:-");
  REQUIRE(named.status == 0);
  CHECK(named.out.find("\n#ifndef ARCSPAN_MODEL_ball\n") != std::string::npos);
  const CommandRun source = run("mesh " + bending(folder) + " --c -o " + (folder / "a.cpp"));
  REQUIRE(source.status == 0);
  CHECK(
      source.err.find(": its joints and clips are not in a source for C, the model stands at rest (a .h has "
                      "them; see --pose)\n") != std::string::npos);
  CHECK(run("mesh sphere:16x8 --c -o " + (folder / "a.bin")).err ==
        "arcspan: " + (folder / "a.bin") +
            ": the name of a model for C must end in .cpp, a C++ source, or in .h, a binary\n");
}

TEST_CASE("the model of examples/walker.cpp is as mesh writes it") {
  const TemporaryFolder folder;
  const std::string of = std::string(ARCSPAN_EXAMPLES) + "/walker/";
  REQUIRE(run("mesh " + of + "walker.glb --name walker -o " + (folder / "model.h")).status == 0);
  CHECK(contents(folder / "model.h") == contents(of + "model.h"));
}
