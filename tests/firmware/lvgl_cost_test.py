#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""lvgl_cost_test.py PERCENT INSTRUCTIONS PREFIX IMAGE EMULATOR...: lv_arcspan_view must take at most PERCENT of a refresh and
INSTRUCTIONS per draw more than LVGL's refresh of the same areas without the scene and the scene drawn by arcspan.h alone, in the
mean of the frames of lvgl_test.cpp after the first."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "platform/qemu")]
import instruction_count  # noqa: E402

percent, instructions, prefix, image, *emulator = sys.argv[1:]
sections, output = instruction_count.count(image, emulator, prefix)
cost = {section["name"]: section["instructions"] for section in sections}
draws = [int(n) for n in re.findall(r"^draws: (\d+)$", "\n".join(output) if isinstance(output, list) else output, re.M)]
frames = range(1, len(draws))
assert draws and "another" not in str(output), output
refresh = sum(cost[f"frame {i}"] for i in frames)
more = refresh - sum(cost[f"bare {i}"] + cost[f"without {i}"] for i in frames)
per_draw = more / sum(draws[i] for i in frames)
print(f"refresh {refresh / len(frames):.0f}, of it the widget {more / len(frames):.0f} ({100 * more / refresh:.2f} %), {per_draw:.0f} per draw")
assert 100 * more / refresh <= float(percent) and per_draw <= float(instructions)
