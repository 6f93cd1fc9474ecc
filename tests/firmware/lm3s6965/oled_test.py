#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""oled_test.py FRAMES IMAGE SOURCE_DIR EMULATOR...: the emulator's display must show the host's frames, pixel by pixel.

Builds tests/frames/oled_frames.cpp for the host as FRAMES, runs IMAGE, and after each line "shown N" takes a screen
dump through QMP and compares it: 128x64 pixels, each drawn 4x4, grey level n as n * 17.
"""

import json
import os
import pathlib
import socket
import subprocess
import sys
import tempfile

WIDTH, HEIGHT, SCALE = 128, 64, 4


class Qmp:
    """The emulator's control socket."""

    def __init__(self, path):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.settimeout(30)
        self.socket.connect(path)
        self.file = self.socket.makefile("rw")
        self.file.readline()  # the greeting
        self.ask("qmp_capabilities")

    def ask(self, command, **arguments):
        self.file.write(json.dumps({"execute": command, "arguments": arguments}) + "\n")
        self.file.flush()
        while True:
            answer = json.loads(self.file.readline())
            if "error" in answer:
                sys.exit(f"{command}: {answer['error']}")
            if "return" in answer:
                return


def host_frames(program, source):
    files = [source / "tests/frames/oled_frames.cpp", *sorted((source / "pipeline").rglob("*.cpp"))]
    text = "".join(f'#include "{file}"\n' for file in files)
    subprocess.run(["g++", "-std=c++20", f"-I{source}", f"-I{source}/pipeline", f"-I{source}/hal", "-x", "c++", "-", "-o",
                    program], input=text, text=True, check=True)
    data = subprocess.run([program], check=True, capture_output=True).stdout
    size = WIDTH * HEIGHT
    return [data[i:i + size] for i in range(0, len(data), size)]


def differences(path, frame):
    magic, size, _, pixels = path.read_bytes().split(b"\n", 3)
    width, height = map(int, size.split())
    if magic != b"P6" or (width, height) != (WIDTH * SCALE, HEIGHT * SCALE):
        sys.exit(f"screen dump of {width}x{height}")
    return sum(pixels[3 * (y * width + x):][:3] != bytes([frame[y // SCALE * WIDTH + x // SCALE] * 17] * 3)
               for y in range(height) for x in range(width))


def main():
    program, image, source, *emulator = sys.argv[1:]
    frames = host_frames(program, pathlib.Path(source))
    failed = not frames
    with tempfile.TemporaryDirectory() as folder:
        control = f"{folder}/qmp"
        machine = subprocess.Popen(
            [*emulator, "-display", "none", "-monitor", "none", "-serial", "none", "-semihosting-config",
             "enable=on,target=native,chardev=console", "-chardev", "stdio,id=console,signal=off", "-qmp",
             f"unix:{control},server=on,wait=off", "-kernel", image],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=dict(os.environ, QEMU_AUDIO_DRV="none"))
        try:
            qmp = None
            for number, frame in enumerate(frames):
                line = machine.stdout.readline()
                if line != f"shown {number}\n":
                    sys.exit(f"wanted 'shown {number}', got {line!r}")
                qmp = qmp or Qmp(control)
                dump = pathlib.Path(folder) / "screen.ppm"
                qmp.ask("screendump", filename=str(dump))
                wrong = differences(dump, frame)
                levels = len(set(frame))
                print(f"frame {number}: {levels} grey levels, {wrong} of {SCALE * SCALE * len(frame)} pixels differ")
                failed |= wrong != 0 or levels < 8
                machine.stdin.write("\n")
                machine.stdin.flush()
            failed |= machine.wait(timeout=30) != 0
        finally:
            machine.kill()
            machine.wait()
    failed |= len(set(frames)) != len(frames)  # it must have turned
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
