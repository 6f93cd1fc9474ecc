// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace arcspan::tools {

/// Writes `bytes` to `path` whole or not at all: into a temporary beside the target that is then renamed, so
/// a reader never sees half a file and a failure leaves what was there before. A target that exists and is no
/// regular file (a terminal, a pipe) is written directly; a symbolic link is followed. Throws Failure.
void write_whole_file(const std::filesystem::path& path, std::string_view bytes);

/// Reads the whole of a regular file of at most `limit` bytes. Throws Failure.
[[nodiscard]] std::string read_whole_file(const std::filesystem::path& path, std::size_t limit);

}  // namespace arcspan::tools
