// SPDX-License-Identifier: MIT
#include <arcspan_tools/compare/instructions.hpp>
#include <arcspan_tools/support/child_process.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <charconv>

namespace arcspan::tools {
namespace {

constexpr std::size_t kMostProfile = std::size_t{1} << 28;

/// The number behind `summary: ` in a callgrind profile (its manual, section "File Format").
std::optional<std::uint64_t> summary(const std::string& profile) {
  const std::string key = "\nsummary: ";
  const std::size_t at = profile.find(key);
  if (at == std::string::npos) return std::nullopt;
  std::uint64_t count = 0;
  const char* first = profile.data() + at + key.size();
  const auto parsed = std::from_chars(first, profile.data() + profile.size(), count);
  return parsed.ec == std::errc() ? std::optional(count) : std::nullopt;
}

}  // namespace

std::optional<std::uint64_t> drawing_instructions(const std::vector<std::string>& command) {
  ScratchFolder folder;
  const std::string& profile = folder.file("profile").path();
  // Without --vgdb=no valgrind has pipes in /tmp, which stay there if it is killed.
  std::vector<std::string> arguments = {"--tool=callgrind", "--vgdb=no", "--toggle-collect=*draw_into*",
                                        "--callgrind-out-file=" + profile};
  arguments.insert(arguments.end(), command.begin(), command.end());
  const std::optional<ChildEnd> end = run_child("valgrind", arguments);
  if (!end) return std::nullopt;
  if (end->status != 0) throw Failure("valgrind", "failed with status " + std::to_string(end->status));
  if (!std::filesystem::exists(profile)) throw Failure("valgrind", "wrote no profile");
  const std::optional<std::uint64_t> count = summary(read_whole_file(profile, kMostProfile));
  if (!count) throw Failure("valgrind", "its profile holds no sum");
  if (*count == 0) throw Failure("valgrind", "counted nothing in the function that draws");
  return count;
}

}  // namespace arcspan::tools
