#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""extract.py PAGE FOLDER: writes every fenced block of a page whose first line names a file, in a comment of the
block's language (`// file: NAME`, `# file: NAME`, `/* file: NAME */`), to FOLDER/NAME, and prints the names of those
written. A C++ block that names no file is an error: it would be compiled by nobody. A file whose content is the same
is not touched."""

import pathlib
import re
import sys

FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.M | re.S)
NAME = re.compile(r"^(?://|#|/\*) file: (\S+)")


def main():
    page, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    text = page.read_text(encoding="utf-8")
    written = []
    for block in FENCE.finditer(text):
        language, body = block.groups()
        named = NAME.match(body)
        if not named:
            if language == "cpp":
                line = text.count("\n", 0, block.start()) + 1
                sys.exit(f"{page.name}: line {line}: a C++ block must begin with `// file: NAME`")
            continue
        target = folder / named[1]
        target.parent.mkdir(parents=True, exist_ok=True)
        if not target.exists() or target.read_text(encoding="utf-8") != body:
            target.write_text(body, encoding="utf-8")
        written.append(named[1])
    if not written:
        sys.exit(f"{page.name}: no block names a file")
    print("\n".join(written))


if __name__ == "__main__":
    main()
