// SPDX-License-Identifier: MIT
// `arcspan turntable` as a user runs it.
#include <arcspan_tools/image/image_file.hpp>
#include <catch2/catch.hpp>
#include <tests/tools/command_run.hpp>
#include <tests/tools/temporary_folder.hpp>

using namespace arcspan::tools;
using namespace arcspan::test;

TEST_CASE("turntable writes a GIF, an animated PNG and a folder") {
  const TemporaryFolder folder;
  const std::string turn = "turntable torus:16x8 --size 40x30 --frames 5 -o ";
  const CommandRun gif = run(turn + (folder / "a.gif") + " --fps 20");
  REQUIRE(gif.status == 0);
  CHECK(gif.err.empty());
  CHECK(gif.out.find("a.gif: 5 frames of 40x30, 50 ms each, drawn in ") != std::string::npos);
  CHECK(contents(folder / "a.gif").substr(0, 6) == "GIF89a");
  REQUIRE(run(turn + (folder / "a.png")).status == 0);
  REQUIRE(run(turn + (folder / "frames")).status == 0);
  CHECK(std::filesystem::exists(folder / "frames/frame-0004.png"));
  CHECK_FALSE(std::filesystem::exists(folder / "frames/frame-0005.png"));
  // The first picture of the animated PNG is what programs show that know no animation.
  CHECK(read_image(folder / "a.png") == read_image(folder / "frames/frame-0000.png"));
  REQUIRE(run(turn + (folder / "ppm/") + " --pictures ppm").status == 0);
  CHECK(read_image(folder / "ppm/frame-0003.ppm") == read_image(folder / "frames/frame-0003.png"));
  CHECK(folder.size() == 4);
}

TEST_CASE("turntable in a pipe") {
  const TemporaryFolder folder;
  const std::string turn = "turntable torus:16x8 --size 40x30 --frames 3 -o ";
  REQUIRE(run(turn + (folder / "a.gif")).status == 0);
  const CommandRun piped = run(turn + "gif:-");
  CHECK(piped.out == contents(folder / "a.gif"));
  CHECK(piped.err.find("gif:-: 3 frames") == 0);
  CHECK(run(turn + "-").out.substr(0, 4) == "\x89PNG");
}

TEST_CASE("turntable: what is wrong is said before anything is drawn") {
  const TemporaryFolder folder;
  const std::string turn = "turntable torus:16x8 -o " + (folder / "a.gif");
  CHECK(run(turn + " --frames 1").err == "arcspan: --frames: expected an integer 2...3600, not '1'\n");
  CHECK(run(turn + " --fps 0").err == "arcspan: --fps: expected a number 1...50, not '0'\n");
  CHECK(run("turntable torus:16x8 -o " + (folder / "a.avi")).status == 1);
  CHECK(run("turntable torus:16x8 -o " + (folder / "none/a")).err ==
        "arcspan: " + (folder / "none/a") + ": cannot write (there is no folder " + (folder / "none") +
            ")\n");
  CHECK(run("turntable none.obj -o " + (folder / "a/")).status == 1);
  CHECK(folder.size() == 0);
}
