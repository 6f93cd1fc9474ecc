// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/isolate.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <catch2/catch.hpp>
#include <sys/wait.h>
#include <tests/tools/temporary_folder.hpp>
#include <unistd.h>

#include <csignal>
#include <new>

using namespace arcspan::tools;
using arcspan::test::message_of;

namespace {

std::string message_for(const std::function<ImportedMesh()>& import) {
  return message_of<Failure>([&] { (void)run_isolated("m.obj", import, [](std::size_t) {}); });
}

}  // namespace

TEST_CASE("a mesh comes back whole from the loader's process") {
  ImportedMesh sent;
  for (int i = 0; i < 5000; ++i) sent.triangles.push_back({{{{0.1 * i, 0, 0}, {0, 0, 1}}, {}, {}}});
  std::size_t last = 0;
  const ImportedMesh received = run_isolated(
      "m.obj", [&] { return sent; }, [&](std::size_t bytes) { last = bytes; });
  REQUIRE(received.triangles.size() == sent.triangles.size());
  CHECK(received.triangles[4999][0].position == sent.triangles[4999][0].position);
  CHECK(received.triangles[4999][0].normal == Vec3{0, 0, 1});
  CHECK(last == 1 + 2 * sizeof(std::uint64_t) + 5000 * sizeof(sent.triangles[0]));
}

TEST_CASE("a mesh without triangles comes back empty") {
  CHECK(run_isolated(
            "m.obj", [] { return ImportedMesh{}; }, [](std::size_t) {})
            .triangles.empty());
}

// The pipe's writing end is open as long as one of the two processes lives.
TEST_CASE("the loader's process ends with this one, even if it loops") {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const pid_t parent = ::fork();
  if (parent == 0) {
    (void)message_for([&ends]() -> ImportedMesh {
      (void)!::write(ends[1], "s", 1);
      for (;;) ::pause();
    });
    ::_exit(0);
  }
  ::close(ends[1]);
  char byte = 0;
  REQUIRE(::read(ends[0], &byte, 1) == 1);
  ::kill(parent, SIGKILL);
  ::waitpid(parent, nullptr, 0);
  ::alarm(10);  // ends the test if the loader lives
  CHECK(::read(ends[0], &byte, 1) == 0);
  ::alarm(0);
  ::close(ends[0]);
}

TEST_CASE("every way in which the loader's process can end is reported in one line") {
  CHECK(message_for([]() -> ImportedMesh { throw Failure("m.obj", "line 3: wrong"); }) ==
        "m.obj: line 3: wrong");
  CHECK(message_for([]() -> ImportedMesh { throw std::bad_alloc(); }) ==
        "m.obj: the mesh loader needs more memory than it may have");
  CHECK(message_for([]() -> ImportedMesh { ::_exit(3); }) ==
        "m.obj: the mesh loader library ended with status 3");
  CHECK(message_for([]() -> ImportedMesh {
          std::signal(SIGSEGV, SIG_DFL);
          ::raise(SIGSEGV);
          return {};
        }) == "m.obj: the mesh loader library crashed: Segmentation fault");
}
