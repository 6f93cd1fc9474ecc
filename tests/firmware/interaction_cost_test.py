#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""interaction_cost_test.py LIMIT IMAGE EMULATOR...: in the sections of cost_interaction.cpp picking must take at most LIMIT
instructions, and drawing after drawn_rect() must save at least a third of what that takes, as docs/interaction.md says."""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "platform/qemu")]
import instruction_count  # noqa: E402
import page_figures  # noqa: E402

limit, image, *emulator = sys.argv[1:]
sections, _ = instruction_count.count(image, emulator, "arm-none-eabi-")
cost = {section["name"]: section["instructions"] for section in sections}
print(cost)
assert cost["pick"] <= int(limit), f"picking: {cost['pick']}, at most {limit}"
saved = cost["draw fine"] - cost["draw in rectangle"]
assert 3 * saved >= cost["rectangle"], f"drawing after drawn_rect() saves {saved} of its {cost['rectangle']}"
page_figures.check("interaction.md", "triangles: #, of which drawing saves #", cost["rectangle"], saved)
