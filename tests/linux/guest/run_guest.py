# SPDX-License-Identifier: MIT
"""Boots Debian's kernel in QEMU with programs and scenarios, and passes if all scenarios do.

Shots of the display are taken by QEMU, that is from outside of the guest. The scenario `show` names them; they are
compared with each other, and with pictures that `arcspan render` draws of the same scene on this machine.
"""
import argparse
import json
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import threading

HERE = pathlib.Path(__file__).resolve().parent
VESA_640X480 = {16: "0x311", 24: "0x312", 32: "0x342"}
LIMIT_SECONDS = 300


def libraries(program):
    """The shared libraries of a program, as paths."""
    out = subprocess.run(["ldd", program], check=True, capture_output=True, text=True).stdout
    words = [word for line in out.splitlines() for word in line.split()]
    return [word for word in words if word.startswith("/")]


def make_initrd(arguments, work):
    """The guest's files, as the archive that the kernel unpacks."""
    root = work / "root"
    shutil.rmtree(root, ignore_errors=True)
    for folder in ("bin", "modules", "programs", "models", "scenarios"):
        (root / folder).mkdir(parents=True)
    shutil.copy("/bin/busybox", root / "bin")
    shutil.copy(HERE / "init", root / "init")
    for scenario in arguments.scenario:
        shutil.copy(HERE / "scenarios" / scenario, root / "scenarios")
    for module in (arguments.prepared / "modules").iterdir():
        shutil.copy(module, root / "modules")
    for program in arguments.program:
        shutil.copy(program, root / "programs")
        for library in libraries(program):
            target = root / library.lstrip("/")
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(library, target)
    for model in arguments.model:
        shutil.copy(model, root / "models")
    files = "\n".join(str(path.relative_to(root)) for path in sorted(root.rglob("*")))
    initrd = work / "initrd"
    with open(initrd, "wb") as out:
        subprocess.run(["busybox", "cpio", "-o", "-H", "newc"], input=files.encode(), stdout=out,
                       stderr=subprocess.DEVNULL, cwd=root, check=True)
    shutil.rmtree(root)
    return initrd


class Monitor:
    """QEMU's control socket (QMP)."""

    def __init__(self, path):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.connect(str(path))
        self.stream = self.socket.makefile("rw")
        self.stream.readline()
        self.command("qmp_capabilities")

    def command(self, name, **parameters):
        self.stream.write(json.dumps({"execute": name, "arguments": parameters}) + "\n")
        self.stream.flush()
        while True:
            answer = json.loads(self.stream.readline())
            if "error" in answer:
                raise RuntimeError(f"{name}: {answer['error']}")
            if "return" in answer:
                return


def start_guest(arguments, initrd, control):
    display, vga = [], ""
    if arguments.vga:
        bits, card = arguments.vga
        display, vga = ["-vga", card], f" vga={VESA_640X480[int(bits)]}"
    # Libraries that use AVX because the processor has it take a fifth longer when it is emulated.
    return subprocess.Popen(
        ["qemu-system-x86_64", "-accel", "tcg", "-cpu", "Nehalem", "-M", "pc", "-m", "512", "-nodefaults", *display,
         "-display", "none", "-monitor", "none", "-serial", "stdio", "-no-reboot",
         "-qmp", f"unix:{control},server=on,wait=off", "-kernel", str(arguments.prepared / "kernel"),
         "-initrd", str(initrd), "-append",
         # On a busy host ticks come too late for the kernel's check of the timer, which then panics. Isolated page
         # tables are slow to emulate, and QEMU translates a program again whenever it starts at another address.
         "console=ttyS0 quiet panic=-1 consoleblank=0 no_timer_check mitigations=off norandmaps cryptomgr.notests "
         f"GUEST_GPIOD={arguments.gpiod}{vga}"],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, errors="replace")


def run(arguments, work):
    """Returns the status of the scenarios, None if they did not end, and the shots by name."""
    folder = tempfile.TemporaryDirectory()  # the path of a socket has to be short
    control = pathlib.Path(folder.name) / "control"
    guest = start_guest(arguments, make_initrd(arguments, work), control)
    watchdog = threading.Timer(LIMIT_SECONDS, guest.kill)
    watchdog.start()
    shots = {}
    status = None
    monitor = None
    try:
        for line in guest.stdout:
            print("  ", line.rstrip(), flush=True)
            if line.startswith("guest: shot "):
                monitor = monitor or Monitor(control)
                name = line.split()[2]
                path = work / f"{name}.ppm"
                monitor.command("screendump", filename=str(path))
                shots[name] = path.read_bytes()
                guest.stdin.write("\n")
                guest.stdin.flush()
            elif line.startswith("guest: exit "):
                status = int(line.split()[2])
        guest.wait()
    finally:
        watchdog.cancel()
        guest.kill()
        guest.wait()
    return status, shots


def read_ppm(data):
    """Width, height and bytes of a picture."""
    width, height = (int(word) for word in data.split(maxsplit=3)[1:3])
    return width, height, data[len(data) - 3 * width * height:]


def in_middle(picture, width, height):
    """The bytes of a picture of this size, with `picture` in its middle and black around it."""
    inner_width, inner_height, pixels = read_ppm(picture)
    left, top = (width - inner_width) // 2, (height - inner_height) // 2
    rows = [bytes(3 * width)] * height
    for y in range(inner_height):
        row = pixels[3 * inner_width * y:3 * inner_width * (y + 1)]
        rows[top + y] = bytes(3 * left) + row + bytes(3 * (width - inner_width - left))
    return b"".join(rows)


def render(arguments, work, model, size, format_name):
    """The picture of a model, as a file's bytes."""
    path = work / "expected.ppm"
    subprocess.run([arguments.program[0], "render", model, "--size", size, "--format", format_name, "-o", path], check=True,
                   stdout=subprocess.DEVNULL)
    return path.read_bytes()


def check_picture(arguments, work, shot, format_name):
    """Whether the shot is the picture that fills the display."""
    width, height, pixels = read_ppm(shot)
    return pixels == read_ppm(render(arguments, work, "sphere:16x8", f"{width}x{height}", format_name))[2]


def check_small(arguments, work, shot, format_name):
    """Whether the shot is the small picture in the middle of the display."""
    width, height, pixels = read_ppm(shot)
    return pixels == in_middle(render(arguments, work, "torus:12x8", "160x120", format_name), width, height)


def check_turn(arguments, work, shot, format_name):
    """Whether the shot is one of the pictures of the turn, except its first."""
    pictures = turn(arguments, work, shot, format_name)
    return read_ppm(shot)[2] in pictures[1:] and read_ppm(shot)[2] != pictures[0]


def turn(arguments, work, shot, format_name):
    """The pictures of a turn in the middle of the display."""
    width, height, _ = read_ppm(shot)
    folder = work / "turn"
    shutil.rmtree(folder, ignore_errors=True)
    subprocess.run([arguments.program[0], "turntable", "torus:12x8", "--frames", "7", "--size", "160x120", "--format",
                    format_name, "--pictures", "ppm", "-o", f"{folder}/"], check=True, stdout=subprocess.DEVNULL)
    return [in_middle(path.read_bytes(), width, height) for path in sorted(folder.iterdir())]


def check_shots(arguments, work, shots):
    """What is wrong with the shots of the scenario `show`."""
    wrong = []
    bits, card = arguments.vga
    firmware_format = "rgb565" if bits == "16" else "rgb888"
    card_format = "rgb565" if card == "cirrus" else "rgb888"
    for name, format_name, check in (("fb_picture", firmware_format, check_picture),
                                     ("fb_small", firmware_format, check_small),
                                     ("card_picture", card_format, check_picture),
                                     ("card_small", card_format, check_small),
                                     ("card_turn", card_format, check_turn),
                                     ("card_no_flips", card_format, check_turn)):
        if not check(arguments, work, shots[name], format_name):
            wrong.append(f"the display differs from the picture: {work}/{name}.ppm")
    for prefix in ("fb", "card"):
        before = shots[f"{prefix}_before"]
        if len(set(before)) < 3:
            wrong.append(f"there was no text before: {work}/{prefix}_before.ppm")
        if shots[f"{prefix}_typed"] == before:
            wrong.append(f"the console does not draw any more: {work}/{prefix}_typed.ppm")
        for name in ("after", "after_all", "after_time", "after_failure") if card == "std" else ("after",):
            if shots[f"{prefix}_{name}"] != before:
                wrong.append(f"the display is not as it was before: {work}/{prefix}_{name}.ppm")
    if shots["card_after_faults"] != shots["card_typed"]:
        wrong.append(f"the display is not as it was before: {work}/card_after_faults.ppm")
    if shots["other_before"] != shots["other_after"] or read_ppm(shots["other_after"])[:2] != (640, 480):
        wrong.append(f"another program's picture is not as it was before: {work}/other_after.ppm")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--prepared", type=pathlib.Path, required=True, help="what scripts/linux-guest made")
    parser.add_argument("--work", type=pathlib.Path, required=True, help="folder for what is made here")
    parser.add_argument("--scenario", required=True, nargs="+", help="of the folder scenarios, run in the order of their names")
    parser.add_argument("--program", required=True, nargs="+", help="what the scenarios run")
    parser.add_argument("--model", default=[], nargs="+", help="files that are put into the guest's folder /models")
    parser.add_argument("--vga", nargs=2, metavar=("BITS", "CARD"),
                        help="bits per pixel of the firmware's mode, and QEMU's name of the graphics card")
    parser.add_argument("--gpiod", default="1", help="major version of libgpiod that the program must have")
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    status, shots = run(arguments, arguments.work)
    if status is None:
        sys.exit("the guest did not end")
    wrong = check_shots(arguments, arguments.work, shots) if status == 0 and arguments.scenario == ["show"] else []
    sys.exit("\n".join(wrong) or status)


main()
