# SPDX-License-Identifier: MIT
"""What scripts/firmware-costs measures: targets, methods and scenes, under the names that the programs print and
docs/costs.json has."""

TARGETS = [  # preset, machine, title
    ("mps2-an385", "mps2-an385", "Cortex-M3"),
    ("mps2-an385-armv6m", "mps2-an385", "Armv6-M code"),
    ("mps2-an386", "mps2-an386", "Cortex-M4F, FPU off"),
]
HEADLINE = "32x16 72"
SPHERES = (HEADLINE, "8x4 110", "8x4 1400", "16x8 12", "64x32 20")  # of cost_stage.hpp
OWN_SINK = "-own-sink"  # ends the names of programs that draw into a sink of their own
CLASSIC = ("phong", "phong-reciprocal")  # the two classic Phong methods
RISCV = ("riscv-virt", "RV32IMAC")  # preset, title; only the frames of few methods are measured
FEW = ("flat", "gouraud", "arc-0", "arc")  # methods for products; the last is what tools and scenes use by default
ARCS = FEW[2:]  # exact, and with a tolerance of one step of 255
NAMES = {"flat": "flat", "gouraud": "Gouraud", "arc-0": "arc, tolerance 0", "arc": "arc, tolerance 1"}  # on pages
BANDS = {"whole, cache": "whole frame, vertex cache", "whole, no cache": "whole frame, no cache",  # sections of cost_bands.hpp
         "bands, cache": "bands, vertex cache", "bands, no cache": "bands, no cache",
         "bands, kept": "bands, `VertexCache`", "bands, kept with rows": "bands, `VertexCache` with rows"}
TEXTURED = {"unlit": "none", "flat": "`Flat`", "greygouraud": "`GreyGouraud`", "arc": "`Arc`"}  # cost_textures.cpp, by light
TEXTURED_SCENES = ("character", "product", "room", "dashboard")  # its sections of whole pictures
OPERATIONS = {"plain": "none", "alpha-1": "masked by a bit of alpha", "screen-door": "`ScreenDoor`, half of the pixels",  # cost_operations.cpp
              "opacity": "`Opacity`", "add": "`Opacity<Blend::kAdd>`", "multiply": "`Opacity<Blend::kMultiply>`",
              "alpha-4": "`Opacity` by 4 bits of alpha", "fog": "`Fogged`", "bilinear": "none, bilinear texels"}
LINES = {"level": ("line, level", "short", "long"), "flat": ("line, wider than high", "short", "long"),  # of cost_lines.cpp
         "tall": ("line, higher than wide", "short", "long"), "points": ("point", "small", "large"),
         "sprites": ("billboard", "small", "large")}
OTHER = {  # of cost_light.hpp, cost_scene.cpp and cost_character.hpp, by program and section
    ("{}-blinn-1", "draw"): "benchmark frame, (N·H)¹⁶ instead of (R·V)¹⁶", ("{}-blinn-1", "make"): "its illumination",
    ("{}-phong-2", "draw"): "benchmark frame, two lights", ("{}-phong-2", "make"): "its illumination",
    ("scene-{}", "draw twenty"): "20 spheres of 16×8 with 20 materials", ("scene-{}", "prepare twenty"): "preparing them",
    ("scene-{}", "bands"): "scene of its sphere in bands of 24 rows, with vertices", ("scene-{}", "bands, rows"): "with rows of triangles, too",
    ("scene-{}", "bands, rows only"): "with rows, without vertices",
    ("{}", "draw character"): "figure of 4,620 small triangles without planes (`tests/frames/figure.hpp`)"}
