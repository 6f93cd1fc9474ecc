#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks linked images by the rules of scripts/check-objects, libgcc's part of them included.

    image_test.py PREFIX IMAGE...                  no floating point, allocation, exceptions, RTTI or libc in them
    image_test.py PREFIX --span IMAGE              the same, and nothing that the span stage reaches divides or copies
    image_test.py PREFIX --span --rejects IMAGE    the span stage must be found to divide
"""

import argparse
import importlib.machinery
import importlib.util
import pathlib
import re
import sys

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts/check-objects"
sys.dont_write_bytecode = True
loader = importlib.machinery.SourceFileLoader("check_objects", str(SCRIPT))
rules = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
loader.exec_module(rules)

# What platform/bare and libgcc define on purpose.
OWN = re.compile(r"mem(cpy|set|move|cmp)|__aeabi_mem\w+|__cxa_pure_virtual|exit")


def breaches(image, prefix):
    """Every forbidden thing in an image: (rule, what)."""
    for symbol in sorted(image.defined):
        rule = rules.classify(symbol)
        if rule != "undefined" and not OWN.fullmatch(symbol):
            yield rule, f"holds {symbol}"
    for section, size in image.sections.items():
        if size and re.match(r"\.(gcc_except_table|ARM\.ex|eh_frame|init_array|exceptions)", section):
            yield "exceptions", f"has {size} bytes of {section}"
    if prefix in rules.FLOAT_INSTRUCTION:
        for rule, _, what in rules.check_float(image, "", rules.FLOAT_INSTRUCTION[prefix], None):
            yield rule, what


# Other instructions name functions too in a linked image, where a constant happens to be an address.
JUMP = re.compile(r"c?\.?[bj]\w*|r?call|r?jmp")


def span_breaches(image):
    for name, body in image.functions.items():
        image.functions[name] = [(i, operands, to if JUMP.fullmatch(i) else set()) for i, operands, to in body]
    reached = rules.span_closure([image])
    if not any(rules.SPAN_ENTRY.match(name) for name in reached):
        yield "division", "no span stage found: nothing was proved"
    for name, (_, body) in reached.items():
        divides = rules.DIVISION.fullmatch(name) or re.fullmatch(r"__u?divmod[hqsd]i4|__udivmod64", name)
        if divides or rules.COPY.fullmatch(name) or any(rules.DIVIDE_INSTRUCTION.match(i) for i, _, _ in body):
            yield "division" if not rules.COPY.fullmatch(name) else "span libc", f"the span stage reaches {name}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("prefix", help="of the binutils")
    parser.add_argument("--span", action="store_true")
    parser.add_argument("--rejects", action="store_true")
    parser.add_argument("images", nargs="+", type=pathlib.Path)
    arguments = parser.parse_args()
    passed = True
    for path in arguments.images:
        image = rules.Object(path, arguments.prefix)
        found = list(breaches(image, arguments.prefix)) + (list(span_breaches(image)) if arguments.span else [])
        for rule, what in found:
            print(f"{path.name}: {rule}: {what}")
        print(f"{path.name}: {len(image.functions)} functions, {len(found)} breaches")
        passed &= bool(image.functions)
        passed &= any("reaches" in what for _, what in found) if arguments.rejects else not found
    sys.exit(0 if passed else 1)


if __name__ == "__main__":
    main()
