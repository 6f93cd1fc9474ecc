// SPDX-License-Identifier: MIT
#include <arcspan_tools/support/child_process.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/isolate.hpp>
#include <arcspan_tools/support/output_file.hpp>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <new>

namespace arcspan::tools {
namespace {

// The first byte of what the child sends: its result follows, or the reason of a failure.
constexpr char kResult = 'r';
constexpr char kFailure = 'f';

void limit_resources([[maybe_unused]] std::size_t input_bytes) {
  constexpr rlim_t kMostSeconds = 120;
  const rlimit seconds{kMostSeconds, kMostSeconds};
  ::setrlimit(RLIMIT_CPU, &seconds);
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
#if !defined(__SANITIZE_ADDRESS__) && !defined(ARCSPAN_SANITIZED)
  // The address sanitizer reserves terabytes for its shadow.
  constexpr rlim_t kBytes = rlim_t{512} << 20;
  constexpr rlim_t kBytesPerByte = 24;  // a Collada file takes less than half of this
  const rlim_t most = kBytes + kBytesPerByte * input_bytes;
  const rlimit bytes{most, most};
  ::setrlimit(RLIMIT_AS, &bytes);
#endif
}

std::string answer_of(const std::function<std::string()>& work) {
  try {
    return kResult + work();
  } catch (const Failure& e) {
    return kFailure + std::string(e.reason());
  } catch (const std::bad_alloc&) {
    return kFailure + std::string("the mesh loader needs more memory than it may have (damaged?)");
  } catch (...) {
    return kFailure + std::string("the mesh loader gave up");
  }
}

/// Discards what this process prints. A library that crashes prints lines of its own, and users shall see
/// one line only, which is that of the parent.
void discard_output() {
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  ::dup2(nowhere, STDERR_FILENO);
  ::dup2(nowhere, STDOUT_FILENO);
}

[[noreturn]] void child(int pipe, std::size_t input_bytes, const std::function<std::string()>& work) {
  discard_output();
  limit_resources(input_bytes);
  int status = 0;
  try {
    write_all(pipe, answer_of(work), "pipe");
  } catch (...) {
    status = 1;
  }
  ::_exit(status);
}

std::string receive_all(int pipe) {
  std::string bytes;
  char buffer[1 << 16];
  for (;;) {
    const ssize_t count = ::read(pipe, buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return bytes;
    bytes.append(buffer, static_cast<std::size_t>(count));
  }
}

std::string cause_of_death(int status) {
  if (!WIFSIGNALED(status)) return "ended with status " + std::to_string(WEXITSTATUS(status));
  if (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL) return "did not come to an end";
  return std::string("crashed: ") + ::strsignal(WTERMSIG(status));
}

}  // namespace

std::string run_isolated(const std::string& subject, std::size_t input_bytes,
                         const std::function<std::string()>& work) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw Failure(subject, "cannot start the mesh loader");
  const pid_t process = fork_child();
  if (process == 0) {
    ::close(ends[0]);
    child(ends[1], input_bytes, work);
  }
  ::close(ends[1]);
  if (process < 0) {
    ::close(ends[0]);
    throw Failure(subject, "cannot start the mesh loader");
  }
  std::string bytes = receive_all(ends[0]);
  ::close(ends[0]);
  const int status = wait_for_child(process);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || bytes.empty()) {
    throw Failure(subject, "the mesh loader library " + cause_of_death(status));
  }
  const char kind = bytes[0];
  bytes.erase(0, 1);
  if (kind == kFailure) throw Failure(subject, bytes);
  return bytes;
}

}  // namespace arcspan::tools
