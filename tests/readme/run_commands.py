#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""run_commands.py TREE ARCSPAN PAGE...: runs every command of the pages' ```sh blocks, in their order, as printed.

The commands run in a folder whose entries are links to those of TREE, so that they see the tree but write elsewhere, with
a home of their own and the program ARCSPAN in the path. Commands of a block that begins with `# in your project` run in
a folder that holds the files of the pages' code blocks, as a reader would have saved them.

Commands of SLOW take longer than all others together. Instead of them a cheaper command runs, which fails if the script or
the target does not exist, or which compiles the library as one source without optimisation; with --slow they run, except scripts/test, which
would run this program again."""

import argparse
import os
import pathlib
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "docs"))
import extract  # noqa: E402

LIBRARY = "cmake -B build/library -DCMAKE_BUILD_TYPE=Release -DARCSPAN_TOOLS=OFF -DARCSPAN_TESTS=OFF"
SLOW = {
    "scripts/first-picture": "test -x scripts/first-picture && bash -n scripts/first-picture",
    "scripts/test": "test -x scripts/test && bash -n scripts/test",
    "cmake --build build/release --target arcspan": "cmake --build build/release --target arcspan -- -n",
    LIBRARY: LIBRARY + " -DARCSPAN_LIBRARY_UNITY=ON -DCMAKE_CXX_FLAGS_RELEASE=-O0",
}
# A reader's model: a tetrahedron.
MODEL = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"


def commands(page):
    """Every command of a page, as (line, in the reader's project, command without its comment)."""
    for line, language, body in extract.blocks(page):
        if language != "sh":
            continue
        own = body.startswith("# in your project\n")
        for number, text in enumerate(body.splitlines(), line + 1):
            command = text.split("  #")[0].strip()
            if command and not command.startswith("#"):
                yield number, own, command


def run(command, folder, environment):
    """Runs a command; returns its output if it fails, and the variables that it has set."""
    script = f"set -eu -o pipefail\n{command}\nenv -0 >&3"
    reader, writer = os.pipe()
    with os.fdopen(reader, "rb") as pipe:
        done = subprocess.Popen(["bash", "-c", f"exec 3>&{writer}\n{script}"], cwd=folder, env=environment, pass_fds=(writer,),
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        os.close(writer)
        output, _ = done.communicate()
        variables = dict(v.split("=", 1) for v in pipe.read().decode().split("\0") if v)
    return (output.decode(errors="replace"), environment) if done.returncode else (None, variables)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--slow", action="store_true", help="run the commands of SLOW too")
    parser.add_argument("tree", type=pathlib.Path)
    parser.add_argument("arcspan", type=pathlib.Path)
    parser.add_argument("pages", nargs="+")
    arguments = parser.parse_args()
    failures = 0
    count = 0
    with tempfile.TemporaryDirectory() as work:
        top = pathlib.Path(work, "arcspan")
        project = pathlib.Path(work, "project")
        home = pathlib.Path(work, "home")
        programs = pathlib.Path(work, "bin")
        for folder in (top, project, home, programs):
            folder.mkdir()
        for entry in arguments.tree.resolve().iterdir():
            if entry.name not in ("build", "out", ".git"):
                (top / entry.name).symlink_to(entry)
        (programs / "arcspan").symlink_to(arguments.arcspan.resolve())
        meshes = top / "build" / "meshes"  # where scripts/first-picture has them
        meshes.mkdir(parents=True)
        (meshes / "bunny.obj").write_text(MODEL)
        environment = dict(os.environ, HOME=str(home), PATH=f"{programs}:{os.environ['PATH']}")
        for page in arguments.pages:
            for _, _, body in extract.blocks(arguments.tree / page):
                if named := extract.NAME.match(body):
                    extract.write(project / named[1], body)
            for line, own, command in commands(arguments.tree / page):
                count += 1
                if command in SLOW and (command == "scripts/test" or not arguments.slow):
                    command = SLOW[command]
                if own and (top / "ball.hpp").exists():
                    extract.write(project / "ball.hpp", (top / "ball.hpp").read_text())
                begin = time.monotonic()
                failed, environment = run(command, project if own else top, environment)
                print(f"{time.monotonic() - begin:5.1f} s  {command}", flush=True)
                if failed is not None:
                    print(f"{page}:{line}: {command}\n{failed}")
                    failures += 1
    print(f"{count} commands, {failures} failed")
    sys.exit(1 if failures or not count else 0)


if __name__ == "__main__":
    main()
