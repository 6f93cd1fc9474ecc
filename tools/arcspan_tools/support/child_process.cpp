// SPDX-License-Identifier: MIT
#include <arcspan_tools/support/child_process.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

namespace arcspan::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostErrorText = std::size_t{1} << 20;

fs::path folder_for_temporaries() {
  std::error_code error;
  fs::path folder = fs::temp_directory_path(error);
  if (!error) return folder;
  const char* const wanted = std::getenv("TMPDIR");
  throw Failure("TMPDIR",
                std::string(wanted == nullptr ? "/tmp" : wanted) + " is no folder for temporary files");
}

void open_as(int stream, const char* path, int flags) {
  const int opened = ::open(path, flags, 0600);
  if (opened < 0) ::_exit(1);
  if (opened == stream) return;
  ::dup2(opened, stream);
  ::close(opened);
}

/// In the child: becomes the program, or writes errno into `failed`.
[[noreturn]] void become(char* const* argv, const std::string& in, const std::string& err, int failed) {
  open_as(STDIN_FILENO, in.c_str(), O_RDONLY);
  open_as(STDOUT_FILENO, "/dev/null", O_WRONLY);
  open_as(STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
  ::execvp(argv[0], argv);
  const int reason = errno;
  (void)!::write(failed, &reason, sizeof reason);
  ::_exit(1);
}

std::vector<char*> argument_vector(std::vector<std::string>& words) {
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  return argv;
}

/// Returns errno of a failed exec, which the child wrote into the pipe, or 0 if exec closed the pipe.
int reason_of_failure(int pipe) {
  int reason = 0;
  while (::read(pipe, &reason, sizeof reason) < 0 && errno == EINTR) {
  }
  ::close(pipe);
  return reason;
}

}  // namespace

pid_t fork_child() {
  const SignalPause pause;  // a signal between fork and the line below would remove the parent's temporaries
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child != 0) return child;
  leave_temporaries_to_parent();
  (void)std::signal(SIGXFSZ, SIG_DFL);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);  // it has ended already
  return 0;
}

int wait_for_child(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

ScratchFolder::ScratchFolder(const fs::path& parent, const fs::path& subject) {
  const SignalPause pause;
  std::string name = temporary_pattern(parent);
  if (::mkdtemp(name.data()) == nullptr) fail_with_errno(subject, "write");
  folder_.emplace(name);
  path_ = name;
}

ScratchFolder::ScratchFolder() : ScratchFolder(folder_for_temporaries(), "the folder for temporary files") {}

Removal& ScratchFolder::file(const std::string& name) { return files_.emplace_back((path_ / name).string()); }

std::optional<ChildEnd> run_child(const std::string& program, const std::vector<std::string>& arguments,
                                  const std::string& input) {
  ScratchFolder folder;
  const std::string& in = folder.file("in").path();
  const std::string& err = folder.file("err").path();
  write_new_file(in, input, program);
  std::vector<std::string> words = {program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const std::vector<char*> argv = argument_vector(words);
  int failed[2];
  if (::pipe2(failed, O_CLOEXEC) != 0) throw Failure(program, std::strerror(errno));
  const pid_t child = fork_child();
  if (child == 0) become(argv.data(), in, err, failed[1]);
  const int no_child = errno;
  ::close(failed[1]);
  const int reason = reason_of_failure(failed[0]);
  if (child < 0) throw Failure(program, std::strerror(no_child));
  const int status = wait_for_child(child);
  if (reason == ENOENT || reason == EACCES) return std::nullopt;
  if (reason != 0) throw Failure(program, std::strerror(reason));
  return ChildEnd{WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_whole_file(err, kMostErrorText)};
}

}  // namespace arcspan::tools
