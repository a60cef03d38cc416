# SPDX-License-Identifier: GPL-3.0-or-later
"""./run before it builds anything: without Python; options that are refused or taken; filter scripts that are completed."""
import shutil

from harness import *

from product.command import parse
from product.meshlabserver import complete

PICTURE = ("--picture", "picture.png")


class Options(ScriptTest):
    def expect_refused(self, regex, *words):
        environment = {**os.environ, "DISPLAY": "", "LAPLACIAN_LINES_BUILD": str(self.work / "build")}
        done = subprocess.run([CHECKOUT / "run", *words], stderr=subprocess.PIPE, env=environment)
        said = os.fsdecode(done.stderr)
        self.assertTrue(done.returncode == 1 and re.search(f"^laplacian-lines: {regex}", said, re.M),
                        f"{words}: {done.returncode}, {said}")
        self.assertFalse(os.path.exists("build"), f"built in spite of {words}")

    def test_without_python(self):
        """It is installed, or it is said how."""
        os.mkdir("tools")
        for tool in ("sh", "readlink", "env", "id"):
            os.symlink(shutil.which(tool), f"tools/{tool}")
        for install, code, words in (("false", 1, "as root, run: apt-get install python3"),
                                     (f"/bin/ln -sf {sys.executable} {self.work}/tools/python3", 0, "--picture FILE.png")):
            for tool in ("apt-get", "sudo"):
                pathlib.Path("tools", tool).write_text(f'#!/bin/sh\ncase "$*" in *install*python3*) {install};; esac\n')
                os.chmod(f"tools/{tool}", 0o755)
            done = subprocess.run([CHECKOUT / "run", "--help"], env={**os.environ, "PATH": f"{self.work}/tools"},
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            self.assertEqual((done.returncode, words in done.stdout), (code, True), done.stdout)

    def test_refused(self):
        pathlib.Path("scene.mlp").touch()
        self.expect_refused("argument --set: it needs NAME=VALUE", "--set", "Detail")
        self.expect_refused("--python takes neither meshes nor --set nor --up", "--set", "Detail=70", "--python")
        self.expect_refused("unrecognized arguments: --sets", "--sets", "Detail=70")
        self.expect_refused("there is no mesh ", "none.ply")
        self.expect_refused("--install takes neither", "--install", "none.ply")
        self.expect_refused("a project opens in a window; for a picture, name its meshes", "scene.mlp")  # there is no display
        self.expect_refused("--zoom goes with --picture", "--zoom", "2", "--server")
        self.expect_refused("argument --picture: picture.svg: it has to be a .png", "--picture", "picture.svg")
        self.expect_refused("unrecognized arguments: --end", *PICTURE, "--end")

    def test_filter_scripts(self):
        example = CHECKOUT / "docs/examples/laplacian_lines.mlx"
        self.assertEqual(complete(example, self.work / "copy.mlx"), example)
        lines = example.read_text().splitlines(keepends=True)
        pathlib.Path("script.mlx").write_text("".join(line for line in lines if "laplace_operator" not in line))
        copy = self.work / "copy.mlx"
        said = self.said_by(lambda: self.assertEqual(str(complete("script.mlx", copy)), str(copy)))
        self.assertIn("script.mlx: these parameters have their defaults: laplace_operator", said)
        self.assertEqual(pathlib.Path("copy.mlx").read_text().count("<Param "), example.read_text().count("<Param "))

    def test_pictures(self):
        for option, complaint, good, bad in (
                ("--view", "one of front, ", "front bottom 0,0 30,15 -200.5,-90 0,90.0 10,-89.9 10,07",
                 "above 30 30,91 0,90.1 0,-100 30,15,2 [front"),
                ("--up", "choose from '?x'?, '?y'?, '?z'?", "x y z", "w X xy"),
                ("--zoom", "a factor from", "2 0.1 10", "0 0.09 11 -1 1e0 2x ."),
                ("--kinds", "expected one argument", "all ridges+creases", "--orthographic"),
                ("--size", "WIDTHxHEIGHT", "1x20000", "0x10 10 10x 1200X900")):
            for value in good.split():
                parse([*PICTURE, option, value])
            for value in bad.split():
                self.refused(complaint, parse, [*PICTURE, option, value])


unittest.main()
