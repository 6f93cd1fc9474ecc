# SPDX-License-Identifier: MIT
"""The pages that are made from docs/costs.json: docs/costs.md, the counted part of docs/where-instructions-go.md and the table in
README.md."""

import math
import pathlib
import re
import sys
import textwrap

from cost_scenes import (BANDS, CLASSIC, EXTREMES, FEW, FINE_ONLY, HEADLINE, LAWS, LINES, OTHER, OWN_SINK, RADII,
                         RISCV, SPHERES, TARGETS, TEXTURED)
from random_scenes import FINENESSES, PLACES

ROOT = pathlib.Path(__file__).resolve().parents[2]
WHERE = "docs/where-instructions-go.md"
FRAMES, CYCLES = 30, 1.5  # for the clock that a core needs: frames per second, assumed cycles per instruction


def table(head, rows):
    return [f"| {' | '.join(head)} |", "|" + "---|" * len(head), *(f"| {' | '.join(map(str, row))} |" for row in rows), ""]


def clock(scene):
    """The clock in MHz at which a core draws and clears this scene FRAMES times per second."""
    return math.ceil((scene["draw"] + scene["clear"]) * FRAMES * CYCLES / 1e6)


def prose(text):
    """A paragraph in lines of at most 120 columns."""
    return [*textwrap.wrap(text, 120, break_long_words=False, break_on_hyphens=False), ""]


def markdown(costs):
    frames, marginal = costs["frames"], costs["marginal"]
    lines = ["<!-- Written by scripts/firmware-costs. -->", "# What it costs", ""]
    lines += prose("Use this page to estimate how long your scene takes on a small core, and how much flash and RAM a whole program "
                   "needs. Where the instructions of a frame go is in [where-instructions-go.md](where-instructions-go.md).")
    lines += prose("All figures are instructions, counted exactly in an emulator: gcc 12, -O2 and the flags of `cmake/toolchains/`. The "
                   "scene is that of `tests/frames/stage_set.hpp`: a sphere with a radius of R pixels, 320×240, rgb565, 16-bit depth, one "
                   "light, ambient + diffuse + white specular (R·V)¹⁶. The mesh has planes ([decision 14](decisions/0014-planes.md)) and "
                   "the call a vertex cache of 28 bytes per vertex (flat 10, Gouraud 24). Making the transform and the illumination is not "
                   "included, nor is clearing. Each method is measured by a program of its own, which calls `draw_mesh()` in one place "
                   "with one method and one sink, as a product does. The methods are described in "
                   "[the pipeline](pipeline.md#the-methods-of-the-literature).")
    lines += ["## Drawing a frame", "", "The benchmark frame is the sphere of 32×16, R = 72:", ""]
    lines += table(["method", *(title for *_, title in TARGETS)],
                   [[method, *(f"{frames[preset][method][HEADLINE]['draw']:,}" for preset, *_ in TARGETS)]
                    for method in frames[TARGETS[0][0]] if not method.endswith(OWN_SINK)])
    lines += prose("Clearing colours and depths of the whole frame: "
                   + ", ".join(f"{title} {frames[preset]['flat'][HEADLINE]['clear']:,}" for preset, _, title in TARGETS) + ".")
    lines += prose(f"The clock, in MHz, at which a core draws and clears that frame {FRAMES} times per second, if an instruction takes "
                   f"{CYCLES} cycles:")
    lines += table(["method", *(title for *_, title in TARGETS)],
                   [[method, *(clock(frames[preset][method][HEADLINE]) for preset, *_ in TARGETS)]
                    for method in FEW])
    lines += ["### The whole benchmark frame", ""]
    lines += prose("*Set-up* is what a program does that makes everything anew for a frame: rotation, transform, illumination and the "
                   "tables of the method. A [scene](decisions/0024-scenes.md) keeps its materials and sets directions only, which "
                   "takes about 2,300 instructions per object instead on a Cortex-M3 (20 spheres below).")
    targets = [*((preset, title) for preset, _, title in TARGETS), RISCV]
    lines += table(["core, method", "set-up", "clear", "draw", "together"],
                   [[f"{title}, {method}", *(f"{scene[part]:,}" for part in parts), f"{sum(scene[part] for part in parts):,}"]
                    for preset, title in targets for method in FEW
                    for parts in [("set_up", "clear", "draw")] for scene in [frames[preset][method][HEADLINE]]])
    for preset, _, title in TARGETS:
        lines += [f"### {title}, every sphere", ""]
        lines += table(["method, sphere", *(f"R = {radius}" for radius in RADII)],
                       [[f"{method}, {sphere}", *(f"{scenes[f'{sphere} {radius}']['draw']:,}" for radius in RADII)]
                        for method, scenes in frames[preset].items() if not method.endswith(OWN_SINK)
                        for sphere in SPHERES])
    lines += ["### Extreme spheres", ""]
    lines += prose("; ".join(f"{name.replace(' ', ', R = ')}: {about}" for name, about in EXTREMES.items()) + ".")
    lines += table(["method", *(f"{title}, {name}" for *_, title in TARGETS[:2] for name in EXTREMES)],
                   [[method, *(f"{frames[preset][method][name]['draw']:,}" for preset, *_ in TARGETS[:2] for name in EXTREMES)]
                    for method in (*FEW, *CLASSIC)])
    preset, title = RISCV
    lines += [f"### {title}", ""]
    lines += prose("Counted on QEMU's `virt` machine, for cores like those of the ESP32-C3 and C6.")
    names = list(frames[preset][FEW[0]])
    lines += table(["sphere", *frames[preset]],
                   [[name.replace(" ", ", R = "), *(f"{scenes[name]['draw']:,}" for scenes in frames[preset].values())]
                    for name in names])
    lines += prose(f"Clearing takes {frames[preset]['flat'][HEADLINE]['clear']:,}.")
    lines += ["### Other light, several objects, -Os", ""]
    lines += prose("Grey lights share a ramp ([decision 28](decisions/0028-several-grey-lights.md)); two of them have 0.7 and 0.5 of the "
                   "strength of one. Materials and lights that are constants are prepared by the compiler, so that a scene costs only what "
                   "directions need ([decision 24](decisions/0024-scenes.md)). An illumination that is made at run "
                   "time takes what the row below its frame says. Clearing is not included.")
    lines += table(["", *(f"{title}, {method}" for _, title in targets for method in ("arc", "adaptive"))],
                   [[about, *(f"{costs['others'][preset][method][f'{program.format(method)} {section}']:,}"
                              for preset, _ in targets for method in ("arc", "adaptive"))]
                    for (program, section), about in OTHER.items()])
    lines += prose(f"The benchmark frame by programs compiled with -Os, {TARGETS[0][2]}: "
                   + ", ".join(f"{method} {count:,}" for method, count in costs["others"]["-Os"].items()) + ".")
    lines += ["### Stack", ""]
    lines += prose("The deepest stack of a `draw_mesh` call in bytes, in the worst of the spheres above. Only triangles "
                   "that the near plane or the guard band cuts use the most.")
    lines += table(["method", *(title for *_, title in TARGETS), RISCV[1]],
                   [[method, *(f"{max(s['stack'] for s in frames[preset][method].values()):,}" if method in frames[preset] else ""
                               for preset in (*(preset for preset, *_ in TARGETS), RISCV[0]))]
                    for method in frames[TARGETS[0][0]] if not method.endswith(OWN_SINK)])
    lines += ["### Laws", ""]
    spheres = ", ".join(f"{segments}×{rings}" for segments, rings in FINENESSES)
    lines += prose("Three laws should hold. Adaptive costs at most 1 % more than arc. A coarser mesh of the same sphere costs no more "
                   "while the normals within its triangles are at most 30° apart. Neither arc nor adaptive costs more than the faster of "
                   f"the two classic Phong methods. They are tested in {PLACES * len(FINENESSES):,} random scenes: spheres of {spheres} "
                   f"at {PLACES} places, with a radius of 8 to 110 pixels, any orientation, a light in any direction and an exponent n of "
                   "4, 8, 16, 32 or 64. At a quarter of the places half of the sphere is outside of the picture. The highlight is "
                   "(R·V)ⁿ or (N·H)ⁿ; two lights are grey.")
    lines += prose("Each cell has the number of comparisons that break the law and, in brackets, the largest quotient of a cost and its "
                   "bound, above 1 if the law is broken. A coarser sphere is compared with the cheapest of all finer ones. Normals are "
                   "over 30° apart in triangles of 12×6 (41°) and 16×8 (31°), which the law does not cover.")
    found = costs["laws"]
    lines += table(["law", "comparisons", *(f"broken (worst): {LAWS[key]}" for key in found)],
                   [[law, f"{one['pairs']:,}", *(f"{of[law]['pairs'] - of[law]['kept']} ({of[law]['worst']})" for of in found.values())]
                    for law, one in next(iter(found.values())).items()])
    lines += ["### Into a sink of your own", ""]
    lines += prose("The figures above are for `hal::Framebuffer`, whose rows lie in memory and which says so (`SinkInMemory` of "
                   "`pixel/sink.hpp`). For a sink that has only `open()` and `close()` the pipeline calls both for every row, and gcc "
                   "gives out the registers of rows and pixels differently. The table of marginal costs shows which of them differ.")
    lines += table(["benchmark frame", *(title for *_, title in TARGETS)],
                   [[method, *(f"{own['draw']:,} ({100 * (own['draw'] / frames[preset][method][HEADLINE]['draw'] - 1):+.1f} %)"
                               for preset, *_ in TARGETS for own in [frames[preset][method + OWN_SINK][HEADLINE]])]
                    for method in ("arc", "adaptive")])
    lines += ["### In bands", ""]
    lines += prose("The benchmark frame in bands of 24 rows, clearing included, and in brackets the multiple of the whole frame with a "
                   "vertex cache. A triangle has 9 rows on average and is prepared again in each band that it reaches. What the "
                   "caches keep is in [bands.md](bands.md#what-is-kept-from-band-to-band).")
    lines += table(["benchmark frame", *(f"{title}, {method}" for *_, title in TARGETS for method in ("arc", "adaptive"))],
                   [[about, *(f"{one[section]:,} ({one[section] / one['whole, cache']:.2f})" for preset, *_ in TARGETS
                              for one in costs["bands"][preset].values())] for section, about in BANDS.items()])
    lines += ["### Textures", ""]
    lines += prose("The benchmark frame with a texture of 128×128 in 16 bits, nearest texels, and everything per pixel of a square of "
                   "200×200 pixels: facing the camera, and turned so that one side is twice as far away as the other, where u and v "
                   "are corrected for perspective.")
    lines += table(["light", *(f"{title}, {section}" for *_, title in TARGETS for section in ("frame", "square", "turned square"))],
                   [[about, *(f"{figure:,}" for preset, *_ in TARGETS for figure in costs["textures"][preset][light].values())]
                    for light, about in TEXTURED.items()])
    lines += ["### Lines", ""]
    lines += prose("Lines, points and billboards of one colour or with a texture, with depth test, and in brackets a pixel of each with "
                   "its share of rows. A "
                   "line includes both its vertices. The wireframe is the benchmark frame by `Wireframe<>`.")
    lines += table(["", *(title for *_, title in TARGETS)],
                   [[about, *(f"{one['each']} ({one['pixel']})" for preset, *_ in TARGETS for one in [costs["lines"][preset][kind]])]
                    for kind, (about, *_) in LINES.items()]
                   + [["wireframe", *(f"{costs['lines'][preset]['wireframe']:,}" for preset, *_ in TARGETS)]])
    lines += ["## Marginal costs", ""]
    lines += prose("To estimate a scene: triangles × *triangle* + rows of all triangles × *span* + pixels × *pixel*. A triangle is a "
                   "visible one and includes its share of vertices and of culled neighbours; *without planes* is for meshes that have "
                   "none. *Vertex* is one transformation, measured by drawing no triangles. All are counted by address in the "
                   "benchmark frame. The last column is the largest error of such an estimate among the nine scenes, for "
                   f"{', '.join(FINE_ONLY)} among the six of the finer spheres: normals of the coarsest are more than 16° "
                   "apart, where a triangle and a row cost more.")
    lines += table(["target, method", "vertex", "triangle", "without planes", "span", "pixel", "worst estimate"],
                   [[f"{title}, {method}", f["vertex"], f["triangle"], f["triangle_without_planes"], f["span"], f["pixel"],
                     f"{f['worst_estimate_percent']} %"]
                    for preset, _, title in TARGETS for method, f in marginal[preset].items()])
    lines += ["## Whole programs", ""]
    lines += prose("The 32×16 sphere in flash (10,580 bytes), arc shading, one light, board layer and mesh included. The stack is its "
                   "deepest use, measured.")
    about = {
        "minimal": "`examples/minimal.cpp`: set up at run time; 128×64 in 16 grey levels (4,096 bytes), no depth.",
        "smallest": "`examples/smallest.cpp`: mesh, camera and light are constants; clipping, back faces, vertex cache, planes and "
                    "the loop for whole rows are left out ([how](memory.md#less-flash)); 32×32 in 5-6-5 with depth (4,096 bytes for both).",
        "scene": "`examples/scene.cpp`: a torus and a cube with two materials under two lights, drawn in bands on an ILI9341; 24 KB of "
                 "code at most.",
    }
    for program, boards in costs["programs"].items():
        lines += prose(about[program])
        lines += table(["board", "flash", "of which code", "data + bss", "stack", "RAM in all"],
                       [[board, *(f"{m[k]:,}" for k in ("flash", "code", "data_and_bss", "stack", "ram"))]
                        for board, m in boards.items()])
    return "\n".join(lines).rstrip("\n") + "\n"


def instructions_page(costs):
    """docs/where-instructions-go.md with its counted part replaced."""
    frame = costs["frames"][TARGETS[0][0]]["flat"][HEADLINE]
    rows, pixels = frame["spans"], frame["pixels"]
    amount = {"pixel": pixels, "row": rows, "triangle": frame["triangles"]}
    lines = prose(f"The frame is a sphere of 32 × 16 with a radius of 72 pixels: {frame['vertices']} vertices, {frame['triangles']} "
                  f"visible triangles, {rows:,} rows with pixels ({pixels / rows:.1f} each), {pixels:,} pixels.")
    for preset, _, title in TARGETS:
        lines += [f"## {title}", ""]
        lines += table(["method", "all", "pixels", "rows", "triangles", "vertices", "back faces", *(f"per {part}" for part in amount)],
                       [[method, f"{frame['draw']:,}", *(f"{counted:,} ({100 * counted / frame['draw']:.0f} %)" for counted in parts.values()),
                         *(f"{parts[part] / number:.1f}" for part, number in amount.items())]
                        for method in FEW for parts in [costs["parts"][preset][method]]
                        for frame in [costs["frames"][preset][method][HEADLINE]]])
    text = (ROOT / WHERE).read_text()
    begin, end = "<!-- written by scripts/firmware-costs -->\n", "<!-- end -->\n"
    if text.count(begin) != 1 or text.count(end) < 1:
        sys.exit(f"{WHERE} has no place for the counted figures")
    head, rest = text.split(begin)
    return head + begin + "\n" + "\n".join(lines) + "\n" + rest[rest.index(end):]


def readme(costs):
    """README.md with the figures of its cost table replaced: instructions and clock of the first two targets."""
    text = (ROOT / "README.md").read_text()
    for row, method in ((r"\| flat ", "flat"), (r"\| Gouraud ", "gouraud"), (r"\| \*\*arc[^|]*", "arc"),
                        (r"\| \*\*adaptive[^|]*", "adaptive")):
        bold = "**" if method in ("arc", "adaptive") else ""
        scenes = [costs["frames"][preset][method][HEADLINE] for preset, *_ in TARGETS[:2]]
        cells = " | ".join(f"{bold}{scene['draw']:,}{bold} | {clock(scene)} MHz" for scene in scenes)
        text, found = re.subn(rf"^({row})(?:\|[^|]+){{4}}\|$", rf"\1| {cells} |", text, flags=re.MULTILINE)
        if found != 1:
            sys.exit(f"README.md: {found} rows of its cost table are '{row}'")
    return text


def pages(costs):
    """The pages that are made from the figures: text by file name."""
    return {"docs/costs.md": markdown(costs), WHERE: instructions_page(costs), "README.md": readme(costs)}
