#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""scene_cost_test.py LIMIT IMAGE EMULATOR...: in the frames of cost_scene.cpp a scene of one object must take at most 1 %
more instructions than draw_mesh(), and preparing 20 objects at most LIMIT."""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "platform/qemu")]
import instruction_count  # noqa: E402

limit, image, *emulator = sys.argv[1:]
sections, _ = instruction_count.count(image, emulator, "arm-none-eabi-")
cost = {section["name"]: section["instructions"] for section in sections}
print(cost)
scene = cost["prepare one"] + cost["draw one"]
assert scene <= 1.01 * cost["draw mesh"], f"a scene of one object: {scene}, draw_mesh: {cost['draw mesh']}"
assert cost["prepare twenty"] <= int(limit), f"preparing 20 objects: {cost['prepare twenty']}, at most {limit}"
