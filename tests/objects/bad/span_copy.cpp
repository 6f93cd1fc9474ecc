// SPDX-License-Identifier: MIT
// must be rejected by: span libc
namespace arcspan {
void draw_command(int* to, const int* from, unsigned count) {
  __builtin_memcpy(to, from, count * sizeof(int));
}
}  // namespace arcspan
