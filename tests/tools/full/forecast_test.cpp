// SPDX-License-Identifier: MIT
// `arcspan mesh --forecast`, as a user runs it.
#include <arcspan_tools/simulate/forecast.hpp>
#include <arcspan_tools/simulate/pose_cost.hpp>
#include <arcspan_tools/simulate/processor_cost.hpp>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <tests/tools/command_run.hpp>
#include <tests/tools/gltf_rig.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <array>
#include <cstddef>
#include <fstream>
#include <memory>
#include <string>

using namespace arcspan::test;

namespace {

nlohmann::json forecast_of(const std::string& model, const std::string& options = "") {
  const TemporaryFolder folder;
  const CommandRun done = run("mesh " + model + " -o " + (folder / "a.bin") + " --forecast " + options +
                              " --stats " + (folder / "a.json"));
  INFO(done.err);
  REQUIRE(done.status == 0);
  CHECK(done.out.find("forecast: ") != std::string::npos);
  return nlohmann::json::parse(contents(folder / "a.json")).at("forecast");
}

double figure(const nlohmann::json& forecast, const char* method, const char* core) {
  return forecast.at("instructions").at(method).at(core).get<double>();
}

/// A square of two triangles, and a third that is the first one seen from behind.
arcspan::tools::FixedMesh two_fronts_and_a_back() {
  arcspan::tools::FixedMesh mesh;
  mesh.positions = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}};
  mesh.indices = {0, 1, 2, 0, 2, 3, 0, 2, 1};
  return mesh;
}

}  // namespace

TEST_CASE("a forecast has figures of every method on every core") {
  const nlohmann::json made = forecast_of("torus:24x12");
  for (const char* core : {"Cortex-M0+", "Cortex-M3", "Cortex-M4", "RV32IMC"}) {
    CAPTURE(core);
    CHECK(figure(made, "flat", core) < figure(made, "gouraud", core));
    CHECK(figure(made, "gouraud", core) < figure(made, "arc", core));
    CHECK(figure(made, "arc", core) < figure(made, "arc in bands", core));
    CHECK(figure(made, "arc in bands", core) < 2 * figure(made, "arc", core));
  }
  CHECK(figure(made, "arc", "Cortex-M0+") > figure(made, "arc", "Cortex-M3"));
  CHECK(made.at("ram").at("pose") == 0);
  CHECK(made.at("ram").at("rows") == 2 * (576 + 36));
  CHECK(figure(forecast_of("torus:24x12", "--size 120x160"), "arc", "Cortex-M3") <
        figure(made, "arc", "Cortex-M3"));
}

TEST_CASE("bands keep the vertices and rows of all parts") {
  const TemporaryFolder folder;
  std::ofstream(folder / "two.obj")
      << "mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nusemtl a\nf 1 2 3\nf 2 4 3\n"
         "usemtl b\nf 1 3 2\n";
  std::ofstream(folder / "two.mtl") << "newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 1 0\n";
  const nlohmann::json ram = forecast_of(folder / "two.obj").at("ram");
  const std::size_t vertex = ram.at("vertices").get<std::size_t>() / 4;
  CHECK(ram.at("kept_vertices") == (4 + 3) * vertex);
  CHECK(ram.at("rows") == 2 * (2 + 1));  // no batch of 16
  const nlohmann::json one = forecast_of("torus:24x12").at("ram");
  CHECK(one.at("kept_vertices") == one.at("vertices"));
}

TEST_CASE("a forecast of a character has its joints, and the pose is paid for") {
  const std::string walker = std::string(ARCSPAN_EXAMPLES) + "/walker/walker.glb";
  const nlohmann::json moves = forecast_of(walker);
  const nlohmann::json stands = forecast_of(walker, "--pose rest");
  CHECK(moves.at("ram").at("pose") == 14 * 48 + 18 * 48);
  CHECK(stands.at("ram").at("pose") == 0);
  // By arc about 50 instructions per position and 15 per normal of 646 vertices more than at rest, 960 per
  // node and 560 per joint.
  const auto posing = [](const nlohmann::json& made, const char* core) {
    return made.at("posing").at(core).get<double>();
  };
  CHECK(posing(moves, "Cortex-M3") > 60'000);
  CHECK(posing(moves, "Cortex-M3") < 73'000);
  CHECK(posing(moves, "Cortex-M0+") > posing(moves, "Cortex-M3"));
  CHECK(posing(stands, "Cortex-M3") == 0);
  CHECK(figure(moves, "arc", "Cortex-M3") > posing(moves, "Cortex-M3"));
}

TEST_CASE("weights of a vertex cost what drawing meshes of such vertices alone takes") {
  // Counted of transform_all() in frames of tubes, of which each vertex has so many.
  CHECK(arcspan::tools::pose_cost("mps2-an385", "position 1") == Approx(171.3).epsilon(0.02));
  CHECK(arcspan::tools::pose_cost("mps2-an385", "position 2") == Approx(205.3).epsilon(0.02));
  CHECK(arcspan::tools::pose_cost("mps2-an385", "position 4") == Approx(330.3).epsilon(0.02));
}

TEST_CASE("flat shading poses the faces that it shades once more, not small ones without a pixel") {
  using namespace arcspan::tools;
  const FixedMesh mesh = two_fronts_and_a_back();
  FixedPartMotion motion;
  motion.weights = {{1}, {2}, {2}, {2}};
  FixedAnimation animation;
  animation.skins.resize(1);
  animation.parts = {motion};
  FixedModel model;
  model.meshes = {mesh};
  model.animation = std::make_shared<FixedAnimation>(animation);
  const auto amounts = [&model](const char* shading, double faces) {
    return pose_amounts(model, model, {4, 4, 99}, shading, faces);
  };
  using Kinds = std::array<double, 4>;
  CHECK(amounts("arc", 0).positions == Kinds{1, 3, 0, 0});
  CHECK(amounts("arc", 0).normals == Kinds{1, 3, 0, 0});
  CHECK(amounts("arc", 4).normals == Kinds{1, 3, 0, 0});
  CHECK(amounts("arc", 8).normals == Kinds{2, 6, 0, 0});  // backs are shaded, too, or in several bands
  CHECK(amounts("flat", 2).positions == Kinds{1 + 2, 3 + 4, 0, 0});
  CHECK(amounts("flat", 1).positions == Kinds{1 + 1, 3 + 2, 0, 0});
  CHECK(amounts("flat", 0).positions == Kinds{1, 3, 0, 0});
  CHECK(amounts("flat", 2).normals == Kinds{});
}

TEST_CASE("morph targets are posed, too") {
  using namespace arcspan::tools;
  const FixedMesh mesh = two_fronts_and_a_back();
  FixedPartMotion motion;
  motion.morph.emplace();
  motion.morph->records = {{}, {{}}, {{}, {}, {}}, {{}}};  // of 0, 1, 3 and 1 targets
  FixedAnimation animation;
  const auto amounts = [&](const char* shading, double shaded) {
    animation.parts = {motion};
    FixedModel model;
    model.meshes = {mesh};
    model.animation = std::make_shared<FixedAnimation>(animation);
    return pose_amounts(model, model, {4, 4, 99}, shading, shaded);
  };
  CHECK(amounts("arc", 4).morphed_positions.vertices == 4);
  CHECK(amounts("arc", 4).morphed_positions.targets == 5);
  CHECK(amounts("arc", 4).morphed_normals.vertices == 0);  // they stay as they are
  CHECK(amounts("flat", 2).morphed_positions.vertices == 4 + 6);
  CHECK(amounts("flat", 2).morphed_positions.targets == 5 + 8);
  motion.morph->has_normals = true;
  CHECK(amounts("arc", 4).morphed_normals.vertices == 3);
  CHECK(amounts("arc", 8).morphed_normals.targets == 2 * 5);
  CHECK(amounts("flat", 2).morphed_normals.vertices == 0);
  PoseAmounts one;
  one.morphed_positions = {10, 10};
  PoseAmounts four;
  four.morphed_positions = {10, 40};
  for (const ForecastCore& core : kForecastCores) {
    const auto cost = [&core](const char* name) { return pose_cost(core.weights, name); };
    CHECK(pose_instructions(core.weights, one) ==
          Approx(10 * (cost("position morph 1") - cost("position 0"))));
    CHECK(pose_instructions(core.weights, four) ==
          Approx(10 * (cost("position morph 4") - cost("position 0"))));
    CHECK(cost("position morph 4") > cost("position morph 1") + 3 * 10);
    CHECK(cost("normal morph 4") > cost("normal morph 1") + 3 * 10);
    CHECK(cost("normal morph 1") > cost("normal 0") + 100);
  }
}

TEST_CASE("a forecast of morph targets has their memory and their vertices") {
  const TemporaryFolder folder;
  const auto forecast_with = [&folder](std::size_t targets) {
    GltfRig rig = bending_tube();
    rig.clip("bend");
    rig.channel(2, "rotation", {0, 1}, rig.quadruples(joined({turn_z(0), turn_z(30)})));
    const Floats pull(make_tube(9).positions.size(), .1f);
    for (std::size_t i = 0; i < targets; ++i)
      rig.json["meshes"][0]["primitives"][0]["targets"].push_back({{"POSITION", rig.vectors(pull)}});
    std::ofstream(folder / "tube.glb", std::ios::binary) << rig.glb();
    return forecast_of(folder / "tube.glb");
  };
  const nlohmann::json none = forecast_with(0);
  const nlohmann::json two = forecast_with(2);
  CHECK(two.at("ram").at("pose").get<int>() == none.at("ram").at("pose").get<int>() + 2 * 2);
  const auto posing = [](const nlohmann::json& made) {
    return made.at("posing").at("Cortex-M3").get<double>();
  };
  CHECK(posing(two) > posing(none) + 36 * 50);
}

TEST_CASE("a forecast of a tiny picture poses few faces for flat shading") {
  const std::string walker = std::string(ARCSPAN_EXAMPLES) + "/walker/walker.glb --size 12x16";
  const nlohmann::json moves = forecast_of(walker);
  const nlohmann::json stands = forecast_of(walker, "--pose rest");
  const auto posing = [&](const char* method) {
    return figure(moves, method, "Cortex-M3") - figure(stands, method, "Cortex-M3");
  };
  CHECK(posing("flat") < posing("gouraud"));  // which takes normals of front faces
}

TEST_CASE("a forecast of a textured model has grey Gouraud in place of Gouraud") {
  const nlohmann::json sign = forecast_of(std::string(ARCSPAN_MODELS) + "/sign.obj");
  CHECK_FALSE(sign.at("instructions").contains("gouraud"));
  CHECK(figure(sign, "grey gouraud", "RV32IMC") > 0);
  // Its light is linear: Arc steps the level, too.
  CHECK(figure(sign, "grey gouraud", "Cortex-M3") == Approx(figure(sign, "arc", "Cortex-M3")).epsilon(.06));
}

TEST_CASE("a forecast draws textures in the size and with the levels that are compiled") {
  const TemporaryFolder folder;
  const std::string sign = std::string(ARCSPAN_MODELS) + "/sign.obj";
  for (const char* options : {"", "--texture-levels all", "--texture-size 8"}) {
    CAPTURE(options);
    REQUIRE(run("mesh " + sign + " -o " + (folder / "sign.bin") + " " + options).status == 0);
    // The textures of a binary are not made anew.
    const nlohmann::json compiled = forecast_of(folder / "sign.bin", options);
    const nlohmann::json made = forecast_of(sign, options);
    for (const char* method : {"flat", "grey gouraud", "arc", "arc in bands"})
      CHECK(figure(made, method, "Cortex-M3") == figure(compiled, method, "Cortex-M3"));
  }
  const auto arc = [&sign](const char* options) {
    return figure(forecast_of(sign, options), "arc", "Cortex-M3");
  };
  CHECK(arc("--texture-levels all") > arc("--texture-levels 1"));
}

TEST_CASE("a forecast draws textures in the format that is compiled") {
  const std::string sign = std::string(ARCSPAN_MODELS) + "/sign.obj --texture-format ";
  const nlohmann::json pal8 = forecast_of(sign + "pal8");
  const nlohmann::json pal4 = forecast_of(sign + "pal4");
  const nlohmann::json gray = forecast_of(sign + "gray");
  const nlohmann::json direct = forecast_of(sign + "rgb565");
  for (const char* core : {"Cortex-M0+", "Cortex-M3", "Cortex-M4", "RV32IMC"}) {
    CAPTURE(core);
    CHECK(figure(pal4, "arc", core) > figure(gray, "arc", core));
    CHECK(figure(gray, "arc", core) > figure(pal8, "arc", core));
    CHECK(figure(pal8, "arc", core) > figure(direct, "arc", core));
    CHECK(figure(pal4, "arc", core) < 1.2 * figure(pal8, "arc", core));
  }
}

TEST_CASE("a forecast says that borders of textures are not in it") {
  const TemporaryFolder folder;
  const auto says = [&folder](const char* clamp) {
    std::ofstream(folder / "sign.obj") << "mtllib sign.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\n"
                                          "vt 0 1\nusemtl a\nf 1/1 2/2 3/3\n";
    std::ofstream(folder / "sign.mtl") << "newmtl a\nmap_Kd -clamp " << clamp << " a.ppm\n";
    std::ofstream(folder / "a.ppm") << "P6 2 2 255\n000aaaaaa000";
    const CommandRun done =
        run("mesh " + (folder / "sign.obj") + " -o " + (folder / "a.bin") + " --forecast");
    REQUIRE(done.status == 0);
    return done.out.find("textures that do not repeat take") != std::string::npos;
  };
  CHECK(says("on"));
  CHECK_FALSE(says("off"));
}

TEST_CASE("options of the forecast without it are refused") {
  const TemporaryFolder folder;
  const CommandRun done = run("mesh torus:24x12 -o " + (folder / "a.bin") + " --cpu-mhz 64");
  CHECK(done.status != 0);
  CHECK(done.err.find("--cpu-mhz: is of --forecast") != std::string::npos);
}
