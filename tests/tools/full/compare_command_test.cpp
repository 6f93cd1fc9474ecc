// SPDX-License-Identifier: MIT
// `arcspan compare` as a user runs it.
#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/render/render.hpp>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <tests/tools/command_run.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <filesystem>

using namespace arcspan::tools;
using namespace arcspan::test;

TEST_CASE("compare writes a sheet and tables of every shading") {
  const TemporaryFolder folder;
  const CommandRun done =
      run("compare sphere:12x6 --size 96x64 --no-instructions -o " + (folder / "a.png") + " --table " +
          (folder / "a.json") + " --table " + (folder / "a.csv") + " --table " + (folder / "a.md"));
  CHECK(done.err.empty());
  REQUIRE(done.status == 0);
  CHECK(read_image(folder / "a.png").width > 2 * 96);
  CHECK(contents(folder / "a.md") == done.out);
  const auto json = nlohmann::json::parse(contents(folder / "a.json"));
  const std::vector<std::string> names = shading_names();
  REQUIRE(json["methods"].size() == names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    CAPTURE(names[i]);
    const auto& method = json["methods"][i];
    CHECK(method["shading"] == names[i]);
    CHECK(method["nanoseconds"].get<double>() > 0);
    CHECK(method["instructions"].is_null());
    CHECK(method["rms_error"].get<double>() > 0.2);  // rounding alone is 0.29
    CHECK(method["ssim"].get<double>() > 0.5);
    CHECK(contents(folder / "a.csv").find("\n" + names[i] + ",") != std::string::npos);
    CHECK(done.out.find("| " + names[i] + " |") != std::string::npos);
  }
}

TEST_CASE("compare takes a choice of shadings, in that order") {
  const TemporaryFolder folder;
  REQUIRE(run("compare sphere:12x6 --size 48x32 --no-instructions --shading arc,flat,arc -o " +
              (folder / "a.ppm") + " --table " + (folder / "a.json"))
              .status == 0);
  const auto json = nlohmann::json::parse(contents(folder / "a.json"));
  REQUIRE(json["methods"].size() == 2);
  CHECK(json["methods"][0]["shading"] == "arc");
  CHECK(json["methods"][1]["shading"] == "flat");
  CHECK(json["methods"][0]["time_per_gouraud"].get<double>() > 0);  // though gouraud is not shown
}

TEST_CASE("compare has errors of textures, for the shadings that draw them") {
  const TemporaryFolder folder;
  const CommandRun done = run("compare sphere:12x6 --texture " ARCSPAN_MODELS
                              "/tiles.ppm --size 96x72 --no-instructions "
                              "--shading flat,gouraud,arc,phong -o " +
                              (folder / "a.ppm") + " --table " + (folder / "a.json"));
  REQUIRE(done.status == 0);
  CHECK(done.err.empty());
  CHECK(done.out.find("| max, textured | RMS, textured | PSNR, textured |") != std::string::npos);
  const auto methods = nlohmann::json::parse(contents(folder / "a.json"))["methods"];
  CHECK(methods[3]["textured_rms_error"].is_null());  // phong
  const auto rms = [&methods](std::size_t i) { return methods[i]["textured_rms_error"].get<double>(); };
  CHECK(rms(2) > 0.1);
  CHECK(rms(2) < 0.6);
  CHECK(rms(0) > rms(1));
  CHECK(rms(1) > 2 * rms(2));
  REQUIRE(run("compare sphere:8x4 --size 48x32 --no-instructions --shading arc -o " + (folder / "a.ppm") +
              " --table " + (folder / "b.csv"))
              .status == 0);
  CHECK(contents(folder / "b.csv").find("textured") == std::string::npos);
}

TEST_CASE("compare draws dichotomy by one polynomial or by all") {
  const TemporaryFolder folder;
  const std::string base = "compare sphere:12x6 --size 48x32 --no-instructions -o " + (folder / "a.ppm") +
                           " --table " + (folder / "a.json") + " --shading flat,dichotomy";
  const auto names = [&folder] {
    const auto json = nlohmann::json::parse(contents(folder / "a.json"));
    std::vector<std::string> all;
    for (const auto& method : json["methods"]) all.push_back(method["shading"]);
    return all;
  };
  REQUIRE(run(base).status == 0);
  CHECK(names() == std::vector<std::string>{"flat", "dichotomy-linear", "dichotomy-quadratic",
                                            "dichotomy-cubic", "dichotomy-root", "dichotomy-printed-linear",
                                            "dichotomy-printed-quadratic"});
  REQUIRE(run(base + " --polynomial cubic").status == 0);
  CHECK(names() == std::vector<std::string>{"flat", "dichotomy-cubic"});
  const auto multiplies = [&](const std::string& segment) {
    REQUIRE(run(base + " --polynomial cubic --segment " + segment).status == 0);
    return nlohmann::json::parse(contents(folder / "a.json"))["methods"][1].dump();
  };
  CHECK(multiplies("1") != multiplies("4"));
}

TEST_CASE("instructions are counted where valgrind is installed") {
  if (std::system("valgrind --version >/dev/null 2>&1") != 0) {
    WARN("valgrind is not installed");
    return;
  }
  const TemporaryFolder folder;
  const CommandRun done = run("compare sphere:12x6 --size 48x32 --shading flat,arc -o " + (folder / "a.ppm") +
                              " --table " + (folder / "a.json"));
  CHECK(done.err.empty());
  REQUIRE(done.status == 0);
  const auto methods = nlohmann::json::parse(contents(folder / "a.json"))["methods"];
  CHECK(methods[0]["instructions"].get<double>() > 5);
  CHECK(methods[1]["instructions_per_gouraud"].get<double>() > 1);
  CHECK(methods[1]["instructions"].get<double>() > 1.5 * methods[0]["instructions"].get<double>());
}

TEST_CASE("compare: wrong arguments are named in one line and nothing is written") {
  struct Case {
    const char* arguments;
    const char* complaint;
    int status;
  };
  const Case wrong = GENERATE(values<Case>({
      {"-o a.txt", "a.txt: a picture's name must end in .png, .ppm or .pgm", 1},
      {"-o a.ppm --table b.txt", "b.txt: a table's name must end in .md, .csv or .json", 1},
      {"-o a.ppm --reference none", "--reference: expected phong or slerp, not 'none'", 2},
      {"-o a.ppm --shading arc,ray", "with commas, not 'ray'", 2},
      {"-o a.ppm --shading ,", "not ''", 2},
      {"-o a.ppm --shading arc --polynomial cubic", "--polynomial: only dichotomy has one", 2},
      {"", "--output is required", 2},
  }));
  CAPTURE(wrong.arguments);
  const CommandRun done = run(std::string("compare sphere:8x4 ") + wrong.arguments);
  CHECK(done.status == wrong.status);
  CHECK(done.err.find(wrong.complaint) != std::string::npos);
  CHECK(std::count(done.err.begin(), done.err.end(), '\n') == 1);
  CHECK(done.out.empty());
  CHECK_FALSE(std::filesystem::exists("a.ppm"));
}
