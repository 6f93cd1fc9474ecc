// SPDX-License-Identifier: MIT
// must be rejected by: libc
void copy(int* to, const int* from, unsigned count) { __builtin_memcpy(to, from, count * sizeof(int)); }
