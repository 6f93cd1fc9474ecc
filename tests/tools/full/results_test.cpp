// SPDX-License-Identifier: MIT
// Results of commands: what must not be overwritten, what remains after a failure or a signal, and what
// reaches a terminal.
#include <arcspan_tools/image/image_file.hpp>
#include <catch2/catch.hpp>
#include <fcntl.h>
#include <sys/wait.h>
#include <tests/tools/command_run.hpp>
#include <tests/tools/temporary_folder.hpp>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>

using namespace arcspan::tools;
using namespace arcspan::test;

namespace {

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

void check_refused(const std::string& arguments, const std::string& complaint) {
  CAPTURE(arguments);
  const CommandRun refused = run(arguments);
  CHECK(refused.status == 1);
  CHECK(refused.err == "arcspan: " + complaint + "\n");
  CHECK(refused.out.empty());
}

/// Starts `arcspan turntable` with pictures for a folder, waits until two of them are there, and ends it by a
/// signal. Returns its status.
int interrupted(const TemporaryFolder& folder, const std::string& target, int signal) {
  const pid_t command = ::fork();
  if (command == 0) {
    (void)std::signal(signal, SIG_DFL);
    ::execl(ARCSPAN_COMMAND, ARCSPAN_COMMAND, "turntable", "torus:8x8", "-o", target.c_str(), "--frames",
            "3600", nullptr);
    ::_exit(1);
  }
  std::size_t pictures = 0;
  for (int tries = 0; tries < 2000 && pictures < 2; ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    pictures = 0;
    // Files are renamed meanwhile, so that a step may fail; the next try counts again.
    std::error_code failed;
    for (std::filesystem::recursive_directory_iterator entry(folder / "", failed), end;
         !failed && entry != end; entry.increment(failed)) {
      if (entry->path().extension() == ".png") ++pictures;
    }
  }
  CHECK(pictures >= 2);
  ::kill(command, signal);
  int status = 0;
  ::waitpid(command, &status, 0);
  return status;
}

}  // namespace

TEST_CASE("no command writes two results into one file, or over its input") {
  const TemporaryFolder folder;
  const std::string obj = folder.file("in.obj", kTriangle);
  const std::string bin = folder / "in.bin";
  const std::string png = folder / "in.png";
  REQUIRE(run("mesh sphere:8x4 -o " + bin).status == 0);
  write_image(Image(2, 2), png);
  const std::string out = folder / "out.png";
  const std::string two = ": cannot hold two results";
  const std::string input = ": is an input, which the result would replace";
  const std::string before = contents(obj) + contents(bin) + contents(png);
  check_refused("render sphere:8x4 -o " + out + " --stats " + out, out + two);
  check_refused("render " + obj + " -o " + out + " --stats " + obj, obj + input);
  check_refused("mesh " + bin + " -o " + bin, bin + input);
  check_refused("mesh sphere:8x4 -o " + (folder / "a.hpp") + " --picture " + out + " --stats " + out,
                out + two);
  check_refused(
      "compare sphere:8x4 -o " + out + " --table " + (folder / "a.md") + " --table " + (folder / "a.md"),
      (folder / "a.md") + two);
  check_refused("bench --table " + (folder / "a.md") + " --table " + (folder / "./a.md"),
                (folder / "./a.md") + two);
  check_refused("diff " + png + " " + png + " -o " + png, png + input);
  CHECK(contents(obj) + contents(bin) + contents(png) == before);
  CHECK(folder.size() == 3);
}

TEST_CASE(
    "no command writes over a file that its input refers to, nor by a numbered picture over its input") {
  const TemporaryFolder folder;
  const std::string png = folder / "skin.png";
  write_image(Image(8, 8), png);
  const std::string mtl = folder.file("a.mtl", "newmtl m\nmap_Kd skin.png\n");
  const std::string obj = folder.file(
      "a.obj", "mtllib a.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
  const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  std::string buffer(sizeof corners, '\0');
  std::memcpy(buffer.data(), corners, sizeof corners);
  const std::string bin = folder.file("man.bin", buffer);
  const std::string gltf = folder.file(
      "man.gltf",
      R"({"asset":{"version":"2.0"},"buffers":[{"uri":"man.bin","byteLength":36}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,"componentType":5126,)"
      R"("count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],"meshes":[{"primitives":[{"attributes":)"
      R"({"POSITION":0}}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"scene":0})");
  const std::string input = ": is an input, which the result would replace";
  const std::string link = folder / "link.png";
  std::filesystem::create_symlink(png, link);
  const std::string frame = folder / "frame-0001.png";
  write_image(Image(8, 8), frame);
  const std::string before = contents(png) + contents(mtl) + contents(frame) + contents(bin);
  const std::size_t files = folder.size();
  check_refused("render " + obj + " -o " + png, png + input);
  check_refused("render " + obj + " -o " + link, link + input);
  check_refused("render " + obj + " -o " + (folder / "out.png") + " --stats " + mtl, mtl + input);
  check_refused("mesh " + obj + " -o " + (folder / "a.bin") + " --picture " + png, png + input);
  check_refused("mesh " + gltf + " -o " + bin, bin + input);
  check_refused("compare torus:8x4 --size 24x16 --shading flat --texture " + png + " -o " + png, png + input);
  for (const char* command : {"turntable torus:8x4 --size 24x16 --frames 2 --texture ",
                              "simulate torus:8x4 --turntable 2 --texture "}) {
    check_refused(command + frame + " -o " + (folder / ""), frame + input);
  }
  CHECK(contents(png) + contents(mtl) + contents(frame) + contents(bin) == before);
  CHECK(folder.size() == files);
}

TEST_CASE("if one of a command's results fails, the others are not written") {
  const TemporaryFolder folder;
  const std::string old = folder.file("old.png", "old");
  check_refused("render sphere:8x4 -o " + old + " --stats /dev/full",
                "/dev/full: cannot write (No space left on device)");
  check_refused("mesh sphere:8x4 -o " + (folder / "a.hpp") + " --picture " + old + " --stats /dev/full",
                "/dev/full: cannot write (No space left on device)");
  check_refused(
      "compare sphere:8x4 --no-instructions --shading flat -o " + old + " --table " + (folder / "no/a.md"),
      (folder / "no/a.md") + ": cannot write (there is no folder " + (folder / "no") + ")");
  CHECK(contents(old) == "old");
  CHECK(folder.size() == 1);
}

TEST_CASE("a command whose summary cannot be printed fails and leaves no result") {
  const TemporaryFolder folder;
  const std::string picture = folder.file("a.ppm", "P6 4 4 255 " + std::string(48, '\7'));
  const std::string small = " --size 16x16 -o " + (folder / "out");
  for (const std::string& command :
       {"render sphere:8x4" + small + ".png", "mesh sphere:8x4 -o " + (folder / "out.hpp"),
        "texture " + picture + " -o " + (folder / "out.bin"),
        "turntable sphere:8x4 --frames 2" + small + ".gif", "turntable sphere:8x4 --frames 2" + small + "/",
        "simulate sphere:8x4 -o " + (folder / "out.png"),
        "simulate sphere:8x4 --turntable 2 -o " + (folder / "out.gif"),
        "compare sphere:8x4 --no-instructions --shading flat" + small + ".png",
        "bench --sphere 8x4:4 --rounds 1 --method flat --threads 1 --table " + (folder / "out.md"),
        "diff " + picture + " " + picture + " -o " + (folder / "out.png")}) {
    for (const char* closed : {">/dev/full", ">&-"}) {
      CAPTURE(command, closed);
      const int ended = std::system(
          (std::string(ARCSPAN_COMMAND) + " " + command + " " + closed + " 2>" + (folder / "err")).c_str());
      CHECK(WEXITSTATUS(ended) == 1);
      CHECK(contents(folder / "err").find("arcspan: standard output: cannot write (") != std::string::npos);
      CHECK(folder.size() == 2);
    }
  }
}

TEST_CASE("no message is longer than 300 characters or shows a type of C++") {
  const TemporaryFolder folder;
  const std::string name(5000, 'n');
  std::string wide;
  for (int i = 0; i < 900; ++i) wide += "\u00E4";
  const std::string obj = folder.file("a.obj", "usemtl a\nf 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n");
  const std::string dae = folder.file("a.dae", "<COLLADA version=\"1.4.1\"><" + std::string(9000, 'x') + ">");
  const std::string gltf = folder.file("a.gltf", "{\"asset\": {\"version\": \"2.0\"}, \"" + name + "\": \"");
  for (const std::string& arguments :
       {name, "render " + name, "render x.obj -o a.png --size " + name,
        "render sphere:8x4 -o a.png --" + name, "render " + wide + ".obj -o a.png",
        "render " + obj + " -o a.png --group " + name, "render " + dae + " -o a.png",
        "render " + gltf + " -o a.png", "mesh sphere:8x4 -o a.hpp --name 9" + name, "plot " + wide}) {
    const CommandRun done = run(arguments);
    CAPTURE(arguments.substr(0, 80), done.err);
    CHECK(done.status != 0);
    CHECK(done.err.size() <= 301);
    CHECK(done.err.find('\n') == done.err.size() - 1);
    CHECK(done.err.find("std::") == std::string::npos);
    CHECK(done.err.find("\\x") == std::string::npos);  // a character cut in two
  }
}

TEST_CASE("a picture for a folder that cannot be moved there leaves the older ones as they were") {
  const TemporaryFolder folder;
  const std::string turn = "turntable torus:8x8 --size 16x16 --frames 3 -o " + (folder / "frames");
  std::filesystem::create_directories(folder / "frames/frame-0002.png");
  (void)folder.file("frames/frame-0000.png", "old");
  check_refused(turn, (folder / "frames/frame-0002.png") + ": cannot write (it is a directory)");
  CHECK(contents(folder / "frames/frame-0000.png") == "old");
  CHECK_FALSE(std::filesystem::exists(folder / "frames/frame-0001.png"));
}

TEST_CASE("a file size limit is a message that names the result, not a temporary") {
  const TemporaryFolder folder;
  const CommandRun picture = run("render sphere:8x4 -o " + (folder / "a.ppm"), "ulimit -f 8; ");
  CHECK(picture.err == "arcspan: " + (folder / "a.ppm") + ": cannot write (File too large)\n");
  const CommandRun frames = run("turntable sphere:8x4 --pictures ppm -o " + (folder / "a/"), "ulimit -f 8; ");
  CHECK(frames.err == "arcspan: " + (folder / "a/frame-0000.ppm") + ": cannot write (File too large)\n");
  CHECK(folder.size() == 0);
}

TEST_CASE("a command that a signal ends leaves no temporaries and dies from that signal") {
  const int signal = GENERATE(SIGINT, SIGTERM, SIGHUP);
  const bool exists = GENERATE(false, true);
  CAPTURE(signal, exists);
  const TemporaryFolder folder;
  if (exists) std::filesystem::create_directory(folder / "frames");
  const int status = interrupted(folder, folder / "frames/", signal);
  CHECK(WIFSIGNALED(status));
  CHECK(WTERMSIG(status) == signal);
  CHECK(folder.size() == (exists ? 1u : 0u));
  if (exists) CHECK(std::filesystem::is_empty(folder / "frames"));
}

TEST_CASE("a reader that goes away leaves no temporaries") {
  const TemporaryFolder folder;
  const std::string line = "bash -c '" ARCSPAN_COMMAND " render torus:8x8 --size 400x400 -o ppm:- --stats " +
                           (folder / "a.json") +
                           " 2>/dev/null | head -c 9 >/dev/null; exit ${PIPESTATUS[0]}'";
  const int ended = std::system(line.c_str());
  CHECK(WEXITSTATUS(ended) == 128 + SIGPIPE);
  CHECK(folder.size() == 0);
}

TEST_CASE("a result never goes into a closed standard stream") {
  const TemporaryFolder folder;
  const std::string line = std::string(ARCSPAN_COMMAND) + " render sphere:8x4 -o " + (folder / "a.png") +
                           " --stats - >&- 2>" + (folder / "err");
  CHECK(WEXITSTATUS(std::system(line.c_str())) == 1);
  CHECK(contents(folder / "err") == "arcspan: standard output: cannot write (Bad file descriptor)\n");
  CHECK(folder.size() == 1);
}

TEST_CASE("names and arguments reach the terminal without line breaks and escape sequences") {
  const TemporaryFolder folder;
  const std::string bytes = "a\n\x1B[31m";
  const std::string shown = R"(a\n\x1b[31m)";
  check_refused("render '" + (folder / bytes) + ".obj' -o a.png",
                (folder / shown) + ".obj: cannot read (no such file)");
  CHECK(run("render sphere:8x4 -o a.png --size '" + bytes + "'").err ==
        "arcspan: --size: expected WxH with each 1...2048, not '" + shown + "'\n");
  CHECK(run("'" + bytes + "'").err == "arcspan: no such subcommand: '" + shown + "' (see arcspan --help)\n");
  const CommandRun drawn = run("render sphere:8x4 -o '" + (folder / bytes) + ".png'");
  CHECK(drawn.status == 0);
  CHECK(drawn.out.find((folder / shown) + ".png: 320x240") != std::string::npos);
}

TEST_CASE("content of a mesh that is not drawn gets a warning line, whichever command loads it") {
  const TemporaryFolder folder;
  const std::string obj = folder.file("a.obj", "usemtl red\n" + std::string(kTriangle));
  const std::string warning = "arcspan: warning: " + obj +
                              ": materials that are not defined (1) are drawn in the default look: 'red'\n";
  for (const char* command :
       {"render", "mesh", "turntable --frames 2", "simulate", "compare --no-instructions --shading flat"}) {
    CAPTURE(command);
    const std::string out = folder / (std::string(command) == "mesh" ? "a.bin" : "a.png");
    const CommandRun done = run(std::string(command) + " " + obj + " -o " + out);
    CHECK(done.status == 0);
    CHECK(done.err == warning);
  }
}

TEST_CASE("a folder for temporary files that does not exist is named") {
  const CommandRun done = run("plot diffuse-error -o /tmp/never.svg", "TMPDIR=/nowhere ");
  CHECK(done.status == 1);
  CHECK(done.err == "arcspan: TMPDIR: /nowhere is no folder for temporary files\n");
}
