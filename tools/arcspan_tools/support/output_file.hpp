// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

namespace arcspan::tools {

/// Writes `bytes` to `path` whole or not at all: into a temporary beside the target that is then renamed, so
/// a reader never sees half a file and a failure leaves what was there before. A target that exists and is no
/// regular file (a terminal, a pipe) is written directly; a symbolic link is followed. Standard output is
/// written for the names below. Throws Failure.
void write_whole_file(const std::filesystem::path& path, std::string_view bytes);

/// Whether `path` stands for standard output: `-`, or `KIND:-` where the kind of file matters (`ppm:-`). A
/// file of that name is `./-`.
[[nodiscard]] bool is_standard_output(const std::filesystem::path& path);

/// The kind of file that a name asks for: its extension in lower case without the dot, KIND of `KIND:-`,
/// `otherwise` for `-`.
[[nodiscard]] std::string output_kind(const std::filesystem::path& path, std::string_view otherwise);

/// Where a command that writes these files (empty names are none) prints what it has to say about them:
/// standard output, or standard error if one of them goes there. Throws Failure if two would.
[[nodiscard]] std::FILE* report_stream(std::initializer_list<std::filesystem::path> outputs);

/// Reads the whole of a regular file of at most `limit` bytes. Throws Failure.
[[nodiscard]] std::string read_whole_file(const std::filesystem::path& path, std::size_t limit);

}  // namespace arcspan::tools
