// SPDX-License-Identifier: MIT
// Functions that compilers call for copies of structures and require in every environment. They are simple
// because the pipeline has none of them in a loop. Without -fno-tree-loop-distribute-patterns the compiler
// would recognise the loop in memset as a memset, which would then call itself.
#include <cstddef>

extern "C" {

void* memset(void* to, int value, std::size_t count) {
  auto* at = static_cast<unsigned char*>(to);
  for (; count != 0; --count) *at++ = static_cast<unsigned char>(value);
  return to;
}

void* memcpy(void* to, const void* from, std::size_t count) {
  auto* at = static_cast<unsigned char*>(to);
  const auto* source = static_cast<const unsigned char*>(from);
  for (; count != 0; --count) *at++ = *source++;
  return to;
}

void* memmove(void* to, const void* from, std::size_t count) {
  if (to <= from) return memcpy(to, from, count);  // memcpy copies upwards, which is safe for this overlap
  auto* at = static_cast<unsigned char*>(to);
  const auto* source = static_cast<const unsigned char*>(from);
  while (count-- != 0) at[count] = source[count];
  return to;
}

int memcmp(const void* left, const void* right, std::size_t count) {
  const auto* a = static_cast<const unsigned char*>(left);
  const auto* b = static_cast<const unsigned char*>(right);
  for (; count != 0; --count, ++a, ++b) {
    if (*a != *b) return *a - *b;
  }
  return 0;
}

/// Fills the vtable slots of pure virtual functions. A call would be a fault.
[[noreturn]] void __cxa_pure_virtual() { __builtin_trap(); }

}  // extern "C"
