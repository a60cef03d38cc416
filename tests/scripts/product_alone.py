# SPDX-License-Identifier: GPL-3.0-or-later
"""What ./run takes has no need of the tests: in a copy of the checkout without them, the command
and CMake know all that they look for, and nothing there names them."""
from harness import *

SOURCES = os.environ.get("MESHLAB_SOURCES", "")
OTHERS = ("tests", "programs/benchmarks", "scripts/checks", "scripts/hosts", "scripts/test.py", "scripts/bench.py",
          "test", "bench")


class ProductAlone(ScriptTest):
    def test_copy(self):
        for name in CHECKOUT.iterdir():
            if not name.name.startswith((".git", "build")):
                subprocess.run(["cp", "-R", name, "."], check=True)
        subprocess.run(["rm", "-r", *OTHERS], check=True)
        self.assertIn("./run --picture", subprocess.check_output(["./run", "--help"], text=True))
        done = subprocess.run(["cmake", "-S", ".", "-B", "build", f"-DMESHLAB_SOURCE_DIR={SOURCES}",
                               "-DLAPLACIAN_LINES_BUILD_DRIVER=ON"],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual(done.returncode, 0, done.stdout)
        found = subprocess.run(["grep", "-rnE", "tests/|test_meshes|core_test_helpers", ".", "--exclude-dir=build",
                                "--exclude-dir=docs",
                                "--exclude=*.md"], stdout=subprocess.PIPE, text=True).stdout
        found = [line for line in found.splitlines() if not re.search(r":\d+: *(//|# )", line)]  # comments may
        self.assertFalse(found)


unittest.main()
