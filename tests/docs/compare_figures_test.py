#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests of compare_figures.py."""

import pathlib
import subprocess
import sys
import tempfile

COMPARE = pathlib.Path(__file__).resolve().parent / "compare_figures.py"
PAGE = "# Page\n\nAt 300 pixels.\n\n| method | cost | ns |\n|---|---|---|\n| arc | 1,000 (1.0e-04) | 5.00 |\n\n## End\n\n0.33 of 7\n"


def accepts(page, printed, *options):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in (("page", page), ("printed", printed)):
            pathlib.Path(folder, name).write_text(text, encoding="utf-8")
        done = subprocess.run([sys.executable, COMPARE, *options, f"{folder}/page", "cat", f"{folder}/printed"],
                              capture_output=True)
        return done.returncode == 0


def main():
    assert accepts(PAGE, PAGE)
    assert accepts(PAGE, PAGE.replace("1,000", "1,019").replace("5.00", "untimed"))
    assert accepts(PAGE, PAGE.replace("0.33", "0.34"))  # rounding
    for old, new in (("1,000", "1,021"), ("1,000", "979"), ("1.0e-04", "1.2e-04"), ("5.00", "5.20"), ("0.33", "0.35"),
                     ("of 7", "of 8"), ("arc", "arcs"), ("300", "310"), ("## End\n", ""), ("| 5.00 |", "|")):
        assert not accepts(PAGE, PAGE.replace(old, new)), (old, new)
    assert not accepts(PAGE, PAGE + "More.\n")
    end = PAGE[PAGE.index("## End"):]
    assert accepts(PAGE, end, "--from", "## End")
    assert not accepts(PAGE, end.replace("0.33", "0.40"), "--from", "## End")
    assert not accepts(PAGE, end, "--from", "## Other")
    compiled = PAGE + "Compiled by gcc 12.\n"
    assert not accepts(compiled, compiled.replace("1,000", "2,000"))
    assert accepts(compiled, compiled.replace("1,000", "2,000").replace("gcc 12", "gcc 13"))
    print("compare_figures.py is right")


if __name__ == "__main__":
    main()
