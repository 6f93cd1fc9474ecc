#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""compare_hashes.py [--frame SHAPE-AND-METHOD] HASHES COMMAND...

The command's lines that begin with "frame " must be those of the file, or the file's one line for that frame.
"""

import pathlib
import subprocess
import sys

arguments = sys.argv[1:]
only = "frame "
if arguments[0] == "--frame":
    only += arguments[1] + " "
    arguments = arguments[2:]
wanted = [line for line in pathlib.Path(arguments[0]).read_text().splitlines() if line.startswith(only)]
done = subprocess.run(arguments[1:], stdin=subprocess.DEVNULL, capture_output=True, text=True)
print(done.stdout, done.stderr, sep="")
found = [line for line in done.stdout.splitlines() if line.startswith("frame ")]
different = [pair for pair in zip(wanted, found) if pair[0] != pair[1]]
for expected, line in different:
    print(f"wanted: {expected}\nfound:  {line}")
if len(found) != len(wanted):
    print(f"{len(wanted)} frames wanted, {len(found)} found")
sys.exit(1 if done.returncode != 0 or different or len(found) != len(wanted) or not wanted else 0)
