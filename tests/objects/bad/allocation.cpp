// SPDX-License-Identifier: MIT
// must be rejected by: allocation
int* row(unsigned width) { return new int[width]; }
