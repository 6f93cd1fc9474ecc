// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace arcspan::tools {

/// Writes one result, whole or not at all, as write_results() does. Throws Failure.
void write_whole_file(const std::filesystem::path& path, std::string bytes, const std::string& summary = {});

/// Writes a file that does not exist yet, with the permissions of the user's mask; for files in a temporary
/// folder. `subject` names the file in the Failure that it may throw.
void write_new_file(const std::filesystem::path& path, std::string_view bytes,
                    const std::filesystem::path& subject);

/// Writes all bytes to a file descriptor. Throws a Failure about `subject`.
void write_all(int descriptor, std::string_view bytes, const std::filesystem::path& subject);

/// Throws a Failure about `subject`: it cannot be read or written (`doing`) for the reason that errno holds.
[[noreturn]] void fail_with_errno(const std::filesystem::path& subject, const char* doing);

/// Whether `path` stands for standard output: `-`, or `KIND:-` where the kind of file matters (`ppm:-`). A
/// file of that name is `./-`.
[[nodiscard]] bool is_standard_output(const std::filesystem::path& path);

/// The kind of file that a name asks for: its extension in lower case without the dot, KIND of `KIND:-`,
/// `otherwise` for `-`.
[[nodiscard]] std::string output_kind(const std::filesystem::path& path, std::string_view otherwise);

/// Where a command that writes these files (empty names are none) prints what it has to say about them:
/// standard output, or standard error if one of them goes there. Throws Failure if two would.
[[nodiscard]] std::FILE* report_stream(const std::vector<std::filesystem::path>& outputs);

/// Reads the whole of a regular file of at most `limit` bytes. Throws Failure.
[[nodiscard]] std::string read_whole_file(const std::filesystem::path& path, std::size_t limit);

/// Whether read_whole_file() has read the file at `path` in this process, by this name or another. These are
/// the files that the user named, and those that a model file refers to.
[[nodiscard]] bool was_read(const std::filesystem::path& path);

}  // namespace arcspan::tools
