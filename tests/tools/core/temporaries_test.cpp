// SPDX-License-Identifier: MIT
#include <arcspan_tools/support/child_process.hpp>
#include <arcspan_tools/support/printable.hpp>
#include <catch2/catch.hpp>
#include <sys/wait.h>
#include <tests/tools/temporary_folder.hpp>
#include <unistd.h>

#include <csignal>
#include <functional>

using namespace arcspan::tools;
using arcspan::test::TemporaryFolder;

namespace {

/// The status with which a process ends that does `work`.
int status_of(const std::function<void()>& work) {
  const pid_t process = ::fork();
  if (process == 0) {
    work();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(process, &status, 0);
  return status;
}

}  // namespace

TEST_CASE("a signal removes all temporaries, and the process dies from it") {
  const int signal = GENERATE(SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU);
  CAPTURE(signal);
  const TemporaryFolder folder;
  const std::string kept = folder.file("kept", "x");
  const int status = status_of([&] {
    (void)std::signal(signal, SIG_DFL);
    remove_temporaries_at_signals();
    ScratchFolder first(folder / "", "first");
    ScratchFolder second(folder / "", "second");
    write_new_file(first.file("a").path(), "a", "a");
    write_new_file(first.file("b").path(), "b", "b");
    (void)first.file("never made");
    const Removal single(folder.file("single", "x"));
    Removal renamed(kept);
    renamed.cancel();
    (void)::raise(signal);
  });
  CHECK(WIFSIGNALED(status));
  CHECK(WTERMSIG(status) == signal);
  CHECK(folder.size() == 1);
}

TEST_CASE("a signal that is ignored stays ignored") {
  const TemporaryFolder folder;
  const int status = status_of([&] {
    (void)std::signal(SIGHUP, SIG_IGN);
    remove_temporaries_at_signals();
    const Removal file(folder.file("a", "x"));
    (void)::raise(SIGHUP);
    ::_exit(std::filesystem::exists(file.path()) ? 7 : 8);
  });
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 7);
}

TEST_CASE("a signal waits for the end of a pause") {
  const TemporaryFolder folder;
  const int status = status_of([&] {
    remove_temporaries_at_signals();
    const Removal file(folder.file("a", "x"));
    const SignalPause pause;
    (void)::raise(SIGTERM);
    ::_exit(std::filesystem::exists(file.path()) ? 7 : 8);
  });
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 7);
}

TEST_CASE("a child leaves its parent's temporaries alone, and dies from the same signals") {
  const TemporaryFolder folder;
  const std::string kept = folder.file("kept", "x");
  const int status = status_of([&] {
    remove_temporaries_at_signals();
    const Removal of_parent(kept);
    const pid_t child = fork_child();
    if (child == 0) {
      (void)::raise(SIGTERM);
      ::_exit(0);
    }
    const int of_child = wait_for_child(child);
    const bool died = WIFSIGNALED(of_child) && WTERMSIG(of_child) == SIGTERM;
    ::_exit(died && std::filesystem::exists(kept) ? 7 : 8);
  });
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 7);
}

TEST_CASE("a child is killed when its parent is") {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const int status = status_of([&] {
    if (fork_child() == 0) {
      (void)!::write(ends[1], "s", 1);
      for (;;) ::pause();
    }
    char started = 0;
    (void)!::read(ends[0], &started, 1);
    (void)::raise(SIGKILL);
  });
  CHECK(WTERMSIG(status) == SIGKILL);
  // Whoever lives holds the pipe's other end open.
  ::close(ends[1]);
  char byte = 0;
  ::alarm(10);
  CHECK(::read(ends[0], &byte, 1) == 0);
  ::alarm(0);
  ::close(ends[0]);
}

TEST_CASE("run_child returns nothing for a program that does not exist, and the status of one that fails") {
  CHECK_FALSE(run_child("no-such-program", {}).has_value());
  const auto end = run_child("sh", {"-c", "cat >&2; exit 3"}, "input");
  REQUIRE(end.has_value());
  CHECK(end->status == 3);
  CHECK(end->error_text == "input");
}

TEST_CASE("text for a terminal is one line without control characters") {
  CHECK(printable("plain caf\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80") ==
        "plain caf\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80");
  CHECK(printable("a\nb\tc\rd\x1B[31m\x7F") == "a\\nb\\tc\\rd\\x1b[31m\\x7f");
  CHECK(printable(std::string_view("\0", 1)) == "\\x00");
  CHECK(printable("\xC2\x9B"
                  "31m") == "\\xc2\\x9b31m");  // a control sequence in one character
  CHECK(printable("\x9B"
                  "31m \xC3") == "\\x9b31m \\xc3");
  CHECK(printable("\xC0\x8A \xED\xA0\x80") == "\\xc0\\x8a \\xed\\xa0\\x80");  // an overlong form, a surrogate
}
