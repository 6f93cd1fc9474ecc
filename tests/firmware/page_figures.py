# SPDX-License-Identifier: MIT
"""Figures that a page of docs/ states in its text."""

import pathlib
import re

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs"
TOLERANCE = 0.02


def check(page, pattern, *measured):
    """Each # of `pattern`, words of the page, stands for a number that must be within 2 % of the one measured."""
    text = " ".join((DOCS / page).read_text(encoding="utf-8").split())
    stated = re.search(re.escape(pattern).replace(r"\#", r"([\d,]+)"), text)
    assert stated, f"docs/{page} has no words like: {pattern}"
    numbers = [int(number.replace(",", "")) for number in stated.groups()]
    assert len(numbers) == len(measured)
    for number, found in zip(numbers, measured):
        assert abs(number - found) <= TOLERANCE * found, f"docs/{page} states {number:,}, measured: {found:,}"
