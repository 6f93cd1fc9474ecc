#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_pages.py TREE: checks every Markdown page of the tree and prints what is wrong.

* Each relative link names a file or folder that exists, and each #anchor a heading of its page.
* Each page is reachable by links from README.md.
* No line is longer than 120 columns, except in tables and in code.
* Decisions are numbered from 1, in the names of their files and in their titles. The numbers of removed ones are in the paragraph
  "Removed: ..." of their index.
* A link whose text is a symbol, [`Type::member`](file), leads to a source file that has its words.
* The number of test cases on README.md is that of tests/, rounded down to a hundred.
* Pictures (PNG) have no alpha, by which a browser would show the page through them.
* In the table "Where to change what" of docs/README.md no cell is longer than CELL columns as it is shown: two lines.
"""

import pathlib
import re
import sys

COLUMNS = 120
CELL = 110
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
FENCED = re.compile(r"^```.*?^```$", re.M | re.S)
CODE = re.compile(r"`[^`\n]+`")
SYMBOL = re.compile(r"\[`([^`\]]+)`\]\(([^)\s#]+)\)")


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


def is_transparent(picture):
    """True if a PNG file has alpha: by its colour type, or by a chunk that gives colours alpha."""
    content = picture.read_bytes() if picture.suffix == ".png" else b""
    return b"IDAT" in content and (content[25] in (4, 6) or b"tRNS" in content[:content.index(b"IDAT")])


def long_lines(page):
    fenced = False
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        fenced ^= line.startswith("```")
        if not fenced and not line.startswith(("|", "    ")) and len(line) > COLUMNS:
            yield f"line {number} has {len(line)} columns, at most {COLUMNS} are allowed"


def decisions(folder):
    removed = re.search(r"^Removed: (.*?)(?:\n\n|\Z)", (folder / "README.md").read_text(encoding="utf-8"), re.M | re.S)
    pages = {int(page.name[:4]): page for page in sorted(folder.glob("[0-9]*.md"))}
    for number, page in pages.items():
        if not page.read_text(encoding="utf-8").startswith(f"# {number}. "):
            yield f"{page.name}: should be decision {number}"
    gone = set(map(int, re.findall(r"\d+", removed[1]))) if removed else set()
    for number in range(1, max(pages) + 1):
        if number not in pages and number not in gone:
            yield f"decisions/README.md: decision {number} is neither there nor removed"


def symbols(page):
    """Links whose text is a symbol that their file does not have. A text with a slash or a dot is a path."""
    text = FENCED.sub("", page.read_text(encoding="utf-8"))
    for symbol, target in SYMBOL.findall(text):
        path = (page.parent / target).resolve()
        if re.match(r"[a-z]+:", target) or not path.is_file() or re.search(r"[/.]", symbol) or path.suffix == ".md":
            continue
        source = path.read_text(encoding="utf-8")
        for word in re.findall(r"\w+", re.sub(r"<.*>", "", symbol)):
            if not re.search(rf"\b{word}\b", source):
                yield f"link to {target}: it has no `{symbol}`"
                break


def long_cells(page):
    """Cells of the table under the heading "Where to change what" that take more than two lines."""
    table = page.read_text(encoding="utf-8").partition("\n## Where to change what\n")[2].partition("\n## ")[0]
    for line in table.splitlines():
        for cell in line.strip("|").split("|") if line.startswith("|") else ():
            shown = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", cell).replace("`", "").strip()
            if len(shown) > CELL:
                yield f"a cell has {len(shown)} columns, at most {CELL} are allowed: {shown[:40]}..."


def test_cases(tree):
    there = sum(len(re.findall(r"^ *(?:TEMPLATE_\w*)?TEST_CASE\w*\(", source.read_text(encoding="utf-8"), re.M))
                for source in (tree / "tests").rglob("*.cpp")) // 100 * 100
    said = re.search(r"by ([\d,]+) test cases", (tree / "README.md").read_text(encoding="utf-8"))
    if not said or int(said[1].replace(",", "")) != there:
        yield f"README.md: {said[0] if said else 'no number of test cases'}, but tests/ has {there:,} or a few more"


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
                if is_transparent(path):
                    wrong.append(f"{name}: {target} has alpha")
        wrong += [f"{name}: {line}" for line in (*long_lines(page), *symbols(page))]
    wrong += test_cases(tree)
    wrong += decisions(tree / "docs/decisions")
    wrong += [f"docs/README.md: {line}" for line in long_cells(tree / "docs/README.md")]
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
