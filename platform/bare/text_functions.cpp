// SPDX-License-Identifier: MIT
// Compilers call it for loops that look for the end of a text, which no code of this project has. For
// programs with libraries that do, without -fno-tree-loop-distribute-patterns the loop below would be such a
// call.
#include <cstddef>

extern "C" std::size_t strlen(const char* text) {
  const char* end = text;
  while (*end != 0) ++end;
  return static_cast<std::size_t>(end - text);
}
