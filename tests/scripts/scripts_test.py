# SPDX-License-Identifier: MIT
"""Arguments of scripts, what they leave behind, and paths with blanks."""
import importlib.machinery
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parents[2] / "scripts"


def run(name, *arguments, folder, **environment):
    return subprocess.run([SCRIPTS / name, *arguments], cwd=folder, env=os.environ | environment, capture_output=True, text=True)


def load(name):
    sys.dont_write_bytecode = True
    loader = importlib.machinery.SourceFileLoader(name.replace("-", "_"), str(SCRIPTS / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


class Scripts(unittest.TestCase):
    def test_arguments_that_a_script_does_not_know_are_mistakes(self):
        for name, *arguments in (("fetch-meshes", "a", "b"), ("fetch-meshes", "--help"), ("linux-guest", "--help"),
                                 ("check-layers", "--bogus")):
            with self.subTest(name=name, arguments=arguments), tempfile.TemporaryDirectory() as folder:
                done = run(name, *arguments, folder=folder)
                self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
                self.assertIn("usage: ", done.stderr)

    def test_meshes_that_cannot_be_fetched_leave_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            top = pathlib.Path(folder)
            (top / "bin").mkdir()
            (top / "temporary").mkdir()
            npm = top / "bin/npm"  # what it fetches has another checksum
            npm.write_text("#!/bin/sh\necho x >bunny-1.0.1.tgz\n")
            npm.chmod(0o755)
            done = run("fetch-meshes", "a folder", folder=top, PATH=f"{top}/bin:{os.environ['PATH']}",
                       TMPDIR=str(top / "temporary"))
            self.assertNotEqual(done.returncode, 0)
            self.assertEqual(list((top / "temporary").iterdir()), [])
            self.assertEqual(list((top / "a folder").iterdir()), [])

    def test_headers_of_a_tree_with_a_blank_in_its_path_are_counted(self):
        house_size = load("house-size")
        rule = "x.o: /usr/include/stdc-predef.h \\\n /a\\ b/x.hpp /a\\ b/y$$1.hpp \\\n  z.hpp\n"
        self.assertEqual([str(file) for file in house_size.prerequisites(rule)],
                         ["/usr/include/stdc-predef.h", "/a b/x.hpp", "/a b/y$1.hpp", "z.hpp"])
        with tempfile.TemporaryDirectory() as folder:
            spaced = pathlib.Path(folder) / "arc span"
            spaced.symlink_to(SCRIPTS.parent)
            self.assertEqual(dict(house_size.headers(spaced)), dict(house_size.headers(SCRIPTS.parent)))

    def test_a_tree_below_a_folder_called_sim_is_checked(self):
        check_objects = load("check-objects")
        check_objects.Object = lambda path, prefix: path
        with tempfile.TemporaryDirectory() as folder:
            tree = pathlib.Path(folder) / "sim/build"
            for name in ("hal/panel.o", "hal/sim/model.o"):
                (tree / name).parent.mkdir(parents=True, exist_ok=True)
                (tree / name).touch()
            self.assertEqual(check_objects.objects_of(tree, "hal/**/*", ""), [tree / "hal/panel.o"])

    def test_a_tree_below_a_folder_called_scene_is_counted(self):
        with tempfile.TemporaryDirectory() as folder:
            top = pathlib.Path(folder) / "scene"
            top.mkdir()
            (top / "arcspan").symlink_to(SCRIPTS.parent)
            subprocess.run(["cmake", "-S", top / "arcspan", "-B", top / "build", "-DARCSPAN_TESTS=OFF"], check=True,
                           stdout=subprocess.DEVNULL)
            sources = (top / "build/tools/counted/pipeline.cpp").read_text()
            self.assertIn("/vertex/back_faces.cpp", sources)
            self.assertNotIn("/scene/scene_frame.cpp", sources)


unittest.main()
