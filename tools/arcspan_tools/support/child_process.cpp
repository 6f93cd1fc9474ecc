// SPDX-License-Identifier: MIT
#include <arcspan_tools/support/child_process.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace arcspan::tools {
namespace {

constexpr std::size_t kMostErrorText = std::size_t{1} << 20;

/// Where the child's three standard streams lead.
class Streams {
 public:
  Streams(const std::filesystem::path& input, const std::filesystem::path& error) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, input.c_str(), O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, error.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0600);
  }
  Streams(const Streams&) = delete;
  Streams& operator=(const Streams&) = delete;
  ~Streams() { posix_spawn_file_actions_destroy(&actions_); }

  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

int wait_for(pid_t child) {
  int ended = 0;
  while (waitpid(child, &ended, 0) < 0) {
    if (errno != EINTR) return -1;
  }
  return WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
}

}  // namespace

ScratchFolder::ScratchFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "arcspan-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw Failure(pattern, std::strerror(errno));
  path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::optional<ChildEnd> run_child(const std::string& program, const std::vector<std::string>& arguments,
                                  const std::string& input) {
  const ScratchFolder folder;
  write_whole_file(folder / "in", input);
  const Streams streams(folder / "in", folder / "err");
  std::vector<std::string> words = {program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  const int failed = posix_spawnp(&child, program.c_str(), streams.get(), nullptr, argv.data(), environ);
  if (failed == ENOENT || failed == EACCES) return std::nullopt;
  if (failed != 0) throw Failure(program, std::strerror(failed));
  const int status = wait_for(child);
  return ChildEnd{status, read_whole_file(folder / "err", kMostErrorText)};
}

}  // namespace arcspan::tools
