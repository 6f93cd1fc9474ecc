// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace arcspan::tools {

/// A chunk that is to be written.
struct FileChunk {
  std::uint32_t tag = 0;  ///< see chunk_tag()
  std::size_t number = 0;
  std::string bytes{};
};

/// The container of docs/model-binary.md with these chunks, which must be in the order of their tags and
/// numbers. Throws Failure if there are more than the container takes.
[[nodiscard]] std::string chunk_file(const std::vector<FileChunk>& chunks);

}  // namespace arcspan::tools
