#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""extract.py PAGE FOLDER [LANGUAGE=NAME...]: writes code blocks of a Markdown page to files and prints their names.

Written are all fenced blocks whose first line names a file in a comment (`// file: NAME`, `# file: NAME`,
`/* file: NAME */`), and for each LANGUAGE=NAME the page's only block of that language, as NAME. A C++ block that names no
file is an error, because nobody would compile it. A file is only written if its content changes, so that nothing is built
again without need."""

import pathlib
import re
import sys

FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.M | re.S)
NAME = re.compile(r"^(?://|#|/\*) file: (\S+)")


def blocks(page):
    """Every fenced block of a page: its line, its language and its text."""
    text = page.read_text(encoding="utf-8")
    return [(text.count("\n", 0, b.start()) + 1, *b.groups()) for b in FENCE.finditer(text)]


def write(path, body):
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text(encoding="utf-8") != body:
        path.write_text(body, encoding="utf-8")


def main():
    page, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    written = []
    for line, language, body in blocks(page):
        named = NAME.match(body)
        if named:
            write(folder / named[1], body)
            written.append(named[1])
        elif language == "cpp":
            sys.exit(f"{page.name}: line {line}: a C++ block must begin with `// file: NAME`")
    for wanted in sys.argv[3:]:
        language, name = wanted.split("=")
        found = [body for _, its, body in blocks(page) if its == language]
        if len(found) != 1:
            sys.exit(f"{page.name}: {len(found)} blocks of language {language}, expected one")
        write(folder / name, found[0])
        written.append(name)
    if not written:
        sys.exit(f"{page.name}: no block names a file")
    print("\n".join(written))


if __name__ == "__main__":
    main()
