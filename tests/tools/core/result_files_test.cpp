// SPDX-License-Identifier: MIT
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/result_files.hpp>
#include <catch2/catch.hpp>
#include <sys/stat.h>
#include <tests/tools/temporary_folder.hpp>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <thread>

using namespace arcspan::tools;
using namespace arcspan::test;

namespace {

std::string refusal(const std::vector<std::filesystem::path>& results,
                    const std::vector<std::filesystem::path>& inputs = {}) {
  return message_of<Failure>([&] { check_results(results, inputs); });
}

const std::string kNothing = "(nothing was thrown)";

}  // namespace

TEST_CASE("two results in one file are refused, however the file is named") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "sub");
  std::filesystem::create_symlink("new.png", folder / "link");
  const std::string complaint = ": cannot hold two results";
  CHECK(refusal({folder / "a", folder / "a"}) == (folder / "a") + complaint);
  CHECK(refusal({folder / "a", folder / "./a"}) == (folder / "./a") + complaint);
  CHECK(refusal({folder / "a", folder / "sub/../a"}) == (folder / "sub/../a") + complaint);
  CHECK(refusal({folder / "new.png", folder / "link"}) == (folder / "link") + complaint);
  CHECK(refusal({"-", "ppm:-"}) == "standard output: only one result can go there");
  CHECK(refusal({folder / "a", folder / "b", "", ""}) == kNothing);
  CHECK(refusal({"/dev/null", "/dev/null"}) == kNothing);
}

TEST_CASE("a result that would replace an input is refused") {
  const TemporaryFolder folder;
  const std::string in = folder.file("in.obj", "v");
  std::filesystem::create_symlink(in, folder / "symbolic");
  std::filesystem::create_hard_link(in, folder / "hard");
  const std::string complaint = ": is an input, which the result would replace";
  CHECK(refusal({in}, {in}) == in + complaint);
  CHECK(refusal({in}, {folder / "symbolic"}) == in + complaint);
  CHECK(refusal({folder / "symbolic"}, {in}) == (folder / "symbolic") + complaint);
  CHECK(refusal({folder / "hard"}, {in}) == (folder / "hard") + complaint);
  CHECK(refusal({folder / "out"}, {in, "sphere:8x4"}) == kNothing);
}

TEST_CASE("a result in a folder that does not exist is refused before any work") {
  const TemporaryFolder folder;
  CHECK(refusal({folder / "none/a"}) ==
        (folder / "none/a") + ": cannot write (there is no folder " + (folder / "none") + ")");
}

TEST_CASE("if one of several results cannot be written, none is") {
  const TemporaryFolder folder;
  const std::string old = folder.file("old", "old");
  for (const std::string& last : {std::string("/dev/full"), folder / "none/b", folder / "."}) {
    CAPTURE(last);
    const std::string complaint = message_of<Failure>([&] {
      write_results({{old, "new"}, {folder / "new", "new"}, {last, "x"}});
    });
    CHECK(complaint.find(last + ": cannot write (") == 0);
    CHECK(contents(old) == "old");
    CHECK(folder.size() == 1);
  }
}

// The temporary of the last target is removed when all results are complete, so that renaming it fails after
// the others were renamed. The pipe holds the writer until then.
TEST_CASE("results that are in place already are taken back if a later one fails") {
  const TemporaryFolder folder;
  const std::string old = folder.file("old", "old");
  const std::string pipe = folder / "pipe";
  const std::filesystem::path late = folder / "late";
  std::filesystem::create_directory(late);
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  std::thread reader([&] {
    while (std::filesystem::is_empty(late)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    for (const auto& temporary : std::filesystem::directory_iterator(late))
      std::filesystem::remove(temporary);
    (void)contents(pipe);
  });
  const std::string complaint = message_of<Failure>([&] {
    write_results({{old, "new"}, {folder / "fresh", "new"}, {late / "new", "new"}, {pipe, "x"}});
  });
  reader.join();
  CHECK(complaint == (late / "new").string() + ": cannot write (No such file or directory)");
  CHECK(contents(old) == "old");
  CHECK(folder.size() == 3);  // old, the pipe, the other folder
}

TEST_CASE("several results replace old files, which keep their permissions") {
  const TemporaryFolder folder;
  const std::string a = folder.file("a", "old");
  const std::string b = folder.file("b", "old");
  REQUIRE(::chmod(a.c_str(), 0600) == 0);
  write_results({{a, "1"}, {b, "2"}, {folder / "c", "3"}});
  CHECK(contents(a) + contents(b) + contents(folder / "c") == "123");
  struct stat status {};
  REQUIRE(::stat(a.c_str(), &status) == 0);
  CHECK((status.st_mode & 0777u) == 0600u);
  CHECK(folder.size() == 3);
}

TEST_CASE("a write-protected file is not replaced") {
  if (::geteuid() == 0) return;  // who may write everything
  const TemporaryFolder folder;
  const std::string a = folder.file("a", "old");
  REQUIRE(::chmod(a.c_str(), 0400) == 0);
  CHECK(message_of<Failure>([&] {
          write_results({{a, "new"}});
        }) == a + ": cannot write (Permission denied)");
  CHECK(contents(a) == "old");
}

TEST_CASE("a symbolic link to a file that does not exist yet stays one") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "sub");
  std::filesystem::create_symlink("sub/second", folder / "first");
  std::filesystem::create_symlink("../made", folder / "sub/second");
  write_results({{folder / "first", "x"}});
  CHECK(std::filesystem::is_symlink(folder / "first"));
  CHECK(contents(folder / "made") == "x");
  std::filesystem::create_symlink("circle", folder / "circle");
  CHECK(message_of<Failure>([&] {
          write_results({{folder / "circle", "x"}});
        }) == (folder / "circle") + ": cannot write (the symbolic link leads in a circle)");
}

TEST_CASE("names as long as the file system allows are written") {
  const TemporaryFolder folder;
  const std::string longest(255, 'n');
  write_results({{folder / longest, "x"}, {folder / std::string(248, 'm'), "y"}});
  CHECK(contents(folder / longest) == "x");
  CHECK(message_of<Failure>([&] {
          write_results({{folder / (longest + "n"), "x"}});
        }).find("File name too long") != std::string::npos);
  CHECK(folder.size() == 2);
}
