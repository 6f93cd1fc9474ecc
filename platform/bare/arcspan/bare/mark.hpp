// SPDX-License-Identifier: MIT
#pragma once

// Marks the end of one section of the run and the beginning of the next for
// platform/qemu/instruction_count.c. It does nothing itself. The program names the new section in a line
// "section: NAME" of its output, before or after.
extern "C" void arcspan_mark();
