#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""count_test.py PREFIX IMAGE EMULATOR...: instruction_count.py must count the loops of count_test.cpp exactly, twice."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "platform/qemu"))
import instruction_count  # noqa: E402

prefix, image, *emulator = sys.argv[1:]
first, _ = instruction_count.count(image, emulator, prefix)
second, _ = instruction_count.count(image, emulator, prefix)
assert first == second, "two runs differ"

total = {section["name"]: section["instructions"] for section in first}
assert total["1001 turns"] - total["1 turns"] == 2000, total
assert total["100001 turns"] - total["1 turns"] == 200000, total

loop = {section["name"]: next((n for name, n in section["functions"].items() if "loop" in name), 0) for section in first}
assert loop["1001 turns"] - loop["1 turns"] == 2000, loop
assert loop["between"] == 0, loop
assert all(sum(section["functions"].values()) == section["instructions"] for section in first), "instructions without function"
print(total)
