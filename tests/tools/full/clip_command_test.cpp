// SPDX-License-Identifier: MIT
// Clips in `arcspan render`, `turntable` and `mesh`, as a user runs them.
#include <arcspan_tools/image/image_file.hpp>
#include <catch2/catch.hpp>
#include <tests/tools/command_run.hpp>
#include <tests/tools/gltf_rig.hpp>
#include <tests/tools/temporary_folder.hpp>

using namespace arcspan::tools;
using namespace arcspan::test;

namespace {

std::string bending(const TemporaryFolder& folder) {
  GltfRig rig = bending_tube(5);
  rig.clip("bend");
  rig.channel(2, "rotation", {0, .5f, 1}, rig.quadruples(joined({turn_z(0), turn_z(70), turn_z(0)})));
  return folder.file("tube.glb", rig.glb());
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
  CHECK(read_image(folder / "a.png") == at_rest);
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

TEST_CASE("turntable plays a clip") {
  const TemporaryFolder folder;
  const std::string turn = "turntable " + bending(folder) + " --size 40x30 --frames 4 -o ";
  REQUIRE(run(turn + (folder / "still/")).status == 0);
  const CommandRun played = run(turn + (folder / "played/") + " --clip bend");
  REQUIRE(played.status == 0);
  CHECK(played.err.empty());
  CHECK(read_image(folder / "still/frame-0002.png") != read_image(folder / "played/frame-0002.png"));
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

TEST_CASE("the model of examples/walker.cpp is as mesh writes it") {
  const TemporaryFolder folder;
  const std::string of = std::string(ARCSPAN_EXAMPLES) + "/walker/";
  REQUIRE(run("mesh " + of + "walker.glb --name walker -o " + (folder / "model.h")).status == 0);
  CHECK(contents(folder / "model.h") == contents(of + "model.h"));
}
