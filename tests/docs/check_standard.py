#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_standard.py COMPILER TREE: including a header of the library without C++20 must say so in its first error."""

import concurrent.futures
import os
import pathlib
import subprocess
import sys


def first_error(compiler, tree, header):
    done = subprocess.run([compiler, "-std=c++17", "-E", "-Wfatal-errors", "-x", "c++", f"-I{tree}/pipeline", f"-I{tree}/hal", "-"],
                          input=f"#include <{header}>\n", capture_output=True, text=True)
    return next((line for line in done.stderr.splitlines() if "error" in line), "no error")


def main():
    compiler, tree = sys.argv[1], pathlib.Path(sys.argv[2])
    headers = [h.relative_to(tree / part) for part in ("pipeline", "hal") for h in sorted((tree / part).rglob("*.hpp"))]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        errors = list(pool.map(lambda header: first_error(compiler, tree, header), headers))
    wrong = [f"{header}: {error}" for header, error in zip(headers, errors) if "arcspan needs C++20" not in error]
    print("\n".join(wrong) or f"{len(headers)} headers say it")
    sys.exit(1 if wrong or not headers else 0)


if __name__ == "__main__":
    main()
