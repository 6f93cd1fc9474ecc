#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""compare_hashes.py HASHES COMMAND...: the command's lines that begin with "frame " must be those of the file."""

import pathlib
import subprocess
import sys

wanted = pathlib.Path(sys.argv[1]).read_text().splitlines()
done = subprocess.run(sys.argv[2:], stdin=subprocess.DEVNULL, capture_output=True, text=True)
print(done.stdout, done.stderr, sep="")
found = [line for line in done.stdout.splitlines() if line.startswith("frame ")]
different = [pair for pair in zip(wanted, found) if pair[0] != pair[1]]
for expected, line in different:
    print(f"wanted: {expected}\nfound:  {line}")
if len(found) != len(wanted):
    print(f"{len(wanted)} frames wanted, {len(found)} found")
sys.exit(1 if done.returncode != 0 or different or len(found) != len(wanted) or not wanted else 0)
