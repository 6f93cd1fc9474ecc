#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""make_walker.py FILE.glb: writes the character of examples/walker.cpp, which stands and walks, 1.7 m high, facing +z.

examples/walker/walker.glb is made by it, and model.h from that:
    arcspan mesh examples/walker/walker.glb -o examples/walker/model.h --name walker
"""

import json
import math
import struct
import sys

JOINTS = [  # name, parent, place in the model
    ("hips", None, (0, 0.95, 0)), ("spine", 0, (0, 1.12, 0)), ("head", 1, (0, 1.46, 0)),
    ("upper arm L", 1, (0.19, 1.38, 0)), ("forearm L", 3, (0.21, 1.12, 0)),
    ("upper arm R", 1, (-0.19, 1.38, 0)), ("forearm R", 5, (-0.21, 1.12, 0)),
    ("thigh L", 0, (0.09, 0.92, 0)), ("shin L", 7, (0.10, 0.50, 0)), ("foot L", 8, (0.10, 0.09, -0.01)),
    ("thigh R", 0, (-0.09, 0.92, 0)), ("shin R", 10, (-0.10, 0.50, 0)), ("foot R", 11, (-0.10, 0.09, -0.01))]
NUMBER = {name: i for i, (name, _, _) in enumerate(JOINTS)}
WALK_KEYS, WALK_SECONDS, STAND_SECONDS = 8, 1.0, 2.0
SOLE = ((0, -0.09, 0.17), (0, -0.09, -0.07))  # toe and heel, from the ankle


class Part:
    """A mesh of one material: closed surfaces of rings."""

    def __init__(self, name, colour):
        self.name, self.colour = name, colour
        self.positions, self.weights, self.triangles = [], [], []

    def loft(self, rings, sides, axis="y"):
        """Joins rings, from the top down the axis: (x, y, z, radius across, radius in depth, {joint: weight}); of radius 0
        a single vertex."""
        begins = []
        for x, y, z, across, depth, weights in rings:
            begins.append(len(self.positions))
            for i in range(sides if across else 1):
                turn = 2 * math.pi * i / sides
                u, v = across * math.sin(turn), depth * math.cos(turn)
                self.positions.append((x + u, y, z + v) if axis == "y" else (x + u, y - v, z))
                self.weights.append(weights)
        for (upper, lower), begin, end in zip(zip(rings, rings[1:]), begins, begins[1:]):
            for i in range(sides):
                k = (i + 1) % sides
                if upper[3]:
                    self.triangles.append((begin + i, end + (i if lower[3] else 0), begin + k))
                if lower[3]:
                    self.triangles.append((begin + (k if upper[3] else 0), end + i, end + k))

    def ball(self, middle, radii, sides, rings, joint, first=0, last=1):
        """An ellipsoid, or what of it is between two shares of its height from the top."""
        x, y, z = middle
        loops = []
        for i in range(rings + 1):
            turn = math.pi * (first + (last - first) * i / rings)
            size = max(math.sin(turn), 0)
            size = 0 if size < 1e-9 else size
            loops.append((x, y + radii[1] * math.cos(turn), z, radii[0] * size, radii[2] * size, {joint: 1}))
        self.loft(loops, sides)

    def normals(self):
        sums = [[0.0] * 3 for _ in self.positions]
        for triangle in self.triangles:
            a, b, c = (self.positions[i] for i in triangle)
            u, v = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
            normal = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
            for i in triangle:
                sums[i] = [s + n for s, n in zip(sums[i], normal)]
        return [tuple(n / math.sqrt(sum(m * m for m in s)) for n in s) for s in sums]


def body():
    """The parts. Surfaces are open where another one hides their end."""
    skin, shirt = Part("skin", (0.83, 0.58, 0.44)), Part("shirt", (0.79, 0.23, 0.18))
    trousers, dark = Part("trousers", (0.20, 0.32, 0.55)), Part("hair and shoes", (0.16, 0.11, 0.09))
    skin.loft([(0, 1.52, 0.01, 0.05, 0.05, {"head": 1}), (0, 1.40, 0, 0.055, 0.055, {"spine": 1})], 8)
    skin.ball((0, 1.60, 0.01), (0.095, 0.125, 0.11), 10, 7, "head", 0.3)
    skin.ball((0, 1.585, 0.115), (0.018, 0.03, 0.025), 5, 3, "head")
    dark.ball((0, 1.625, -0.012), (0.105, 0.125, 0.112), 10, 4, "head", 0, 0.52)
    for x in (-0.038, 0.038):
        dark.ball((x, 1.612, 0.108), (0.014, 0.018, 0.012), 5, 3, "head")
    shirt.loft([(0, 1.44, 0, 0, 0, {"spine": 1}), (0, 1.425, 0, 0.085, 0.065, {"spine": 1}),
                (0, 1.385, 0, 0.17, 0.10, {"spine": 1}), (0, 1.30, 0, 0.185, 0.12, {"spine": 1}),
                (0, 1.20, 0, 0.165, 0.115, {"spine": 1}), (0, 1.10, 0, 0.15, 0.11, {"hips": 0.5, "spine": 0.5}),
                (0, 1.00, 0, 0.158, 0.115, {"hips": 0.9, "spine": 0.1}), (0, 0.93, 0, 0.17, 0.125, {"hips": 1})], 12)
    trousers.loft([(0, 0.95, 0, 0.155, 0.11, {"hips": 1}), (0, 0.90, 0, 0.15, 0.112, {"hips": 1}),
                   (0, 0.86, 0, 0.075, 0.09, {"hips": 1}), (0, 0.845, 0, 0, 0, {"hips": 1})], 12)
    for side, s in (("L", 1), ("R", -1)):
        add_arm(skin, shirt, s, f"upper arm {side}", f"forearm {side}")
        add_leg(trousers, dark, s, f"thigh {side}", f"shin {side}", f"foot {side}")
    return [skin, shirt, trousers, dark]


def add_arm(skin, shirt, s, arm, fore):
    shirt.loft([(s * 0.175, 1.425, 0, 0, 0, {arm: 1}), (s * 0.188, 1.405, 0, 0.045, 0.05, {arm: 1}),
                (s * 0.205, 1.35, 0, 0.06, 0.06, {arm: 1}), (s * 0.21, 1.20, 0, 0.055, 0.055, {arm: 1})], 8)
    skin.loft([(s * 0.21, 1.24, 0, 0.043, 0.043, {arm: 1}), (s * 0.21, 1.15, 0, 0.041, 0.041, {arm: 0.8, fore: 0.2}),
               (s * 0.21, 1.09, 0, 0.041, 0.041, {arm: 0.2, fore: 0.8}), (s * 0.212, 1.00, 0.005, 0.037, 0.037, {fore: 1}),
               (s * 0.214, 0.90, 0.01, 0.028, 0.03, {fore: 1}), (s * 0.214, 0.85, 0.012, 0.03, 0.045, {fore: 1}),
               (s * 0.212, 0.78, 0.015, 0.024, 0.04, {fore: 1}), (s * 0.21, 0.755, 0.018, 0, 0, {fore: 1})], 8)


def add_leg(trousers, shoe, s, thigh, shin, foot):
    trousers.loft([(s * 0.086, 0.93, 0, 0.084, 0.095, {"hips": 0.6, thigh: 0.4}),
                   (s * 0.088, 0.84, 0, 0.086, 0.097, {"hips": 0.2, thigh: 0.8}),
                   (s * 0.095, 0.70, 0, 0.076, 0.083, {thigh: 1}), (s * 0.10, 0.55, 0, 0.063, 0.068, {thigh: 0.8, shin: 0.2}),
                   (s * 0.10, 0.45, 0, 0.059, 0.062, {thigh: 0.2, shin: 0.8}), (s * 0.10, 0.30, -0.01, 0.056, 0.062, {shin: 1}),
                   (s * 0.10, 0.09, -0.01, 0.052, 0.058, {shin: 1})], 8)
    shoe.loft([(s * 0.10, 0.045, 0.165, 0, 0, {foot: 1}), (s * 0.10, 0.04, 0.15, 0.027, 0.025, {foot: 1}),
               (s * 0.10, 0.045, 0.10, 0.045, 0.045, {foot: 1}), (s * 0.10, 0.06, 0.03, 0.044, 0.06, {foot: 1}),
               (s * 0.10, 0.07, -0.04, 0.042, 0.07, {foot: 1}), (s * 0.10, 0.06, -0.08, 0.028, 0.045, {foot: 1}),
               (s * 0.10, 0.055, -0.09, 0, 0, {foot: 1})], 8, axis="z")


def about(axis, degrees):
    half = math.radians(degrees) / 2
    return tuple(math.sin(half) if i == axis else 0.0 for i in range(3)) + (math.cos(half),)


def product(p, q):
    (a, b, c, d), (x, y, z, w) = p, q
    return (d * x + a * w + b * z - c * y, d * y - a * z + b * w + c * x, d * z + a * y - b * x + c * w,
            d * w - a * x - b * y - c * z)


def leg(phase):
    """Degrees forward of the thigh, of the bent knee and of the toes, at a phase of the step: forward at 0, back at pi."""
    swing = max(0.0, -math.sin(phase - 0.25))
    thigh = 25 * math.cos(phase) + 4
    knee = 6 + 58 * swing ** 2
    return thigh, knee, 0.55 * (knee - thigh) - 8


def lowest(thigh, knee, toes):
    """Height of the sole's lowest point below the hip joint's height."""
    y = -0.42 * math.cos(math.radians(thigh)) - 0.41 * math.cos(math.radians(thigh - knee))
    turn = math.radians(thigh - knee + toes)
    return min(y + dy * math.cos(turn) + dz * math.sin(turn) for _, dy, dz in SOLE)


def walk():
    """Rotations by joint, and translations of the hips, at all keys."""
    turns = {name: [] for name, _, _ in JOINTS}
    places = []
    for key in range(WALK_KEYS + 1):
        phase = 2 * math.pi * (key % WALK_KEYS) / WALK_KEYS
        heights = []
        for side, shift in (("L", 0), ("R", math.pi)):
            thigh, knee, toes = leg(phase + shift)
            heights.append(lowest(thigh, knee, toes))
            for joint, degrees in ((f"thigh {side}", -thigh), (f"shin {side}", knee), (f"foot {side}", -toes)):
                turns[joint].append(about(0, degrees))
            s = 1 if side == "L" else -1
            arm = 24 * math.cos(phase + shift)
            turns[f"upper arm {side}"].append(product(about(2, 5 * s), about(0, arm)))
            turns[f"forearm {side}"].append(about(0, -24 + 12 * math.cos(phase + shift)))
        sway = math.cos(phase)
        turns["hips"].append(product(about(1, -7 * sway), about(2, 2 * math.sin(phase))))
        turns["spine"].append(product(about(1, 12 * sway), about(0, 3)))
        turns["head"].append(product(about(1, -5 * sway), about(0, -2)))
        places.append((0.012 * math.sin(phase), -min(heights) + 0.03, 0.0))
    return turns, places


def stand():
    turns = {name: [] for name, _, _ in JOINTS}
    for key in range(3):
        breath = key % 2
        for s, side in ((1, "L"), (-1, "R")):
            turns[f"upper arm {side}"].append(product(about(2, (6 + 2 * breath) * s), about(0, 3)))
            turns[f"forearm {side}"].append(about(0, -14 - 3 * breath))
        turns["spine"].append(about(0, 2 - 2 * breath))
        turns["head"].append(product(about(1, 9 - 18 * breath), about(0, -2 + 2 * breath)))
    return turns, []


class Glb:
    def __init__(self):
        self.bytes = bytearray()
        self.json = {"asset": {"version": "2.0", "generator": "make_walker.py"}, "scene": 0, "scenes": [{"nodes": [0]}],
                     "nodes": [], "meshes": [], "skins": [], "materials": [], "animations": [], "accessors": [],
                     "bufferViews": [], "buffers": [{}]}

    def accessor(self, kind, code, rows, bounds=False):
        """Adds rows of numbers of a type of struct; returns the accessor's number."""
        self.bytes += bytes(-len(self.bytes) % 4)
        flat = [value for row in rows for value in row]
        data = struct.pack(f"<{len(flat)}{code}", *flat)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data)})
        self.bytes += data
        accessor = {"bufferView": len(self.json["bufferViews"]) - 1, "componentType": {"f": 5126, "H": 5123, "B": 5121}[code],
                    "count": len(rows), "type": kind}
        if bounds:
            accessor["min"], accessor["max"] = [[round_to_float(pick(column)) for column in zip(*rows)] for pick in (min, max)]
        self.json["accessors"].append(accessor)
        return len(self.json["accessors"]) - 1

    def write(self, path):
        self.json["buffers"][0]["byteLength"] = len(self.bytes)
        text = json.dumps(self.json, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        data = bytes(self.bytes) + bytes(-len(self.bytes) % 4)
        with open(path, "wb") as file:
            file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data)))
            file.write(struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data)


def round_to_float(value):
    return struct.unpack("<f", struct.pack("<f", value))[0]


def add_nodes(glb):
    for i, (name, parent, place) in enumerate(JOINTS):
        above = JOINTS[parent][2] if parent is not None else (0, 0, 0)
        node = {"name": name, "translation": [round(a - b, 6) for a, b in zip(place, above)]}
        children = [k for k, joint in enumerate(JOINTS) if joint[1] == i]
        glb.json["nodes"].append({**node, "children": children} if children else node)
    binds = [(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -x, -y, -z, 1) for _, _, (x, y, z) in JOINTS]
    glb.json["skins"].append({"joints": list(range(len(JOINTS))), "inverseBindMatrices": glb.accessor("MAT4", "f", binds)})


def add_part(glb, part):
    """A mesh with a material and a node of its own, so that it keeps its name."""
    number = len(glb.json["meshes"])
    linear = [round(c ** 2.2, 4) for c in part.colour]
    glb.json["materials"].append({"name": part.name, "pbrMetallicRoughness": {
        "baseColorFactor": [*linear, 1], "metallicFactor": 0, "roughnessFactor": 0.55}})
    joints, weights = [], []
    for of_vertex in part.weights:
        pairs = sorted(of_vertex.items(), key=lambda pair: -pair[1]) + [("hips", 0)] * 4
        joints.append([NUMBER[name] if weight else 0 for name, weight in pairs[:4]])
        weights.append([weight for _, weight in pairs[:4]])
    attributes = {"POSITION": glb.accessor("VEC3", "f", part.positions, bounds=True),
                  "NORMAL": glb.accessor("VEC3", "f", part.normals()), "JOINTS_0": glb.accessor("VEC4", "B", joints),
                  "WEIGHTS_0": glb.accessor("VEC4", "f", weights)}
    indices = glb.accessor("SCALAR", "H", [(i,) for triangle in part.triangles for i in triangle])
    glb.json["meshes"].append({"name": part.name, "primitives": [{"attributes": attributes, "indices": indices, "material": number}]})
    glb.json["scenes"][0]["nodes"].append(len(glb.json["nodes"]))
    glb.json["nodes"].append({"name": part.name, "mesh": number, "skin": 0})


def add_clip(glb, name, seconds, turns, places):
    keys = len(turns["spine"])
    times = glb.accessor("SCALAR", "f", [(seconds * i / (keys - 1),) for i in range(keys)], bounds=True)
    clip = {"name": name, "samplers": [], "channels": []}

    def add(joint, path, values, kind):
        clip["samplers"].append({"input": times, "output": glb.accessor(kind, "f", values)})
        clip["channels"].append({"sampler": len(clip["samplers"]) - 1, "target": {"node": NUMBER[joint], "path": path}})

    for joint, values in turns.items():
        if values:
            add(joint, "rotation", values, "VEC4")
    if places:
        add("hips", "translation", places, "VEC3")
    glb.json["animations"].append(clip)


def main():
    glb = Glb()
    add_nodes(glb)
    for part in body():
        add_part(glb, part)
    add_clip(glb, "stand", STAND_SECONDS, *stand())
    add_clip(glb, "walk", WALK_SECONDS, *walk())
    glb.write(sys.argv[1])


if __name__ == "__main__":
    main()
