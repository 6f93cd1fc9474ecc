// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/isolate.hpp>
#include <arcspan_tools/support/child_process.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <new>
#include <type_traits>

namespace arcspan::tools {
namespace {

static_assert(std::is_trivially_copyable_v<RawMesh::Corner>, "corners travel as plain bytes");
using Triangle = std::array<RawMesh::Corner, 3>;
static_assert(sizeof(TriangleSource) == 4 * sizeof(std::uint32_t));

constexpr rlim_t kMostSeconds = 120;

// The first byte of what the child sends. The numbers of triangles and of sources follow, triangles, sources
// and looks; or the text of what went wrong.
enum class Answer : char { kMesh = 'm', kFailure = 'f' };
using SentCounts = std::array<std::uint64_t, 2>;

bool send(int pipe, const void* data, std::size_t size) {
  const char* at = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = ::write(pipe, at, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    at += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

void limit_resources() {
  const rlimit seconds{kMostSeconds, kMostSeconds};
  ::setrlimit(RLIMIT_CPU, &seconds);
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
#if !defined(__SANITIZE_ADDRESS__) && !defined(ARCSPAN_SANITIZED)
  // The address sanitizer reserves terabytes for its shadow.
  constexpr rlim_t kMostBytes = rlim_t{4} << 30;
  const rlimit bytes{kMostBytes, kMostBytes};
  ::setrlimit(RLIMIT_AS, &bytes);
#endif
}

void answer(int pipe, Answer kind, const void* data, std::size_t size) {
  if (send(pipe, &kind, 1)) (void)send(pipe, data, size);
}

// A failure's text already names the subject.
[[noreturn]] void child(int pipe, const std::string& subject, const std::function<ImportedMesh()>& import) {
  limit_resources();
  std::string failure;
  try {
    const ImportedMesh mesh = import();
    const SentCounts counts{mesh.triangles.size(), mesh.sources.size()};
    answer(pipe, Answer::kMesh, counts.data(), sizeof counts);
    (void)send(pipe, mesh.triangles.data(), mesh.triangles.size() * sizeof(Triangle));
    (void)send(pipe, mesh.sources.data(), mesh.sources.size() * sizeof(TriangleSource));
    (void)send(pipe, mesh.looks.data(), mesh.looks.size());
    ::_exit(0);
  } catch (const std::bad_alloc&) {
    failure = subject + ": the mesh loader needs more memory than it may have";
  } catch (const std::exception& e) {
    failure = e.what();
  } catch (...) {
    failure = subject + ": the mesh loader gave up";
  }
  answer(pipe, Answer::kFailure, failure.data(), failure.size());
  ::_exit(0);
}

std::string receive_all(int pipe, const std::function<void(std::size_t)>& received) {
  std::string bytes;
  char buffer[1 << 16];
  for (;;) {
    pollfd ready{pipe, POLLIN, 0};
    received(bytes.size());
    if (::poll(&ready, 1, 100) == 0) continue;
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

template <class T>
void take(std::string_view& bytes, std::vector<T>& values, std::size_t count) {
  values.resize(count);
  if (count == 0) return;
  std::memcpy(static_cast<void*>(values.data()), bytes.data(), count * sizeof(T));
  bytes.remove_prefix(count * sizeof(T));
}

// Carries the child's finished message, which already names its subject.
ImportedMesh decode(const std::string& bytes, const std::string& subject) {
  std::string_view body = std::string_view(bytes).substr(1);
  if (bytes[0] == static_cast<char>(Answer::kFailure)) {
    const std::string prefix = subject + ": ";
    throw Failure(subject, std::string(body.starts_with(prefix) ? body.substr(prefix.size()) : body));
  }
  SentCounts counts{};
  if (body.size() < sizeof counts) throw Failure(subject, "the mesh loader was interrupted");
  std::memcpy(counts.data(), body.data(), sizeof counts);
  body.remove_prefix(sizeof counts);
  if (body.size() < counts[0] * sizeof(Triangle) + counts[1] * sizeof(TriangleSource)) {
    throw Failure(subject, "the mesh loader was interrupted");
  }
  ImportedMesh mesh;
  take(body, mesh.triangles, counts[0]);
  take(body, mesh.sources, counts[1]);
  mesh.looks = body;
  return mesh;
}

}  // namespace

ImportedMesh run_isolated(const std::string& subject, const std::function<ImportedMesh()>& import,
                          const std::function<void(std::size_t)>& received) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw Failure(subject, "cannot start the mesh loader");
  const pid_t process = fork_child();
  if (process == 0) {
    ::close(ends[0]);
    child(ends[1], subject, import);
  }
  ::close(ends[1]);
  if (process < 0) {
    ::close(ends[0]);
    throw Failure(subject, "cannot start the mesh loader");
  }
  const std::string bytes = receive_all(ends[0], received);
  ::close(ends[0]);
  const int status = wait_for_child(process);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || bytes.empty()) {
    throw Failure(subject, "the mesh loader library " + cause_of_death(status));
  }
  return decode(bytes, subject);
}

}  // namespace arcspan::tools
