// SPDX-License-Identifier: MIT
// must be rejected by: division
namespace arcspan::span {
unsigned slope(unsigned height, unsigned width) { return height / width; }
}  // namespace arcspan::span
