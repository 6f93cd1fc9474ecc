// SPDX-License-Identifier: MIT
// must be rejected by: division
// The span stage itself does not divide; what it calls does.
namespace arcspan {
[[gnu::noinline]] int quotient(int a, int b) { return a % b; }
int draw_command(int a, int b) { return quotient(a, b) + 1; }
}  // namespace arcspan
