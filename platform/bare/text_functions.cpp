// SPDX-License-Identifier: MIT
// Compilers turn loops that look for the end of a text into calls of strlen(). This project has no such loop;
// programs with libraries that do are linked with this file, which is compiled with
// -fno-tree-loop-distribute-patterns, because the loop below would be a call of itself.
#include <cstddef>

extern "C" std::size_t strlen(const char* text) {
  const char* end = text;
  while (*end != 0) ++end;
  return static_cast<std::size_t>(end - text);
}
