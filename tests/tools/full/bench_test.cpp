// SPDX-License-Identifier: MIT
// `arcspan bench`: that it measures what it says, and its report; not how long anything takes.
#include <arcspan_tools/bench/float_phong.hpp>
#include <arcspan_tools/bench/measure.hpp>
#include <arcspan_tools/bench/parallel_bands.hpp>
#include <arcspan_tools/bench/report.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <tests/tools/command_run.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

using namespace arcspan;
using namespace arcspan::tools;
using namespace arcspan::test;

namespace {

struct Built {
  BenchScene bench;
  FixedMesh mesh;
  RenderJob job;

  explicit Built(const BenchSphere& sphere)
      : bench(make_bench_scene(sphere)), mesh(to_fixed(bench.mesh)), job(make_job(bench.scene, mesh, "m")) {}
  Built(const Built&) = delete;
};

Image drawn(const RenderJob& job, const char* shading) {
  return find_renderer(shading, "rgb565", false).render(job, [](std::size_t) {}).image;
}

struct SceneDifference {
  std::size_t covered_by_one = 0;  ///< pixels
  int largest = 0;                 ///< of a channel where both cover
  double mean = 0;
};

SceneDifference scene_difference(const Image& a, const Image& b) {
  SceneDifference d;
  std::size_t both = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const Rgb8 p = a.pixels[i];
    const Rgb8 q = b.pixels[i];
    const bool in_a = !(p == Rgb8{});
    const bool in_b = !(q == Rgb8{});
    if (in_a != in_b) ++d.covered_by_one;
    if (!in_a || !in_b) continue;
    ++both;
    const int worst = std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
    d.largest = std::max(d.largest, worst);
    d.mean += worst;
  }
  if (both != 0) d.mean /= static_cast<double>(both);
  return d;
}

BenchReport tiny_report() {
  BenchReport report;
  report.rounds = 3;
  report.scenes.push_back({{8, 4, 50}, {320, 240}, 10, 200, 4000, {{"arc", 4, 1}, {"phong", 25, 6.25}}});
  report.scenes.push_back({{32, 16, 20}, {320, 240}, 100, 300, 600, {{"arc", 20, 1}, {"phong", 30, 1.5}}});
  report.threads.push_back({{8, 4, 50}, {320, 240}, 2, 0.25, 1.75, 0.2, 1.9});
  return report;
}

}  // namespace

TEST_CASE("the float loop draws the same scene: same outline, nearly the same colours") {
  const Built built({32, 16, 72});
  FloatPhong phong(built.bench);
  phong.draw();
  const Image floating = phong.image();
  const SceneDifference d = scene_difference(floating, drawn(built.job, "arc"));
  CHECK(d.covered_by_one < 40);  // of 16,156, where the outline is not snapped to sixteenths
  CHECK(d.largest <= 17);        // two steps of five bits
  CHECK(d.mean < 1);
  // Depth holds it: drawing once more changes nothing, drawing after clearing gives the same.
  phong.draw();
  CHECK(phong.image() == floating);
  phong.clear();
  CHECK(phong.image() == Image(320, 240));
  phong.draw();
  CHECK(phong.image() == floating);
}

TEST_CASE("a repeated frame is the same frame, and so are its figures") {
  Built built({16, 8, 40});
  const Renderer& arc = find_renderer("arc", "rgb565", false);
  const RenderResult once = arc.render(built.job, [](std::size_t) {});
  built.job.repeats = 4;
  built.job.band_rows = 100;
  const RenderResult often = arc.render(built.job, [](std::size_t) {});
  CHECK(often.image == once.image);
  CHECK(often.stats.pixels == once.stats.pixels);
  CHECK(often.stats.triangles == once.stats.triangles);
  built.job.counts = false;
  const RenderResult uncounted = arc.render(built.job, [](std::size_t) {});
  CHECK(uncounted.image == once.image);
  // Without counting, `triangles` is that of the fullest of the three bands.
  CHECK(uncounted.stats.triangles < once.stats.triangles);
  CHECK(3 * uncounted.stats.triangles >= once.stats.triangles);
  CHECK(uncounted.stats.spans == 0);
  CHECK(uncounted.stats.pixels == 0);
}

TEST_CASE("bands drawn in parallel are the picture drawn at once") {
  const BenchSphere sphere =
      GENERATE(BenchSphere{32, 16, 72}, BenchSphere{12, 6, 110}, BenchSphere{64, 32, 36});
  const Built built(sphere);
  const Image whole = drawn(built.job, "arc");
  CHECK(whole != Image(320, 240));
  const std::vector<std::uint32_t> counts{1, 2, 3, 7, 64};
  for (const std::uint32_t threads : counts) {
    CAPTURE(threads);
    ParallelBands bands(built.job, threads);
    const ParallelBands::FrameTime time = bands.draw(3);
    CHECK(bands.image() == whole);
    CHECK(time.wall > 0);
    CHECK(time.wall < 1e4);
    CHECK(time.busiest > 0);
    bands.balance(1);
    static_cast<void>(bands.draw(1));
    CHECK(bands.image() == whole);
  }
}

TEST_CASE("bands in parallel refuse what they do not draw") {
  Built built({8, 4, 20});
  built.job.highlight = Highlight::kBlinn;
  CHECK_THROWS_AS(ParallelBands(built.job, 2), Failure);
  built.job.highlight = Highlight::kPhong;
  built.job.lights.push_back(built.job.lights[0]);
  CHECK_THROWS_AS(ParallelBands(built.job, 2), Failure);
}

TEST_CASE("names of spheres") {
  CHECK(parse_bench_sphere("32x16:72") == BenchSphere{32, 16, 72});
  CHECK(parse_bench_sphere("3x2:1") == BenchSphere{3, 2, 1});
  for (const BenchSphere& sphere : default_bench_spheres()) {
    CHECK(parse_bench_sphere(to_string(sphere)) == sphere);
    CHECK_NOTHROW(Built(sphere));
  }
  CHECK_NOTHROW(Built({16, 8, kLargestBenchRadius}));
  for (const char* wrong : {"", "32x16", "32:16x72", "2x16:72", "32x1:72", "32x16:0", "32x16:709", "257x16:9",
                            "32x16:7a", " 32x16:7", "x:", "99999999999999999999x2:1"}) {
    CAPTURE(wrong);
    CHECK_FALSE(parse_bench_sphere(wrong));
  }
}

TEST_CASE("the median is what is in the middle") {
  CHECK(median({}) == 0);
  CHECK(median({3}) == 3);
  CHECK(median({9, 1, 4}) == 4);
  CHECK(median({9, 1, 4, 6}) == 5);
}

TEST_CASE("the report has every figure, scenes by the size of triangles") {
  const std::string text = bench_markdown(tiny_report());
  const std::size_t small = text.find("| 32x16:20 in 320x240 | 100 | 6.0 | 2.0 | 20.00 | 30.00 |");
  const std::size_t large = text.find("| 8x4:50 in 320x240 | 10 | 400.0 | 20.0 | 4.00 | 25.00 |");
  REQUIRE(small != std::string::npos);
  REQUIRE(large != std::string::npos);
  CHECK(small < large);
  CHECK(text.find("| 8x4:50 in 320x240 | 10 | 400.0 | 20.0 | 250.0 | 40.0 |") != std::string::npos);
  CHECK(text.find("| 8x4:50 in 320x240 | 10 | 400.0 | 20.0 | 1.00 | 6.25 |") != std::string::npos);
  CHECK(text.find("| 8x4:50 in 320x240 | 2 | 0.250 | 4000 | 1.75 | 0.200 | 1.90 |") != std::string::npos);
  const auto json = nlohmann::json::parse(bench_json(tiny_report()));
  CHECK(json["rounds"] == 3);
  CHECK(json["scenes"][0]["sphere"] == "8x4:50");
  CHECK(json["scenes"][0]["pixels"] == 4000);
  CHECK(json["scenes"][0]["methods"][1]["method"] == "phong");
  CHECK(json["scenes"][0]["methods"][1]["time_per_arc"] == 6.25);
  CHECK(json["scenes"][0]["methods"][1]["megapixels_per_second"] == 40);
  CHECK(json["threads"][0]["speed_up"] == 1.75);
}

TEST_CASE("bench prints its report and writes the same into tables") {
  const TemporaryFolder folder;
  const CommandRun done = run("bench --sphere 8x4:30 --sphere 16x8:20 --rounds 2 --threads 2 --table " +
                              (folder / "a.md") + " --table " + (folder / "a.json"));
  CHECK(done.err.empty());
  REQUIRE(done.status == 0);
  CHECK(contents(folder / "a.md") == done.out);
  const auto json = nlohmann::json::parse(contents(folder / "a.json"));
  REQUIRE(json["scenes"].size() == 2);
  for (const auto& scene : json["scenes"]) {
    std::vector<std::string> names;
    for (const auto& method : scene["methods"]) {
      names.push_back(method["method"]);
      CHECK(method["nanoseconds_per_pixel"].get<double>() > 0);
      CHECK(method["time_per_arc"].get<double>() > 0);
    }
    CHECK(names == std::vector<std::string>{"flat", "gouraud", "arc", "phong", "float-phong"});
  }
  CHECK(json["threads"].size() == 4);
}

TEST_CASE("bench: one table to standard output, and arc is there even if it is not asked for") {
  const CommandRun done = run("bench --sphere 8x4:30 --rounds 1 --threads 1 --method phong --table json:-");
  REQUIRE(done.status == 0);
  const auto json = nlohmann::json::parse(done.out);
  CHECK(json["scenes"][0]["methods"].size() == 2);
  CHECK(json["scenes"][0]["methods"][1]["method"] == "arc");
  CHECK(json["scenes"][0]["methods"][1]["time_per_arc"] == 1);
  CHECK(json["threads"].empty());
}

TEST_CASE("bench: wrong arguments are named in one line and nothing is written") {
  struct Case {
    const char* arguments;
    const char* complaint;
    int status;
  };
  const Case wrong = GENERATE(values<Case>({
      {"--sphere 32x16", "expected AROUNDxALONG:RADIUS (3-256, 2-128, 1-708), not '32x16'", 2},
      {"--method arc,ray", "with commas, not 'ray'", 2},
      {"--method ,", "not ''", 2},
      {"--rounds 0", "--rounds", 2},
      {"--threads 65", "--threads", 2},
      {"--table a.txt", "a.txt: a report's name must end in .md or .json", 1},
      {"--table md:- --table json:-", "standard output: only one result can go there", 1},
  }));
  CAPTURE(wrong.arguments);
  const CommandRun done = run(std::string("bench ") + wrong.arguments);
  CHECK(done.status == wrong.status);
  CHECK(done.err.find(wrong.complaint) != std::string::npos);
  CHECK(std::count(done.err.begin(), done.err.end(), '\n') == 1);
  CHECK(done.out.empty());
}
