#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""count_test.py PREFIX IMAGE EMULATOR...: instruction_count.py must count the loops of count_test.cpp exactly, twice, and
frame_parts.py (for Arm) must tell its pixels from its rows."""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "platform/qemu"), str(ROOT / "scripts/lib")]
import frame_parts  # noqa: E402
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

if prefix == "arm-none-eabi-":
    sections, _ = instruction_count.count(image, emulator, prefix, ranges=frame_parts.classify(image, prefix))
    counted = [frame_parts.count_parts(s["functions"]) for s in sections]
    assert all(sum(c.values()) == s["instructions"] for c, s in zip(counted, sections)), "a part is missing"
    parts = {s["name"]: c for s, c in zip(sections, counted)}
    print(parts)
    frame, wide, high = parts["10 x 1000"], parts["10 x 2000"], parts["20 x 1000"]
    assert 7 * 10000 <= wide["pixel"] - frame["pixel"] <= 10 * 10000, "pixels are not the pixels' loop"
    assert wide["row"] == frame["row"], "rows have instructions of pixels"
    assert high["pixel"] == 2 * frame["pixel"], "pixels have instructions of rows"
    assert 11 * 10 <= high["row"] - frame["row"] <= 20 * 10, "rows are not the rows' loop"
    assert wide["triangle"] == high["triangle"] == frame["triangle"] > 0, "set-up is part of rows"
