#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Counts the instructions that a firmware image executes between its marks, per function.

    instruction_count.py [--prefix arm-none-eabi-] IMAGE -- EMULATOR [ARGUMENTS...]

The image calls arcspan_mark() at the start of each section and outputs a line "section: NAME" for it. This program
prints JSON: a list of {"name", "instructions", "functions"}. Instructions before the first mark are not counted.
"""

import argparse
import atexit
import functools
import json
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
MARK = "arcspan_mark"


@functools.cache
def build_plugin():
    """The plugin of QEMU, built once per process."""
    folder = tempfile.TemporaryDirectory()
    atexit.register(folder.cleanup)
    plugin = pathlib.Path(folder.name, "instruction_count.so")
    subprocess.run(["cc", "-O2", "-Wall", "-Wextra", "-Werror", "-fPIC", "-shared", "-fvisibility=hidden",
                    HERE / "instruction_count.c", "-o", plugin], check=True)
    return plugin


def functions(image, prefix):
    """Returns (first address, size, demangled name) of all functions, sorted, and the mark's address."""
    text = subprocess.run([prefix + "nm", "-C", "-n", "--defined-only", image], check=True, capture_output=True,
                          text=True).stdout
    starts = {}
    for line in text.splitlines():
        if symbol := re.match(r"([0-9a-f]+) [tTwW] (.+)$", line):
            starts.setdefault(int(symbol[1], 16), symbol[2])
    mark = next((first for first, name in starts.items() if name == MARK), None)
    if mark is None:
        sys.exit(f"{image}: it has no function {MARK}")
    # Functions written in assembly have no size, so every function extends to the next one.
    ends = [*list(starts)[1:], list(starts)[-1] + 0x1000]
    return [(first, end - first, name) for (first, name), end in zip(starts.items(), ends)], mark


def read_report(path, names):
    sections = []
    for line in path.read_text().splitlines():
        kind, count, *name = line.split(" ", 2)
        if kind == "section":
            sections.append({"instructions": int(count), "functions": {}})
        else:
            entry = sections[-1]["functions"]
            entry[name[0]] = entry.get(name[0], 0) + int(count)
    sections = sections[1:]  # the first section ends at the first mark
    if len(sections) != len(names):
        sys.exit(f"the image called {len(sections)} marks but named {len(names)} sections")
    return [{"name": name, **section} for name, section in zip(names, sections)]


def count(image, emulator, prefix="arm-none-eabi-", timeout=120, ranges=None):
    """Runs the image and returns its sections and its output. `ranges` (first address, size, name), sorted, replaces the
    functions: instructions are then counted under these names."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        of_functions, mark = functions(image, prefix)
        ranges = ranges or of_functions
        (folder / "ranges").write_text("".join(f"{first:x} {size:x} {name[:500]}\n" for first, size, name in ranges))
        plugin = f"{build_plugin()},ranges={folder}/ranges,mark={mark:x},out={folder}/report"
        done = subprocess.run([HERE / "run-firmware", "--timeout", str(timeout), "--plugin", plugin, image, "--",
                               *emulator], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"{image}:\n{done.stdout}{done.stderr}")
        names = re.findall(r"^section: (.+)$", done.stdout, re.MULTILINE)
        return read_report(folder / "report", names), done.stdout


def absolute(image, symbol, prefix):
    """The address of an absolute symbol."""
    symbols = subprocess.run([prefix + "nm", image], check=True, capture_output=True, text=True).stdout
    return "0x" + re.search(rf"^([0-9a-f]+) A {symbol}$", symbols, re.MULTILINE)[1]


def loaded_at(image, symbol, path, prefix="arm-none-eabi-"):
    """The emulator's arguments that load a file into memory where the image has an absolute symbol."""
    return ["-device", f"loader,file={path},addr={absolute(image, symbol, prefix)},force-raw=on"]


def word_at(image, symbol, value, prefix="arm-none-eabi-"):
    """The same for a word of 32 bits."""
    return ["-device", f"loader,addr={absolute(image, symbol, prefix)},data={value},data-len=4"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--prefix", default="arm-none-eabi-", help="prefix of the binutils for the image")
    parser.add_argument("image")
    parser.add_argument("emulator", nargs="+")
    arguments = parser.parse_args()
    sections, _ = count(arguments.image, arguments.emulator, arguments.prefix)
    json.dump(sections, sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    main()
