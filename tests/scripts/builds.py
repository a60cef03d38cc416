# SPDX-License-Identifier: GPL-3.0-or-later
"""Building: a signal to a script alone ends it and all that the build has begun; two scripts take turns; a checkout
that was copied or moved is built anew."""
import signal
import time

from harness import *

from environment.build import build_targets

BUILD = 'quietly("log", ["sh", "-c", "sleep 0.5; echo $$ >sleeping.part; mv sleeping.part sleeping; exec sleep 600"])'


def await_file(file):
    while not os.path.exists(file) or not os.path.getsize(file):
        time.sleep(0.05)


def begin(name, build=""):
    """A script that takes its turn in the folder "build", does something, and leaves a file NAME."""
    program = f"""import pathlib
from environment.files import locked
from environment.messages import quietly, run_main
def main():
    with locked(pathlib.Path("build").absolute()):
        {build or 'pass'}
        pathlib.Path("{name}").write_text("done")
run_main(main)"""
    with open(f"{name}.log", "wb") as log:
        return subprocess.Popen([sys.executable, "-B", "-c", program], stderr=log)


class Turns(ScriptTest):
    def test_signals(self):
        for number, code in ((signal.SIGTERM, 143), (signal.SIGINT, 130)):
            script = begin("first", BUILD)
            await_file("sleeping")
            sleeping = pathlib.Path("/proc", pathlib.Path("sleeping").read_text().strip())
            os.unlink("sleeping")
            script.send_signal(number)
            self.assertEqual(script.wait(), code)
            end = time.monotonic() + 60
            while sleeping.exists() and " Z " not in (sleeping / "stat").read_text():
                self.assertLess(time.monotonic(), end, "the build goes on")
                time.sleep(0.05)

    def test_turns(self):
        """What a killed script has begun keeps its turn."""
        first = begin("first", BUILD)
        await_file("sleeping")
        second = begin("second")
        await_file("second.log")
        self.assertIn(f"another run is building in {self.work}/build: waiting", pathlib.Path("second.log").read_text())
        first.kill()
        first.wait()
        time.sleep(0.2)
        self.assertFalse(os.path.exists("second"), "two scripts have their turn at once")
        os.kill(int(pathlib.Path("sleeping").read_text()), signal.SIGTERM)
        self.assertEqual(second.wait(), 0, "the turn does not end")
        self.assertTrue(os.path.exists("second"))


class Builds(ScriptTest):
    def expect_build(self, name, regex):
        """Builds the program, which says the folder's name; the script says what matches."""
        pathlib.Path(name, "main.cpp").write_text(f'#include <cstdio>\nint main() {{ std::puts("{name}"); }}\n')
        os.utime(f"{name}/main.cpp", (978307200, 978307200))  # older than what may have been compiled of another
        self.assertRegex(self.said_by(build_targets, "program", checkout=self.work / name), regex)
        said = subprocess.check_output([f"{name}/build/program"], text=True).strip()
        self.assertEqual(said, name, "the program is of other sources")

    def test_moved(self):
        os.mkdir("first")
        pathlib.Path("first/CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.18)\nproject(some LANGUAGES CXX)\nadd_executable(program main.cpp)\n")
        self.expect_build("first", "^$")
        subprocess.run(["cp", "-a", "first", "second"], check=True)
        self.expect_build("second", "building anew")
        self.expect_build("second", "^$")
        pathlib.Path("second/main.cpp").write_text("wrong\n")
        self.said_by(self.refused, "the build failed", build_targets, "program", checkout=self.work / "second")


unittest.main()
