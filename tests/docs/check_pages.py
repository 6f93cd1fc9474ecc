#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_pages.py TREE: checks every Markdown page of the tree and prints what is wrong.

* Each relative link names a file or folder that exists, and each #anchor a heading of its page.
* Each page is reachable by links from README.md.
* No line is longer than 120 columns, except in tables and in code.
* Decisions are numbered from 1 without gaps, in the names of their files and in their titles.
"""

import pathlib
import re
import sys

COLUMNS = 120
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
FENCED = re.compile(r"^```.*?^```$", re.M | re.S)
CODE = re.compile(r"`[^`\n]+`")


def anchor(heading):
    """The anchor that GitHub gives a heading."""
    text = re.sub(r"[`*]", "", heading.strip().lower())
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def headings(page):
    text = FENCED.sub("", page.read_text(encoding="utf-8"))
    return {anchor(h) for h in re.findall(r"^#+ (.*)$", text, re.M)}


def links(page):
    """Relative links of a page, as (file, anchor)."""
    text = CODE.sub("", FENCED.sub("", page.read_text(encoding="utf-8")))
    for target in LINK.findall(text):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, fragment = target.partition("#")
        yield target, (page.parent / path).resolve() if path else page, fragment


def long_lines(page):
    fenced = False
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        fenced ^= line.startswith("```")
        if not fenced and not line.startswith(("|", "    ")) and len(line) > COLUMNS:
            yield f"line {number} has {len(line)} columns, at most {COLUMNS} are allowed"


def decisions(folder):
    for wanted, page in enumerate(sorted(folder.glob("[0-9]*.md")), 1):
        if not page.name.startswith(f"{wanted:04}-") or not page.read_text(encoding="utf-8").startswith(f"# {wanted}. "):
            yield f"{page.name}: should be decision {wanted}"
            return


def main():
    tree = pathlib.Path(sys.argv[1]).resolve()
    pages = [p for p in sorted(tree.rglob("*.md"))
             if not any(part.startswith(".") or part == "build" for part in p.relative_to(tree).parts)]
    wrong = []
    leads_to = {}
    for page in pages:
        name = str(page.relative_to(tree))
        leads_to[page] = set()
        for target, path, fragment in links(page):
            if not path.exists():
                wrong.append(f"{name}: link to {target}: no such file")
            elif fragment and path.suffix == ".md" and fragment not in headings(path):
                wrong.append(f"{name}: link to {target}: no such heading")
            else:
                leads_to[page].add(path)
        wrong += [f"{name}: {line}" for line in long_lines(page)]
    wrong += decisions(tree / "docs/decisions")
    reached = set()
    ahead = [tree / "README.md"]
    while ahead:
        page = ahead.pop()
        if page in reached:
            continue
        reached.add(page)
        ahead += leads_to.get(page, ())
    wrong += [f"{page.relative_to(tree)}: no link from README.md leads here" for page in pages if page not in reached]
    print("\n".join(wrong) or f"{len(pages)} pages are right")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
