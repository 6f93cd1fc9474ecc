# SPDX-License-Identifier: MIT
"""Boots Debian's kernel in QEMU with programs and a scenario, and passes if the scenario does.

Shots of the display are taken by QEMU, that is from outside of the guest. The scenario `show` names them; they are
compared with each other, and with what `arcspan render` on this machine makes of the same scene.
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
LIMIT_SECONDS = 150


def libraries(program):
    """The shared libraries of a program, as paths."""
    out = subprocess.run(["ldd", program], check=True, capture_output=True, text=True).stdout
    words = [word for line in out.splitlines() for word in line.split()]
    return [word for word in words if word.startswith("/")]


def make_initrd(arguments, work):
    """The guest's files, as the archive that the kernel unpacks."""
    root = work / "root"
    shutil.rmtree(root, ignore_errors=True)
    for folder in ("bin", "modules", "programs"):
        (root / folder).mkdir(parents=True)
    shutil.copy("/bin/busybox", root / "bin")
    shutil.copy(HERE / "init", root / "init")
    shutil.copy(HERE / "scenarios" / arguments.scenario, root / "scenario")
    for module in (arguments.prepared / "modules").glob("*.ko"):
        shutil.copy(module, root / "modules")
    for program in arguments.program:
        shutil.copy(program, root / "programs")
        for library in libraries(program):
            target = root / library.lstrip("/")
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(library, target)
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
    display = ["-vga", "std"] if arguments.vga else []
    vga = f" vga={VESA_640X480[arguments.vga]}" if arguments.vga else ""
    return subprocess.Popen(
        ["qemu-system-x86_64", "-accel", "tcg", "-cpu", "max", "-M", "pc", "-m", "512", "-nodefaults", *display,
         "-display", "none", "-monitor", "none", "-serial", "stdio", "-no-reboot",
         "-qmp", f"unix:{control},server=on,wait=off", "-kernel", str(arguments.prepared / "vmlinuz"),
         "-initrd", str(initrd), "-append",
         f"console=ttyS0 quiet panic=-1 consoleblank=0 GUEST_GPIOD={arguments.gpiod}{vga}"],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, errors="replace")


def run(arguments, work):
    """Returns the scenario's status, None if it did not end, and the shots by name."""
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


def check_shots(arguments, work, shots):
    """What is wrong with the shots of the scenario `show`."""
    wrong = []
    expected = work / "expected.ppm"
    pixels = "rgb565" if arguments.vga == 16 else "rgb888"
    subprocess.run([arguments.program[0], "render", "sphere:16x8", "--size", "640x480", "--format", pixels, "-o",
                    expected], check=True, stdout=subprocess.DEVNULL)
    if shots["picture"] != expected.read_bytes():
        wrong.append(f"the display differs from the picture: {work}/picture.ppm, {expected}")
    if len(set(shots["before"])) < 3:
        wrong.append("there was no text before")
    if shots["typed"] == shots["before"]:
        wrong.append("the console does not draw any more")
    for name in ("after", "after_all", "after_time", "after_failure"):
        if shots[name] != shots["before"]:
            wrong.append(f"the display is not as it was before: {work}/{name}.ppm")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--prepared", type=pathlib.Path, required=True, help="what scripts/linux-guest made")
    parser.add_argument("--work", type=pathlib.Path, required=True, help="folder for what is made here")
    parser.add_argument("--scenario", required=True)
    parser.add_argument("--program", required=True, nargs="+", help="what the scenario runs")
    parser.add_argument("--vga", type=int, choices=sorted(VESA_640X480), help="bits a pixel of the display")
    parser.add_argument("--gpiod", default="1", help="major version of libgpiod that the program must have")
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    status, shots = run(arguments, arguments.work)
    if status is None:
        sys.exit("the guest did not end")
    wrong = check_shots(arguments, arguments.work, shots) if status == 0 and arguments.scenario == "show" else []
    sys.exit("\n".join(wrong) or status)


main()
