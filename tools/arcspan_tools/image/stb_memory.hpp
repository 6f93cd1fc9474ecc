// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace arcspan::tools {

/// The most bytes that the library stb gets in one piece from now on in this thread: a few compressed bytes
/// may otherwise fill the memory. A picture that needs more cannot be read.
void limit_stb_memory(std::size_t bytes);

}  // namespace arcspan::tools
