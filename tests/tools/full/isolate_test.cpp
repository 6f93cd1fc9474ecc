// SPDX-License-Identifier: MIT
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/isolate.hpp>
#include <catch2/catch.hpp>
#include <sys/wait.h>
#include <tests/tools/temporary_folder.hpp>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <new>

using namespace arcspan::tools;
using namespace arcspan::test;

namespace {

std::string message_for(const std::function<std::string()>& import) {
  return message_of<Failure>([&] { (void)run_isolated("m.dae", 0, import); });
}

}  // namespace

TEST_CASE("a result comes back whole from the other process") {
  const std::string sent = std::string(3, '\0') + std::string(5'000'000, 'r');
  CHECK(run_isolated("m.dae", 0, [&] { return sent; }) == sent);
  CHECK(run_isolated("m.dae", 0, [] { return std::string(); }).empty());
}

TEST_CASE("what the loader library prints is not shown") {
  const TemporaryFolder folder;
  const std::string printed = folder.file("printed", "");
  const int shown = ::dup(STDERR_FILENO);
  REQUIRE(std::freopen(printed.c_str(), "w", stderr) != nullptr);
  const std::string result = run_isolated("m.dae", 0, [] {
    std::fputs("assertion failed\n", stderr);
    std::fflush(stderr);
    return std::string("done");
  });
  std::fflush(stderr);
  ::dup2(shown, STDERR_FILENO);
  ::close(shown);
  CHECK(result == "done");
  CHECK(contents(printed).empty());
}

// The pipe's writing end is open as long as one of the two processes lives.
TEST_CASE("the loader's process ends with this one, even if it loops") {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const pid_t parent = ::fork();
  if (parent == 0) {
    (void)message_for([&ends]() -> std::string {
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
  CHECK(message_for([]() -> std::string { throw Failure("m.dae", "line 3: wrong"); }) ==
        "m.dae: line 3: wrong");
  CHECK(message_for([]() -> std::string { throw std::bad_alloc(); }) ==
        "m.dae: the mesh loader needs more memory than it may have (damaged?)");
  // What the standard library says is not for users.
  CHECK(message_for([]() -> std::string { return {std::string().at(1)}; }) ==
        "m.dae: the mesh loader gave up");
  CHECK(message_for([]() -> std::string { return std::string(1u << 30, 0); }) ==
        "m.dae: the mesh loader needs more memory than it may have (damaged?)");
  CHECK(message_for([]() -> std::string { ::_exit(3); }) ==
        "m.dae: the mesh loader library ended with status 3");
  CHECK(message_for([]() -> std::string {
          std::signal(SIGSEGV, SIG_DFL);
          ::raise(SIGSEGV);
          return {};
        }) == "m.dae: the mesh loader library crashed: Segmentation fault");
}
