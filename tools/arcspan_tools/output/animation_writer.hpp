// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/fixed_point/fixed_animation.hpp>
#include <arcspan_tools/output/chunk_writer.hpp>

#include <string>
#include <vector>

namespace arcspan::tools {

/// The chunks of docs/animation-binary.md, in the order of their tags. Throws a Failure about `subject` if
/// one has more of something than it can hold.
[[nodiscard]] std::vector<FileChunk> animation_chunks(const FixedAnimation& animation,
                                                      const std::string& subject);

}  // namespace arcspan::tools
