#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Usage: options_have_effect.py ARCSPAN

Every option of `arcspan render`, with every kind of shading and with what may hide it, changes the picture, or ends with an
error or a warning that names it. An option of the command that this file does not know fails, too.
"""
import concurrent.futures
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

arcspan = str(pathlib.Path(sys.argv[1]).resolve())
folder = pathlib.Path(tempfile.mkdtemp(prefix="options"))

# An open bowl, of which the inside is seen too, before a square, with vertex colours or without; and a picture.
def bowl(name, colours):
    text = "" if colours else "mtllib grey.mtl\nusemtl grey\n"
    rings, sides = 4, 8
    import math
    for r in range(1, rings + 1):
        for s in range(sides):
            a, b = math.pi / 2 * r / rings, 2 * math.pi * s / sides
            x, y, z = math.sin(a) * math.cos(b), math.cos(a), math.sin(a) * math.sin(b)
            text += f"v {x:.5f} {y:.5f} {z:.5f}" + (f" {s / sides:.3f} {r / rings:.3f} 0.5" if colours else "") + "\n"
            text += f"vn {x:.5f} {y:.5f} {z:.5f}\nvt {s / sides:.3f} {r / rings:.3f}\n"
    index = lambda r, s: (r - 1) * sides + s % sides + 1
    for r in range(1, rings):
        for s in range(sides):
            quad = [index(r, s), index(r, s + 1), index(r + 1, s + 1), index(r + 1, s)]
            text += "f " + " ".join(f"{i}/{i}/{i}" for i in quad) + "\n"
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        text += f"v {x} {y} -1.2" + (f" 0.{3 + x} 0.{3 + y} 0.1" if colours else "") + f"\nvn {x / 9} 0 1\nvt {x} {y}\n"
    text += "f -4/-4/-4 -3/-3/-3 -2/-2/-2 -1/-1/-1\n"
    (folder / name).write_text(text)

bowl("grey.obj", False)
bowl("coloured.obj", True)
(folder / "grey.mtl").write_text("newmtl grey\nKd 0.6 0.6 0.5\n")
picture = bytes((x * 37 + y * 11 + c * 80) % 256 for y in range(16) for x in range(16) for c in range(3))
(folder / "picture.ppm").write_bytes(b"P6\n16 16\n255\n" + picture)

VIEW = ("--size 64x48", "--eye 1,1.5,3", "--light 1,0.2,0.3")  # unless an option replaces them
SETTINGS = {  # option: arguments that differ from the default, and what they need
    "--size": "--size 65x48", "--format": "--format gray8", "--dither": "--no-dither", "--background": "--background 0.5,0,0",
    "--no-depth": "--no-depth", "--polynomial": "--polynomial printed-quadratic", "--segment": "--segment 4",
    "--tolerance": "--tolerance 64", "--illumination": "--illumination phong", "--colour": "--colour 0.1,0.9,0.2",
    "--ambient": "--ambient 0.5", "--diffuse": "--diffuse 0.3", "--specular": "--specular 1,0,0", "--shininess": "--shininess 3",
    "--crease": "--crease 5", "--texture": "--texture picture.ppm", "--vertex-colours": "--vertex-colours",
    "--alpha": "--alpha 0.4", "--blend": "--alpha 0.9 --blend add", "--fog": "--fog 2,4", "--matcap": "--matcap picture.ppm",
    "--highlight-fade": "--highlight-fade 0.9", "--two-sided": "--two-sided", "--light": "--light 0,1,0#1,0,0",
    "--attenuation": "--attenuation 3", "--eye": "--eye 1,1,4", "--target": "--target 0.2,0.2,0", "--up": "--up 1,1,0",
    "--fov": "--fov 70", "--shading": "", "--smooth": "--no-smooth", "--ink": "--ink 0.9,0.1,0.1:2",
    "--ink-creases": "--ink-creases", "--toon": "--toon 3", "--curved-outlines": "--curved-outlines", "--samples": "--samples 2",
    "--pose": "--pose walk@1", "--clips": "--clips",
}
NEUTRAL = {"--band"}  # changes no pixel, which other tests prove
OUTPUT = {"--output", "--stats", "--help"}
SHADINGS = ("flat", "gouraud", "arc", "segment", "dichotomy", "phong")
CONTEXTS = [(f"grey.obj --shading {s}", s) for s in SHADINGS] + [
    ("coloured.obj", "default"), ("coloured.obj --shading flat", "flat"), ("coloured.obj --shading arc", "arc"),
    ("grey.obj --matcap picture.ppm", "matcap"), ("grey.obj --texture picture.ppm", "texture")]
# A triangle has one colour by flat shading; vertex colours are the default where no shading is chosen; the texels of an
# environment map are stored as 5-6-5 colours. By flat and arc each colour is a part, and borders
# of parts stay straight.
WITHOUT_EFFECT = {("--vertex-colours", "coloured.obj --shading flat"), ("--vertex-colours", "grey.obj --shading flat"),
                  ("--vertex-colours", "coloured.obj"), ("--dither", "grey.obj --matcap picture.ppm"),
                  ("--curved-outlines", "coloured.obj --shading flat"), ("--curved-outlines", "coloured.obj --shading arc")}


def run(arguments):
    out = folder / f"{abs(hash(arguments))}.ppm"
    view = " ".join(v for v in VIEW if v.split()[0] not in arguments and not ("matcap" in arguments and "light" in v))
    done = subprocess.run([arcspan, "render", *arguments.split(), *view.split(), "-o", out.name], capture_output=True, text=True,
                          cwd=folder)
    return done.returncode, done.stderr, out.read_bytes() if done.returncode == 0 else b""


def check(case):
    option, context, base = case
    status, messages, shown = run(f"{context} {SETTINGS[option]}")
    named = any(o.replace("--no-", "--") in messages for o in SETTINGS[option].split() if o.startswith("--"))
    if status != 0:
        return None if named and messages.count("\n") == 1 else f"{context} {SETTINGS[option]}: {messages.strip()}"
    if shown == base and not named:
        return f"{context} {SETTINGS[option]}: has no effect"
    return None


# Of other commands: arguments, and the option that the error has to name.
REFUSED = [
    ("turntable grey.obj -o turn.gif --pictures ppm", "--pictures"), ("turntable grey.obj -o turn/ --fps 9", "--fps"),
    ("simulate grey.obj -o a.png --i2c-khz 100", "--i2c-khz"), ("simulate grey.obj -o a.png --panel ili9341 --charge-pump", "--charge-pump"),
    ("simulate grey.obj -o a.png --panel ssd1306 --bus i2c --spi-mhz 9", "--spi-mhz"),
    ("simulate grey.obj -o a.png --shading flat --tolerance 9", "--tolerance"),
    ("mesh grey.obj -o a.bin --name bowl", "--name"), ("mesh grey.obj -o a.hpp --texture-size 16", "--texture-size"),
    ("mesh grey.obj -o a.hpp --texture-levels 2", "--texture-levels"), ("mesh grey.obj -o a.hpp --texture-format pal4", "--texture-format"),
    ("mesh grey.obj -o a.hpp --texture picture.ppm --no-textures", "--texture"), ("texture picture.ppm -o a.bin --name bowl", "--name"),
    ("mesh grey.obj -o a.bin --clip-tolerance 1,0.1", "--clip-tolerance"), ("mesh grey.obj -o a.bin --error-pixels 100", "--error-pixels"),
    ("mesh grey.obj -o a.bin --toon 3", "--toon"), ("mesh grey.obj -o a.bin --pose rest", "--pose"), ("turntable grey.obj -o a.gif --clip walk", "--clip"),
    ("mesh grey.obj -o a.bin --size 99x99", "--size"), ("mesh grey.obj -o a.bin --cpu-mhz 9", "--cpu-mhz"),
    ("turntable grey.obj -o a.gif --clip walk --pose rest", "--clip"), ("simulate grey.obj -o a.png --clip walk", "--clip"),
    ("simulate grey.obj -o a.gif --turntable 4 --clip walk --planes", "--planes"),
    ("compare grey.obj -o a.png --shading flat,arc --segment 3", "--segment"),
    ("compare grey.obj -o a.png --shading phong --tolerance 3", "--tolerance"),
    ("compare grey.obj -o a.png --shading phong --polynomial root", "--polynomial"),
]


def check_refused(case):
    arguments, option = case
    done = subprocess.run([arcspan, *arguments.split()], capture_output=True, text=True, cwd=folder)
    if any(option in line for line in done.stderr.splitlines()) and done.stderr.count("\n") <= 2:
        return None
    return f"{arguments}: {done.returncode} {done.stderr.strip()}"


help_text = subprocess.run([arcspan, "render", "--help"], capture_output=True, text=True).stdout
options = set(re.findall(r"^\s+(?:-\w,)?(--[\w-]+)", help_text, re.MULTILINE))
known = {"--depth" if o == "--no-depth" else o for o in SETTINGS} | NEUTRAL | OUTPUT
wrong = [f"{o}: this test does not know it" for o in sorted(options - known)]
with concurrent.futures.ThreadPoolExecutor(2) as pool:
    bases = dict(zip((c for c, _ in CONTEXTS), pool.map(lambda c: run(c[0]), CONTEXTS)))
    wrong += [f"{c}: {b[1]}" for c, b in bases.items() if b[0] != 0]
    cases = [(o, c, bases[c][2]) for c, _ in CONTEXTS for o in SETTINGS
             if SETTINGS[o] and o not in c and (o, c) not in WITHOUT_EFFECT]
    wrong += [w for w in pool.map(check, cases) if w]
    wrong += [w for w in pool.map(check_refused, REFUSED) if w]
shutil.rmtree(folder)
print("\n".join(wrong) or f"{len(cases) + len(REFUSED)} options have an effect or say that they have none")
sys.exit(bool(wrong))
