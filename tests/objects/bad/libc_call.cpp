// SPDX-License-Identifier: MIT
// must be rejected by: libc
unsigned length(const char* text) { return static_cast<unsigned>(__builtin_strlen(text)); }
