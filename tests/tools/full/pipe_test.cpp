// SPDX-License-Identifier: MIT
// Commands in pipes, their help, and completion as a shell sees it.
#include <arcspan_tools/image/image.hpp>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <tests/tools/command_run.hpp>
#include <tests/tools/temporary_folder.hpp>

using namespace arcspan::tools;
using namespace arcspan::test;

namespace {

/// Bash's completions of `words`, of which the last is being typed.
std::string completed(const TemporaryFolder& folder, const std::string& words) {
  const std::string script =
      "source <(" ARCSPAN_COMMAND " completion bash)\nCOMP_WORDS=(" + words +
      ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_arcspan\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n";
  const std::string file = folder.file("complete.sh", script);
  if (std::system(("bash " + file + " >" + (folder / "offers")).c_str()) != 0) return "(failed)";
  return contents(folder / "offers");
}

}  // namespace

TEST_CASE("render on standard output: the picture alone; the report goes to standard error") {
  const TemporaryFolder folder;
  REQUIRE(run("render torus:16x8 --size 40x30 -o " + (folder / "a.png")).status == 0);
  const CommandRun png = run("render torus:16x8 --size 40x30 -o -");
  CHECK(png.out == contents(folder / "a.png"));
  CHECK(png.err.find("drawn: ") != std::string::npos);
  CHECK(run("render torus:16x8 --size 40x30 -o ppm:-").out.substr(0, 3) == "P6\n");
  CHECK(run("render torus:16x8 --size 40x30 -o jpg:-").err ==
        "arcspan: jpg:-: a picture's name must end in .png, .ppm or .pgm\n");
}

TEST_CASE("one result can go to standard output, whichever it is") {
  const TemporaryFolder folder;
  const CommandRun figures = run("render torus:16x8 --size 40x30 --stats - -o " + (folder / "a.png"));
  CHECK(figures.status == 0);
  CHECK(nlohmann::json::parse(figures.out)["mesh"]["triangles"] == 256);
  CHECK(figures.err.find("drawn: ") != std::string::npos);
  const CommandRun both = run("mesh torus:16x8 --picture - -o -");
  CHECK(both.status == 1);
  CHECK(both.out.empty());
  CHECK(both.err == "arcspan: standard output: only one result can go there\n");
}

TEST_CASE("a report that goes nowhere is a failure") {
  const TemporaryFolder folder;
  for (const char* arguments : {"--help", "completion bash", "render torus:8x8 -o -"}) {
    CAPTURE(arguments);
    const int ended = std::system(
        (std::string(ARCSPAN_COMMAND) + " " + arguments + " >/dev/full 2>" + (folder / "err")).c_str());
    CHECK(WEXITSTATUS(ended) == 1);
    CHECK(contents(folder / "err").find("arcspan: standard output: cannot write") == 0);
  }
}

TEST_CASE("every command's help has an example") {
  const std::string help = run("--help").out;
  std::size_t commands = 0;
  for (std::size_t at = help.find("Subcommands:\n") + 13; help[at] == ' '; at = help.find('\n', at) + 1) {
    const std::string name = help.substr(at + 2, help.find(' ', at + 2) - at - 2);
    CAPTURE(name);
    const CommandRun shown = run(name + " --help");
    CHECK(shown.status == 0);
    CHECK(shown.out.find("Examples:\n  ") != std::string::npos);
    ++commands;
  }
  CHECK(commands >= 5);
}

TEST_CASE("bash completes commands, options, values and files") {
  const TemporaryFolder folder;
  CHECK(completed(folder, "arcspan tu") == "turntable\n");
  CHECK(completed(folder, "arcspan mesh --max-t") == "--max-triangles\n");
  CHECK(completed(folder, "arcspan render x.obj --shading gou") == "gouraud\n");
  CHECK(completed(folder, "arcspan render x.obj --no-d").find("--no-dither\n--no-depth\n") == 0);
  CHECK(completed(folder, "arcspan completion fi") == "fish\n");
  CHECK(completed(folder, "arcspan render x.obj --segment ''") == "adaptive\n");
  CHECK(completed(folder, "arcspan render x.obj --ambient " + folder.file("of-files", "")) ==
        (folder / "of-files") + "\n");
  CHECK(completed(folder, "arcspan compare --draw") == "\n");
  CHECK(completed(folder, "arcspan diff " + folder.file("only-one.png", "")) ==
        (folder / "only-one.png") + "\n");
  const std::string spaced = folder.file("with a space.png", "");
  for (const char* before : {"arcspan diff '", "arcspan render -o '"})
    CHECK(completed(folder, before + (folder / "with a") + "'") == spaced + "\n");
}
