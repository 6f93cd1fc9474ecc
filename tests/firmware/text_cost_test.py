#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""text_cost_test.py INSTRUCTIONS BYTES OBJECT IMAGE EMULATOR...: the caption of cost_text.cpp must take at most that many
instructions, and all code of cost_caption.cpp in OBJECT, compiled for size, at most that many bytes. docs/text.md states what
each takes."""

import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "platform/qemu")]
import instruction_count  # noqa: E402
import page_figures  # noqa: E402

most_instructions, most_bytes, compiled, image, *emulator = sys.argv[1:]
sections, _ = instruction_count.count(image, emulator, "arm-none-eabi-")
cost = {section["name"]: section["instructions"] for section in sections if section["name"] != "between"}
listing = subprocess.run(["arm-none-eabi-size", "-A", compiled], check=True, capture_output=True, text=True).stdout
code = sum(int(size) for size in re.findall(r"^\.text\S*\s+(\d+)", listing, re.MULTILINE))
print(cost, "code", code)
assert 0 < cost["caption"] <= int(most_instructions), f"a caption: {cost['caption']} instructions"
assert 0 < code <= int(most_bytes), f"a caption: {code} bytes of code"
page_figures.check("text.md", "takes # instructions, # with damage, # with an outline, # with a background; a line of 300 pixels #, "
                   "a needle of 600 pixels #, a rectangle of 28,000 pixels #",
                   *(cost[name] for name in ("caption", "damage", "outlined", "filled", "line", "needle", "rectangle")))
