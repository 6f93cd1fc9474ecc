// SPDX-License-Identifier: MIT
// must be rejected by: nothing
// Division outside the span stage and 64-bit products anywhere are allowed: the rules must not cry wolf.
namespace arcspan {
unsigned reciprocal(unsigned divisor) { return 0xFFFFFFFFu / divisor; }
long long draw_command(long long a, long long b) { return a * b; }
}  // namespace arcspan
