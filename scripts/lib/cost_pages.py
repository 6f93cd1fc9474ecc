# SPDX-License-Identifier: MIT
"""The tables that are made from docs/costs.json: those of docs/performance.md and README.md. Each stands between a line
`<!-- costs: NAME -->` and the next line `<!-- end -->`; NAME is a key of TABLES."""

import math
import pathlib
import re
import sys
import textwrap

from cost_scenes import (ARCS, BANDS, FEW, HEADLINE, LINES, NAMES, OPERATIONS, OTHER, RISCV, TARGETS, TEXTURED, TEXTURED_SCENES)

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = "docs/performance.md"
FRAMES, CYCLES = 30, 1.5  # for the clock that a core needs: frames per second, assumed cycles per instruction
SHOWN = [(preset, title) for preset, _, title in TARGETS[:2]]  # costs.json has more
PLACE = re.compile(r"^(<!-- costs: (\w+) -->\n).*?^(?=<!-- end -->$)", re.MULTILINE | re.DOTALL)


def table(head, rows):
    """A table whose first column is text and the others are numbers."""
    return [f"| {' | '.join(head)} |", "|---|" + "---:|" * (len(head) - 1),
            *(f"| {' | '.join(map(str, row))} |" for row in rows), ""]


def prose(text):
    """A paragraph in lines of at most 120 columns."""
    return [*textwrap.wrap(text, 120, break_long_words=False, break_on_hyphens=False), ""]


def number(figure):
    """A figure of a table, or a dash where it was not measured."""
    return "–" if figure is None else f"{figure:,}"


def clock(scene):
    """The clock in MHz at which a core draws and clears this scene FRAMES times per second."""
    return math.ceil((scene["draw"] + scene["clear"]) * FRAMES * CYCLES / 1e6)


def frame(costs):
    targets = [*SHOWN, RISCV]
    scenes = {method: [costs["frames"][preset][method][HEADLINE] for preset, _ in targets] for method in FEW}
    rows = [[NAMES[method], *(figure for scene in of for figure in (f"{scene['draw']:,}", f"{clock(scene)} MHz"))]
            for method, of in scenes.items()]
    cleared = ", ".join(f"{title} {scene['clear']:,}" for (_, title), scene in zip(targets, scenes[FEW[0]]))
    return [*table(["method", *(text for _, title in targets for text in (title, f"{FRAMES} frames/s"))], rows),
            *prose(f"Clearing colours and depths of the whole frame: {cleared}. The clock is that at which a core draws and clears "
                   f"{FRAMES} frames per second, if an instruction takes {CYCLES} cycles.")]


def models(costs):
    """Real models, if they have been measured: costs["models"][preset][method][model] are instructions of drawing."""
    measured = costs.get("models", {})
    found = [(preset, title) for preset, title in (*SHOWN, RISCV) if preset in measured]
    if not found:
        return []
    names = list(next(iter(measured[found[0][0]].values())))
    return table([f"model, {title}" for _, title in found[:1]] + [NAMES[method] for method in measured[found[0][0]]],
                 [[name, *(f"{of[name]:,}" for of in measured[found[0][0]].values())] for name in names])


def parts(costs):
    preset, _, title = TARGETS[0]
    one = costs["frames"][preset][FEW[0]][HEADLINE]
    rows, pixels = one["spans"], one["pixels"]
    head = ["method", "pixels", "rows", "triangles", "vertices", "back faces"]
    last = costs["parts"][preset][FEW[-1]]
    triangle = sum(last[part] for part in last if part not in ("pixel", "row")) / one["triangles"]
    lines = prose(f"{title}, the frame above: {one['vertices']} vertices, {one['triangles']} visible triangles, {rows:,} rows "
                  f"({pixels / rows:.1f} pixels each), {pixels:,} pixels.")
    return lines + table(head, [[NAMES[method], *(f"{100 * counted / costs['frames'][preset][method][HEADLINE]['draw']:.0f} %"
                                                  for counted in costs["parts"][preset][method].values())] for method in FEW]) + prose(
        f"By {NAMES[FEW[-1]]} a triangle takes {triangle:.0f} instructions besides its rows and pixels, as much as "
        f"{triangle / (last['pixel'] / pixels):.0f} pixels: the set-up dominates where triangles are smaller than that.")


def others(costs):
    targets = [(preset, title, method) for preset, title in SHOWN for method in ARCS]
    rows = [[about, *(number(costs["others"][preset][method].get(f"{program.format(method)} {section}")) for preset, _, method in targets)]
            for (program, section), about in OTHER.items()]
    small = ", ".join(f"{NAMES[method]} {count:,}" for method, count in costs["others"]["-Os"].items())
    return [*table(["", *(f"{title}, {NAMES[method]}" for _, title, method in targets)], rows),
            *prose(f"The frame above by programs compiled with -Os, {TARGETS[0][2]}: {small}.")]


def bands(costs):
    targets = [(preset, title, method) for preset, title in SHOWN for method in ARCS[-1:]]
    return table(["", *(f"{title}, {NAMES[method]}" for _, title, method in targets)],
                 [[about, *(f"{one[section]:,} ({one[section] / one['whole, cache']:.2f})" for preset, _, method in targets
                            for one in [costs["bands"][preset][method]])] for section, about in BANDS.items()])


def textures(costs):
    preset, title = SHOWN[0]
    small, small_title = SHOWN[1]
    sections = (*TEXTURED_SCENES, "facing", "turned")
    return table(["light", *sections, *(f"{name}, {small_title}" for name in TEXTURED_SCENES)],
                 [[about, *(f"{costs['textures'][preset][light][name]:,}" for name in sections),
                   *(f"{costs['textures'][small][light][name]:,}" for name in TEXTURED_SCENES)] for light, about in TEXTURED.items()])


def operations(costs):
    return table(["operation", *(title for _, title in SHOWN)],
                 [[about, *(f"{costs['operations'][preset][kind]}" for preset, _ in SHOWN)] for kind, about in OPERATIONS.items()])


def lines_and_points(costs):
    return table(["", *(title for _, title in SHOWN)],
                 [[about, *(f"{one['each']} ({one['pixel']})" for preset, _ in SHOWN for one in [costs["lines"][preset][kind]])]
                  for kind, (about, *_) in LINES.items()]
                 + [["wireframe", *(f"{costs['lines'][preset]['wireframe']:,}" for preset, _ in SHOWN)]])


def programs(costs):
    figures = ("flash", "code", "ram", "stack")
    return table(["program, board", "flash", "of which code", "RAM", "of which stack"],
                 [[f"{program}, {board}", *(f"{of[figure]:,}" for figure in figures)]
                  for program, boards in costs["programs"].items() for board, of in boards.items()])


def stack(costs):
    targets = [*SHOWN, RISCV]
    return table(["method", *(title for _, title in targets)],
                 [[NAMES[method], *(f"{max(scene['stack'] for scene in costs['frames'][preset][method].values()):,}"
                                    for preset, _ in targets)] for method in FEW])


TABLES = {"frame": frame, "models": models, "parts": parts, "others": others, "bands": bands,
          "textures": textures, "operations": operations, "lines": lines_and_points, "programs": programs, "stack": stack}


def filled(page, costs, wanted):
    """The text of a page with its tables replaced. Each of the names `wanted` must have one place."""
    text = (ROOT / page).read_text()
    found = [name for _, name in PLACE.findall(text)]
    if sorted(found) != sorted(wanted):
        sys.exit(f"{page}: has places for the tables {', '.join(found)}; expected are {', '.join(wanted)}")

    def replace(place):
        lines = TABLES[place[2]](costs)
        return place[1] + ("\n" + "\n".join(lines) + "\n" if lines else "")

    return PLACE.sub(replace, text)


def readme(costs):
    """README.md with its tables replaced, and with the figures of its cost table: instructions and clock of the first two targets."""
    text = filled("README.md", costs, ["models"])
    for row, method in ((r"\| flat ", FEW[0]), (r"\| Gouraud ", FEW[1]), (r"\| \*\*arc, tolerance 0[^|]*", FEW[2]), (r"\| \*\*arc, tolerance 1[^|]*", FEW[3])):
        bold = "**" if method in ARCS else ""
        scenes = [costs["frames"][preset][method][HEADLINE] for preset, _ in SHOWN]
        cells = " | ".join(f"{bold}{scene['draw']:,}{bold} | {clock(scene)} MHz" for scene in scenes)
        text, found = re.subn(rf"^({row})(?:\|[^|]+){{4}}\|$", rf"\1| {cells} |", text, flags=re.MULTILINE)
        if found != 1:
            sys.exit(f"README.md: {found} rows of its cost table are '{row}'")
    return text


def pages(costs):
    """The pages that show the figures: text by file name."""
    return {PAGE: filled(PAGE, costs, TABLES.keys() - {"models"}), "README.md": readme(costs)}
