// SPDX-License-Identifier: MIT
// must be rejected by: division
// draw_command is the entry of the span stage.
namespace arcspan {
unsigned draw_command(unsigned height, unsigned width) { return height / width; }
}  // namespace arcspan
