# SPDX-License-Identifier: GPL-3.0-or-later
"""Options of ./run that are refused at once, before anything is built, and those of pictures that are taken."""
from harness import *

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
        for tool in ("sh", "dirname", "readlink", "env"):
            os.symlink(shutil.which(tool), f"tools/{tool}")
        path = f"{self.work}/tools"

        def run_help(user, install):
            for name, commands in (("id", f"echo {user}"), ("apt-get", f'echo "$@" >>{path}/calls; {install}')):
                pathlib.Path("tools", name).write_text(f"#!/bin/sh\n{commands}\n")
                os.chmod(f"tools/{name}", 0o755)
            done = subprocess.run([CHECKOUT / "run", "--help"], env={**os.environ, "PATH": path},
                                  stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True)
            return done.returncode, done.stdout

        self.assertEqual(run_help(1000, "false")[0], 1)
        self.assertIn("as root, run: apt-get install python3", run_help(1000, "false")[1])
        self.assertEqual(run_help(0, "false"),
                         (1, "laplacian-lines: installing python3\nlaplacian-lines: apt-get update failed; "
                                               "trying with the package lists at hand\nlaplacian-lines: could not install python3\n"))
        code, said = run_help(0, f"/bin/ln -sf {sys.executable} {path}/python3")
        self.assertEqual((code, said.splitlines()[:1]), (0, ["laplacian-lines: installing python3"]))
        self.assertIn("./run --picture", said)

    def test_settings(self):
        self.expect_refused("--set needs NAME=VALUE", "--set")
        self.expect_refused("--set needs NAME=VALUE", "--set", "Detail")
        self.expect_refused("--set goes with a window or a picture, not with --install", "--set", "Detail=70",
                            "--install")
        self.expect_refused("--set goes with a window or a picture, not with --python", "--set", "Detail=70",
                            "--python", "-c", "pass")
        self.expect_refused("unknown option --sets", "--sets", "Detail=70")
        self.expect_refused("there is no mesh ", "none.ply")
        self.expect_refused("--install takes no other arguments", "--install", "none.ply")

    def test_meshes(self):
        pathlib.Path("scene.mlp").touch()
        self.expect_refused("a project opens in a window; for a picture, name its meshes",
                            "scene.mlp")  # there is no display
        self.expect_refused("a project opens in a window", *PICTURE, "scene.mlp")
        for mode in ("--server", "--python"):
            self.expect_refused("--zoom goes with --picture", "--zoom", "2", mode)

    def test_filter_scripts(self):
        from product.filter_scripts import complete

        example = CHECKOUT / "docs/examples/laplacian_lines.mlx"
        self.assertEqual(complete(example, self.work / "copy.mlx"), example)
        lines = example.read_text().splitlines(keepends=True)
        pathlib.Path("script.mlx").write_text("".join(line for line in lines if "accuracy" not in line))
        said = self.said_by(complete, "script.mlx", self.work / "copy.mlx")
        self.assertIn("script.mlx: these parameters have their defaults: accuracy", said)
        self.assertEqual(pathlib.Path("copy.mlx").read_text().count("<Param "), example.read_text().count("<Param "))

    def test_pictures(self):
        from product.picture import Options as Picture
        from product.picture import Pictures, Row

        def taken(option, *values):
            words = [word for value in values for word in (option, value)]
            while words:
                Picture().take(words)

        taken("--view", "front", "back", "left", "right", "top", "bottom", "0,0", "30,15", "-200.5,-90", "0,90",
              "0,90.0", "10,-89.9", "10,07")
        taken("--up", "x", "y", "z")
        taken("--zoom", "2", "0.1", "10")
        taken("--size", "1x20000")
        taken("--kinds", "all", "ridges+valleys,log")
        taken("--noise", "0.2")
        for option, complaint, values in (
                ("--view", "--view needs front, back",
                 ["", "above", "30", "30,91", "0,90.1", "0,-100", "0,900", "30,15,2", "front top", "[front"]),
                ("--up", "--up needs the axis", ["", "w", "X", "-z", "xy"]),
                ("--zoom", "--zoom needs a factor", ["", "0", "0.09", "11", "-1", "1e0", "2x", "."]),
                ("--kinds", "--kinds needs names", ["", "--noise"]),
                ("--noise", "--noise needs a share", ["", "0", "-1", "2.1", "x"]),
                ("--size", "--size needs WIDTHxHEIGHT", ["", "0x10", "10", "10x", "1200X900"])):
            for value in values:
                self.refused(complaint, Picture().take, [option, value])
        for options in ([], ["--kinds", "all"]):  # what the user sets comes later and wins; kinds have one kernel
            picture = Picture()
            if options:
                picture.take(list(options))
            pictures = Pictures("stage", pathlib.Path("folder"), picture, settings=["setdeco Scale = As Computed"])
            pictures.rows = [Row(pathlib.Path("mesh.ply"), "mesh.ply")]
            scales = re.findall("setdeco Scale = ([^;]+) ;", "\n".join(pictures.row_script(0)))
            self.assertEqual(scales, ["As Computed"] if options else ["With the View", "As Computed"])
        self.expect_refused("--view needs", *PICTURE, "--view")
        self.expect_refused("unknown option --end", *PICTURE,
                            *"--view 30,15 --up x --zoom 2 --orthographic --kinds all --end".split())


unittest.main()
