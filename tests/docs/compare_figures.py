#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""compare_figures.py [--from HEADING] PAGE PROGRAM [ARGUMENTS...]: the program must print the page.

Texts must be equal, numbers within 2 % or, if they have a fraction, one unit of the last digit. A cell of a table that the
program prints as "untimed" is not compared. With --from the program prints the end of the page, beginning with the line
HEADING. If the page names another compiler in its line "Compiled by", nothing is compared, because instructions are counted.
"""

import argparse
import re
import subprocess
import sys

NUMBER = re.compile(r"(?<![\w.])[-−]?\d[\d,]*(?:\.\d+)?(?:e[-+]\d+)?")
TOLERANCE = 0.02


def parse(number):
    """The value of a number's text, and the unit of its last digit (0 for integers)."""
    plain = number.replace(",", "").replace("−", "-")
    mantissa, _, exponent = plain.partition("e")
    fraction = len(mantissa.partition(".")[2])
    return float(plain), 10.0 ** (int(exponent or 0) - fraction) if fraction else 0


def same_number(page, printed):
    (wanted, unit), (found, _) = parse(page), parse(printed)
    return abs(wanted - found) <= max(TOLERANCE * abs(wanted), 1.01 * unit)


def same_cell(page, printed):
    if printed.strip() == "untimed":
        return True
    wanted, found = NUMBER.findall(page), NUMBER.findall(printed)
    return (NUMBER.sub("#", page) == NUMBER.sub("#", printed) and len(wanted) == len(found) and
            all(map(same_number, wanted, found)))


def differences(page, printed):
    """The lines of two texts that differ."""
    for number in range(max(len(page), len(printed))):
        wanted = page[number] if number < len(page) else "(nothing)"
        found = printed[number] if number < len(printed) else "(nothing)"
        cells = [line.split("|") if line.startswith("|") else [line] for line in (wanted, found)]
        if len(cells[0]) != len(cells[1]) or not all(map(same_cell, *cells)):
            yield f"page:     {wanted}\nmeasured: {found}"


def compiler(lines):
    return next((line for line in lines if line.startswith("Compiled by")), None)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--from", dest="heading", help="line at which the printed part of the page begins")
    parser.add_argument("page")
    parser.add_argument("program", nargs=argparse.REMAINDER)
    arguments = parser.parse_args()
    with open(arguments.page, encoding="utf-8") as file:
        page = file.read().splitlines()
    if arguments.heading:
        if page.count(arguments.heading) != 1:
            sys.exit(f"{arguments.page}: '{arguments.heading}' must be one of its lines, once")
        page = page[page.index(arguments.heading):]
    done = subprocess.run(arguments.program, stdout=subprocess.PIPE, encoding="utf-8")
    if done.returncode != 0:
        sys.exit(f"{arguments.program[0]} ended with status {done.returncode}")
    printed = done.stdout.splitlines()
    if compiler(page) != compiler(printed):
        print(f"{arguments.page}: '{compiler(page)}', here: '{compiler(printed)}': not compared")
        return
    wrong = list(differences(page, printed))
    print("\n".join(wrong) or f"{arguments.page}: no figure differs by more than 2 %")
    if wrong:
        sys.exit(f"{len(wrong)} lines of {arguments.page} are not what is measured (scripts/update-figures writes it)")


if __name__ == "__main__":
    main()
