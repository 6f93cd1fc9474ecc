// SPDX-License-Identifier: MIT
// The built program as a user runs it: arguments, exit status, what it prints, what it leaves behind.
#include <arcspan_tools/image/image_file.hpp>
#include <catch2/catch.hpp>
#include <tests/tools/command_run.hpp>
#include <tests/tools/temporary_folder.hpp>

using namespace arcspan::tools;
using namespace arcspan::test;

TEST_CASE("help and version end well, nothing to do does not") {
  CHECK(run("--help").status == 0);
  CHECK(run("--version").out == "0.1.0\n");
  CHECK(run("").status == 2);
  CHECK(run("").err == "arcspan: no subcommand given (see arcspan --help)\n");
  CHECK(run("polish x").status == 2);
  CHECK(run("polish x").err == "arcspan: no such subcommand: 'polish' (see arcspan --help)\n");
}

TEST_CASE("the help names defaults and ranges: of show the display's size and format") {
  const std::string help = run("show --help").out;
  CHECK(help.find("picture size, each 1...2048 (default: the display's)\n") != std::string::npos);
  CHECK(help.find("pixel format (default: the display's own)\n") != std::string::npos);
  CHECK(run("render --help").out.find("(default 320x240)\n") != std::string::npos);
  CHECK(run("render --help").out.find("N*N samples a pixel, N 1...8 (default 1)") != std::string::npos);
  CHECK(run("font --help").out.find("as small (1/N), N 1...8 [1]") != std::string::npos);
}

TEST_CASE("an argument that a subcommand does not take is named, whatever else is wrong") {
  CHECK(run("diff a b c").err == "arcspan: c: one argument too many for arcspan diff\n");
  CHECK(run("render sphere:8x4 --shadding arc").err ==
        "arcspan: --shadding: no such option of arcspan render; did you mean --shading?\n");
  CHECK(run("render sphere:8x4 --colors=1,1,1").err ==
        "arcspan: --colors: no such option of arcspan render; did you mean --colour?\n");
  CHECK(run("render -x").err ==
        "arcspan: -x: no such option of arcspan render (see arcspan render --help)\n");
  CHECK(run("--versions").err == "arcspan: --versions: no such option of arcspan; did you mean --version?\n");
  CHECK(run("rendr sphere:8x4").err == "arcspan: no such subcommand: 'rendr'; did you mean 'render'?\n");
  CHECK(run("render --shadding arc").status == 2);
}

TEST_CASE("diff writes a picture and prints the largest and the mean difference") {
  const TemporaryFolder folder;
  Image a(4, 2);
  write_image(a, folder / "a.ppm");
  a.at(1, 1).g = 12;
  write_image(a, folder / "b.png");
  const std::string files = (folder / "a.ppm") + " " + (folder / "b.png");
  const CommandRun compared = run("diff " + files + " -o " + (folder / "d.png"));
  CHECK(compared.status == 0);
  CHECK(compared.out == "largest difference 12, mean 0.5000, 1 of 8 pixels differ\n");
  CHECK(read_image(folder / "d.png").at(1, 1) == arcspan::Rgb8{0, 255, 0});
  CHECK(run("diff " + files + " --limit 12").status == 0);
  CHECK(run("diff " + files + " --limit 11").status == 1);
  CHECK(run("diff " + files + " --limit 256").status == 2);
}

TEST_CASE("diff says what is wrong with its pictures") {
  const TemporaryFolder folder;
  write_image(Image(4, 2), folder / "a.ppm");
  write_image(Image(2, 4), folder / "b.ppm");
  const std::string a = folder / "a.ppm";
  const std::string b = folder / "b.ppm";
  CHECK(run("diff " + a + " " + b).err == "arcspan: " + b + ": is 2x4, but " + a + " is 4x2\n");
  CHECK(run("diff " + a + " " + a + " -o " + (folder / "d.gif")).err ==
        "arcspan: " + (folder / "d.gif") + ": a picture's name must end in .png, .ppm or .pgm\n");
  CHECK(run("diff " + a + " " + (folder / "none.png")).err ==
        "arcspan: " + (folder / "none.png") + ": cannot read (no such file)\n");
  CHECK(folder.size() == 2);
}
