# SPDX-License-Identifier: MIT
"""Runs board_frame on an emulated Arm board with Debian's kernel, and looks at the pins from outside.

QEMU traces every change of the PL061's outputs. From clock, data, chip select and D/C the bytes are decoded as a panel
would; they have to be those that the same program wrote to a file on this machine.
"""
import argparse
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
SCK, MOSI, CS, DC, RESET, BACKLIGHT = range(6)
LIMIT_SECONDS = 90


def tool(*words, **options):
    return subprocess.run([str(word) for word in words], check=True, capture_output=True, text=True, **options).stdout


def make_device_tree(work):
    """The machine's device tree with the board's wiring."""
    tool("qemu-system-arm", "-M", f"virt,highmem=off,dumpdtb={work}/virt.dtb", "-m", "256")
    handle = int(tool("fdtget", "-t", "u", f"{work}/virt.dtb", "/pl061@9030000", "phandle"))
    overlay = (HERE / "board.dtso").read_text().replace("<PL061", f"<{handle}")
    tool("dtc", "-q", "-I", "dts", "-O", "dtb", "-o", f"{work}/board.dtbo", "-", input=overlay)
    tool("fdtoverlay", "-i", f"{work}/virt.dtb", "-o", f"{work}/board.dtb", f"{work}/board.dtbo")
    return work / "board.dtb"


def make_initrd(program, work):
    root = work / "root"
    root.mkdir(exist_ok=True)
    (root / "init").write_bytes(program.read_bytes())
    (root / "init").chmod(0o755)
    initrd = work / "initrd"
    with open(initrd, "wb") as out:
        subprocess.run(["busybox", "cpio", "-o", "-H", "newc"], input=b"init\n", stdout=out, stderr=subprocess.DEVNULL,
                       cwd=root, check=True)
    return initrd


def decode(trace):
    """The words on the bus (D/C << 8 | byte), and the levels that reset and backlight took, in order."""
    level = [0] * 8
    words, history = [], {RESET: [], BACKLIGHT: []}
    bits = count = 0
    for line in trace:
        match = re.search(r"setting output (\d+) to (\d)", line)
        if not match:
            continue
        pin, value = int(match[1]), int(match[2])
        changed, level[pin] = level[pin] != value, value
        if changed and pin in history:
            history[pin].append(value)
        if changed and pin == CS:
            bits = count = 0
        if changed and pin == SCK and value == 1 and level[CS] == 0:
            bits, count = bits << 1 | level[MOSI], count + 1
            if count == 8:
                words.append(level[DC] << 8 | bits)
                bits = count = 0
    return words, history


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kernel", type=pathlib.Path, required=True)
    parser.add_argument("--program", type=pathlib.Path, required=True, help="board_frame for Arm")
    parser.add_argument("--host-program", type=pathlib.Path, required=True, help="board_frame for this machine")
    parser.add_argument("--work", type=pathlib.Path, required=True, help="folder for what is made here")
    arguments = parser.parse_args()
    work = arguments.work.resolve()
    work.mkdir(parents=True, exist_ok=True)
    tool(arguments.host_program, work / "expected")
    raw = (work / "expected").read_bytes()
    expected = [raw[i] | raw[i + 1] << 8 for i in range(0, len(raw), 2)]
    guest = subprocess.run(
        ["qemu-system-arm", "-M", "virt,highmem=off", "-m", "256", "-dtb", make_device_tree(work), "-display", "none",
         "-monitor", "none", "-serial", "stdio", "-no-reboot", "-kernel", arguments.kernel, "-initrd",
         make_initrd(arguments.program, work), "-append", "console=ttyAMA0 quiet panic=-1 cryptomgr.notests", "-trace",
         "pl061_set_output", "-D", work / "trace"],
        stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace", timeout=LIMIT_SECONDS)
    print(guest.stdout)
    if "guest: exit 0" not in guest.stdout:
        sys.exit("the program failed")
    with open(work / "trace", errors="replace") as trace:
        words, history = decode(trace)
    same = sum(a == b for a, b in zip(words, expected))
    print(f"{len(words)} bytes on the wires, {same} of {len(expected)} as expected")
    print(f"reset {history[RESET]}, backlight {history[BACKLIGHT]}")
    if words != expected or len(expected) < 12000:
        sys.exit("the wires carry something else")
    if history[RESET] != [1, 0, 1] or history[BACKLIGHT] != [1, 0]:
        sys.exit("reset or backlight were not driven as they have to be")


main()
