// SPDX-License-Identifier: MIT
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>
#include <catch2/catch.hpp>
#include <sys/stat.h>
#include <tests/tools/temporary_folder.hpp>

using namespace arcspan::tools;
using namespace arcspan::test;

TEST_CASE("a written file is whole, replaces the old one and leaves nothing beside it") {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.bin", "an old file that is longer");
  write_whole_file(path, std::string("new\0bytes", 9));
  CHECK(contents(path) == std::string("new\0bytes", 9));
  CHECK(folder.size() == 1);
}

TEST_CASE("a new file has the mode that the user's mask asks for") {
  const TemporaryFolder folder;
  const mode_t before = ::umask(027);
  write_whole_file(folder / "a", "x");
  ::umask(before);
  struct stat status {};
  REQUIRE(::stat((folder / "a").c_str(), &status) == 0);
  CHECK((status.st_mode & 0777u) == 0640u);
}

TEST_CASE("a symbolic link stays one, and its target is written") {
  const TemporaryFolder folder;
  const std::string target = folder.file("target", "old");
  std::filesystem::create_symlink(target, folder / "link");
  write_whole_file(folder / "link", "new");
  CHECK(std::filesystem::is_symlink(folder / "link"));
  CHECK(contents(target) == "new");
}

TEST_CASE("what cannot be written is said with its name and leaves nothing behind") {
  const TemporaryFolder folder;
  const auto attempt = [](const std::string& path) {
    return message_of<Failure>([&] { write_whole_file(path, "x"); });
  };
  CHECK(attempt(folder / "no/such/folder.png") ==
        (folder / "no/such/folder.png") + ": cannot write (there is no folder " + (folder / "no/such") + ")");
  CHECK(attempt(folder / ".") == (folder / ".") + ": cannot write (it is a directory)");
  CHECK(attempt("/dev/full") == "/dev/full: cannot write (No space left on device)");
  CHECK(folder.size() == 0);
}

TEST_CASE("a device is written to, not replaced") {
  write_whole_file("/dev/null", "x");
  CHECK(std::filesystem::is_character_file("/dev/null"));
}

TEST_CASE("reading says what is wrong") {
  const TemporaryFolder folder;
  const auto attempt = [](const std::string& path) {
    return message_of<Failure>([&] { (void)read_whole_file(path, 10); });
  };
  CHECK(attempt(folder / "missing") == (folder / "missing") + ": cannot read (no such file)");
  CHECK(attempt(folder / ".") == (folder / ".") + ": cannot read (not a regular file)");
  const std::string large = folder.file("large", "elevenbytes");
  CHECK(attempt(large) == large + ": too large (11 bytes; the limit is 10)");
  CHECK(read_whole_file(folder.file("fits", "ten bytes!"), 10) == "ten bytes!");
}
