# SPDX-License-Identifier: MIT
"""The random scenes in which scripts/firmware-costs compares methods, and the laws that it looks for: spheres of all finenesses at
the same random places in the same random light."""

import itertools
import math
import random
import struct

from cost_scenes import CLASSIC

PLACES, CHECKED_PLACES, SEED = 200, 36, 1  # the test command measures the first ones only
# Segments and rings. Within a triangle of the first two normals are 41 and 31 degrees apart, of the others 28 degrees and less.
FINENESSES = ((12, 6), (16, 8), (18, 9), (24, 12), (32, 16), (48, 24), (64, 32))
BEYOND_30 = 2
SHININESS = (4, 8, 16, 32, 64)
SIDES = {"none": (0, 0), "left": (-1, 0), "right": (1, 0), "top": (0, 1), "bottom": (0, -1)}
WIDTH, HEIGHT, FOCAL = 320, 240, 300  # pixels
SPHERE_RADIUS = 16384 << 8  # kRadius of tests/frames/integer_shapes.hpp as an ObjectLength


def places(count):
    """The first `count` places: radius in pixels, exponent, border of the picture on which the sphere's middle lies, turns and
    directions of the lights."""
    draw = random.Random(SEED).random
    return [{"radius": 8 + int(103 * draw()), "exponent": SHININESS[i % 5],
             "border": list(SIDES)[1 + i // 4 % 4] if i % 4 == 3 else "none",
             "turns": [int(65536 * draw()) for _ in range(3)], "lights": [direction(draw) for _ in range(2)]}
            for i in range(count)]


def direction(draw):
    """A vector in view space, towards any point of a sphere with the same probability."""
    while True:
        vector = [int(2001 * draw()) - 1000 for _ in range(3)]
        if 500 ** 2 <= sum(c * c for c in vector) <= 1000 ** 2:
            return vector


def record(place, segments, rings):
    """A RandomScene of tests/firmware/random_scene.hpp."""
    # At this distance in the middle of the picture the silhouette has that radius.
    distance = round(SPHERE_RADIUS * math.hypot(1, FOCAL / place["radius"]))
    x, y = SIDES[place["border"]]
    return struct.pack("<18i", segments, rings, place["exponent"], *place["turns"], x * distance * WIDTH // (2 * FOCAL),
                       y * distance * HEIGHT // (2 * FOCAL), -distance, distance - 2 * SPHERE_RADIUS, distance + 2 * SPHERE_RADIUS,
                       FOCAL << 11, *place["lights"][0], *place["lights"][1])


def records(count):
    """What the emulator loads: the first `count` places with the coarsest sphere, then with the next one, and an end."""
    return b"".join(record(place, *fineness) for fineness in FINENESSES for place in places(count)) + bytes(4)


def comparisons(costs):
    """By law a list of (quotient, fineness, place); the law is broken if the quotient is above 1. `costs` has the instructions by
    method, fineness and place."""
    found = {}
    for fineness, place in itertools.product(range(len(FINENESSES)), range(len(costs["arc"][0]))):
        cost = {method: by_fineness[fineness][place] for method, by_fineness in costs.items()}
        quotients = {"adaptive costs at most 1 % more than arc": cost["adaptive"] / (1.01 * cost["arc"])}
        for method in ("arc", "adaptive"):
            quotients[f"{method} costs no more than the faster classic Phong"] = cost[method] / min(cost[classic] for classic in CLASSIC)
            if finer := [spheres[place] for spheres in costs[method][fineness + 1:]]:
                apart = "over 30 degrees" if fineness < BEYOND_30 else "at most 30 degrees"
                quotients[f"{method}: a coarser sphere costs no more, normals {apart} apart"] = cost[method] / min(finer)
        for law, quotient in quotients.items():
            found.setdefault(law, []).append((quotient, fineness, place))
    return found


def laws(costs):
    """By law the number of comparisons, the number of those that keep it, and the largest quotient."""
    return {law: {"pairs": len(compared), "kept": sum(quotient <= 1 for quotient, *_ in compared), "worst": round(max(compared)[0], 3)}
            for law, compared in sorted(comparisons(costs).items())}


def broken(costs, most=3):
    """Lines about the scenes that break each law most."""
    for law, compared in sorted(comparisons(costs).items()):
        for quotient, fineness, place in sorted(compared, reverse=True)[:most]:
            if quotient > 1:
                about = ", ".join(f"{key} {value}" for key, value in places(place + 1)[place].items())
                yield f"{law}: {quotient:.3f}, sphere {'x'.join(map(str, FINENESSES[fineness]))}, {about}"
