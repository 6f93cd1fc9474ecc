// SPDX-License-Identifier: MIT
// `arcspan plot` as a user runs it.
#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/plot/figure.hpp>
#include <catch2/catch.hpp>
#include <tests/tools/command_run.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <filesystem>

using namespace arcspan::tools;
using namespace arcspan::test;

TEST_CASE("plot writes a figure's numbers without gnuplot") {
  const TemporaryFolder folder;
  const CommandRun done = run("plot specular-error -o " + (folder / "a.csv"));
  CHECK(done.err.empty());
  REQUIRE(done.status == 0);
  const std::string csv = contents(folder / "a.csv");
  CHECK(csv.rfind("curve,x,y\n\"n = 4\",", 0) == 0);
  CHECK(csv.find("\n\"n = 100\",4,5.91") != std::string::npos);
}

TEST_CASE("plot draws every figure as SVG, and the first as PNG, where gnuplot is installed") {
  if (std::system("gnuplot --version >/dev/null 2>&1") != 0) {
    WARN("gnuplot is not installed");
    return;
  }
  const auto makers = figure_makers();
  const TemporaryFolder folder;
  for (const FigureMaker& maker : makers) {
    CAPTURE(std::string(maker.name));
    const std::string start = "plot " + std::string(maker.name) + " -o ";
    const CommandRun svg = run(start + (folder / "a.svg"));
    CHECK(svg.err.empty());
    REQUIRE(svg.status == 0);
    const std::string text = contents(folder / "a.svg");
    CHECK(text.find("<svg") != std::string::npos);
    CHECK(text.find("</svg>") != std::string::npos);
    // Some figures take seconds to calculate: the labels of all of them are checked by artefact_tests.
    if (&maker != makers.data()) continue;
    CHECK(text.find(maker.make().x_label) != std::string::npos);
    REQUIRE(run(start + (folder / "a.png")).status == 0);
    CHECK(read_image(folder / "a.png").width == 1120);
  }
}

TEST_CASE("plot draws the same figure whatever settings the user has for gnuplot") {
  if (std::system("gnuplot --version >/dev/null 2>&1") != 0) return;
  const TemporaryFolder folder;
  (void)folder.file(".gnuplot", "set size 0.5,0.5\n");
  const std::string plot = "plot diffuse-error -o " + (folder / "a.svg");
  REQUIRE(run(plot).status == 0);
  const std::string usual = contents(folder / "a.svg");
  REQUIRE(run(plot, "HOME=" + (folder / ". ")).status == 0);
  CHECK(contents(folder / "a.svg") == usual);
}

TEST_CASE("plot: what is wrong is said in one line, and nothing is written") {
  struct Case {
    const char* before;
    const char* arguments;
    const char* complaint;
    int status;
  };
  const Case wrong = GENERATE(values<Case>({
      {"", "spiral -o a.svg", "FIGURE: expected diffuse-error|absolute-error|", 2},
      {"", "rotation -o a.pdf", "a.pdf: a figure's name must end in .svg, .png or .csv", 1},
      {"", "rotation", "--output is required", 2},
      {"PATH=/nowhere ", "diffuse-error -o a.svg", "gnuplot: not found", 1},
      {"", "diffuse-error -o /nowhere/a.csv", "/nowhere/a.csv: cannot write", 1},
  }));
  CAPTURE(wrong.arguments);
  const CommandRun done = run(std::string("plot ") + wrong.arguments, wrong.before);
  CHECK(done.status == wrong.status);
  CHECK(done.err.find(wrong.complaint) != std::string::npos);
  CHECK(std::count(done.err.begin(), done.err.end(), '\n') == 1);
  CHECK_FALSE(std::filesystem::exists("a.svg"));
}
