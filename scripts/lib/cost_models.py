# SPDX-License-Identifier: MIT
"""The real models that scripts/firmware-costs draws, each as large as PIXELS in a picture of 240x240. Bunny and teapot are those of
scripts/fetch-meshes, the others of the Debian package assimp-testmodels. Models that are not there are left out."""

import math
import pathlib
import struct
import subprocess
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
SYSTEM = pathlib.Path("/usr/share/assimp/models")
PICTURE = 240
BUNNY, TEAPOT = (ROOT / f"build/meshes/{name}.obj" for name in ("bunny", "teapot"))
DUCK, WUSON = SYSTEM / "Collada/duck.dae", SYSTEM / "OBJ/WusonOBJ.obj"
MODELS = {  # by name: file, pixels of its larger extent, options of `arcspan mesh`
    "bunny": (BUNNY, 216, ("--crease", "180")), "bunny, 900 triangles": (BUNNY, 216, ("--crease", "180", "--max-triangles", "900")),
    "teapot": (TEAPOT, 216, ("--crease", "180")),
    "duck": (DUCK, 216, ("--no-textures",)), "wuson": (WUSON, 216, ()), "duck, 60 pixels": (DUCK, 60, ("--no-textures",))}
# The product of cost_textures.cpp, with its texture.
TEXTURED_MODEL = {"product": (DUCK, 216, ("--max-triangles", "970", "--texture-format", "rgb565", "--texture-levels", "all"))}
DISTANCE = 4  # of the eye, in radii of the model


def mesh_of(written):
    """The mesh binary in what the command wrote: that itself, or one made of the mesh of a model binary of one part."""
    begin = written.index(b"ARCM")
    size, = struct.unpack_from("<I", written, begin + 8)
    if begin != 0:  # chunks have no checksum
        chunk = bytearray(written[begin:begin + size])
        size += 4
        struct.pack_into("<I", chunk, 8, size)
        return bytes(chunk) + struct.pack("<I", zlib.crc32(chunk)) + bytes(-size % 4)
    return written[begin:begin + size] + bytes(-size % 4)


def positions(binary):
    """The positions of a mesh binary (docs/mesh-binary.md)."""
    vertices, = struct.unpack_from("<I", binary, 12)
    return [struct.unpack_from("<3h", binary, 32 + 6 * i) for i in range(vertices)]


def rotated(v):
    """By stage_rotation() of tests/frames/stage_set.hpp: 25 degrees about x, then 15 about z."""
    def turned(a, b, turn):
        angle = turn * 2 * math.pi / 65536
        return math.cos(angle) * a - math.sin(angle) * b, math.sin(angle) * a + math.cos(angle) * b

    y, z = turned(v[1], v[2], 4551)
    return *turned(v[0], y, 2731), z


def camera(binary, pixels):
    """Translation, focal length, near and far plane by which the model fills `pixels` pixels in the middle of the picture."""
    points = [rotated(p) for p in positions(binary)]
    middle = [(min(axis) + max(axis)) / 2 for axis in zip(*points)]
    radius = max(math.dist(p, middle) for p in points)
    x, y, z, focal = -middle[0], -middle[1], -middle[2] - DISTANCE * radius, 500.0
    for _ in range(40):
        across = [focal * (p[0] + x) / -(p[2] + z) for p in points]
        up = [focal * (p[1] + y) / -(p[2] + z) for p in points]
        x -= (max(across) + min(across)) / 2 * DISTANCE * radius / focal
        y -= (max(up) + min(up)) / 2 * DISTANCE * radius / focal
        focal *= pixels / max(max(across) - min(across), max(up) - min(up))
    planes = (0.99 * (DISTANCE - 1) * radius, 1.01 * (DISTANCE + 1) * radius)
    return [round(256 * v) for v in (x, y, z)], round(2048 * focal), *(round(256 * v) for v in planes)


def records(arcspan, folder, models=MODELS):
    """The names of the models that are there, and what the emulator loads: tests/firmware/cost_record.hpp. Compiles them into
    `folder` by the command `arcspan`. A record has the mesh of a model, or all of it if that has a texture."""
    names, data = [], b""
    for number, (name, (file, pixels, options)) in enumerate(models.items()):
        if not file.exists():
            continue
        compiled = pathlib.Path(folder, f"{number}.bin")
        subprocess.run([arcspan, "mesh", file, "--planes", *options, "-o", compiled], check=True, capture_output=True)
        written = compiled.read_bytes()
        binary = mesh_of(written)
        translation, focal, near, far = camera(binary, pixels)
        if models is TEXTURED_MODEL:
            binary = written + bytes(-len(written) % 4)
        data += struct.pack("<24sI8i", name.encode(), len(binary), PICTURE, PICTURE, *translation, focal, near, far) + binary
        names.append(name)
    return names, data + bytes(64)
