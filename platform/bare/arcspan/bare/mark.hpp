// SPDX-License-Identifier: MIT
#pragma once

// Tells platform/qemu/instruction_count.c that a section of the run ends here and the next begins. Does
// nothing by itself. The program names the section that begins in a line "section: NAME" of its output,
// before or after.
extern "C" void arcspan_mark();
