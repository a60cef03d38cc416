# SPDX-License-Identifier: GPL-3.0-or-later
"""Building: a signal to a script alone ends it and all that the build has begun; two scripts take turns; a checkout
that was copied or moved is built anew; CMake and make are asked again after any change that they would look at, and
only then; in any country; older libraries and compilers are refused."""
import signal
import time
from unittest import mock

from harness import *

from environment.build import build_targets

PROGRAM = "cmake_minimum_required(VERSION 3.18)\nproject(some LANGUAGES CXX)\n"


def await_file(file, written=False):
    while not os.path.exists(file) or written and not os.path.getsize(file):
        time.sleep(0.05)


class Interrupts(ScriptTest):
    SCRIPT = """
import pathlib
from environment.messages import quietly, run_main
def main():
    try:
        quietly("log", ["sh", "-c", "sleep 600 & echo $! >sleeping.part; mv sleeping.part sleeping; wait"])
    finally:
        pathlib.Path("tidied").touch()
run_main(main)"""

    def test_signals(self):
        for number, code in ((signal.SIGTERM, 143), (signal.SIGINT, 130)):
            script = python(self.SCRIPT)
            await_file("sleeping")
            sleeping, began = int(pathlib.Path("sleeping").read_text()), time.monotonic()
            script.send_signal(number)
            self.assertEqual(script.wait(), code)
            self.assertLess(time.monotonic() - began, 2)
            self.assertTrue(os.path.exists("tidied"))
            end = time.monotonic() + 2
            while self.is_running(sleeping):
                self.assertLess(time.monotonic(), end, "the build goes on")
                time.sleep(0.05)
            os.unlink("sleeping")
            os.unlink("tidied")

    @staticmethod
    def is_running(process):
        try:
            return " Z " not in pathlib.Path(f"/proc/{process}/stat").read_text()
        except OSError:
            return False


class Turns(ScriptTest):
    FOREVER = "import time\nwhile True: time.sleep(0.1)"
    SCRIPT = """
import pathlib, subprocess, sys
from environment.files import turn
from environment.messages import run_main
name, inside, after = sys.argv[1:]
def main():
    with turn(pathlib.Path("build").absolute()):
        pathlib.Path(name + ".has").touch()
        exec(inside)
    pathlib.Path(name + ".done").touch()
    exec(after)
run_main(main)"""

    def begin(self, name, inside="", after=""):
        """A script that takes its turn, tells so in NAME.has, does something, ends its turn, tells so in NAME.done and
        goes on."""
        with open(f"{name}.log", "wb") as log:
            script = python(self.SCRIPT, name, inside, after, stderr=log)
        self.addCleanup(lambda: (script.kill(), script.wait()))
        return script

    def test_no_folder(self):
        from environment.files import turn

        pathlib.Path("file").touch()  # a folder of somebody else's, here one that cannot be made
        self.refused("file/build cannot be written into", turn(self.work / "file/build").__enter__)

    def test_turns(self):
        first = self.begin("first", self.FOREVER)
        await_file("first.has")
        stopped = self.begin("stopped")
        await_file("stopped.log", written=True)
        stopped.terminate()
        self.assertEqual(stopped.wait(), 143)
        self.assertFalse(os.path.exists("stopped.has"), "two scripts have their turn at once")

        second = self.begin("second")
        await_file("second.log", written=True)
        self.assertIn(f"another run is building in {self.work}/build: waiting", pathlib.Path("second.log").read_text())
        self.assertFalse(os.path.exists("second.has"), "two scripts have their turn at once")
        first.kill()
        self.assertEqual(second.wait(), 0, "the turn does not end with the script that has it")
        self.assertTrue(os.path.exists("second.done"))

        self.begin("third", after=self.FOREVER)
        await_file("third.done")
        self.assertEqual(self.begin("fourth").wait(), 0)
        self.assertEqual(pathlib.Path("fourth.log").read_text(), "", "a turn does not end")

    def test_what_a_script_has_begun_keeps_its_turn(self):
        build = 'from environment.messages import quietly\nquietly("log", ["sh", "-c", "touch begun; until [ -e end ]; do sleep 0.1; done"])'
        first = self.begin("first", build)
        await_file("begun")
        first.kill()
        first.wait()
        second = self.begin("second")
        await_file("second.log", written=True)
        self.assertFalse(os.path.exists("second.has"))
        pathlib.Path("end").touch()
        self.assertEqual(second.wait(), 0)


class MovedBuild(ScriptTest):
    def expect_build(self, name, regex):
        """Builds the program, which says the folder's name; the script says what matches."""
        said = self.said_by(build_targets, "program", checkout=self.work / name)
        self.assertRegex(said, regex)
        self.assertEqual(subprocess.check_output([f"{name}/build/program"], text=True).strip(), name,
                         "the program is of other sources")

    @staticmethod
    def write_place(name):
        pathlib.Path(name, "main.cpp").write_text(f'#include <cstdio>\nint main() {{ std::puts("{name}"); }}\n')

    def test_anew(self):
        os.mkdir("first")
        pathlib.Path("first/CMakeLists.txt").write_text(PROGRAM + "add_executable(program main.cpp)\n")
        self.write_place("first")
        self.expect_build("first", "^$")
        os.makedirs("first/build/other/CMakeFiles")
        pathlib.Path("first/build/other/CMakeCache.txt").touch()

        subprocess.run(["cp", "-a", "first", "second"], check=True)
        self.write_place("second")
        os.utime("second/main.cpp", (978307200, 978307200))  # older than what was compiled of the first one
        self.expect_build("second", "rebuilding")
        self.expect_build("second", "^$")
        self.assertTrue(os.path.isdir("second/build/other/CMakeFiles"), "another build was touched")

        os.unlink("first/main.cpp")
        os.rename("second", "third")
        self.write_place("third")
        self.expect_build("third", "rebuilding")


class UnchangedBuild(ScriptTest):
    def expect_asked(self, when, asked, *options, package="some"):
        """Whether building asks for packages, CMake and make."""
        log, made = self.work / "build/configure.log", self.work / "build/plugins/program"
        log.unlink(missing_ok=True)
        with mock.patch("environment.build.ensure_toolchain") as ensure:
            self.said_by(build_targets, "program", options=options, extra_packages=[package], checkout=self.work)
        self.assertEqual([call.args for call in ensure.mock_calls], [(package,)] if asked else [], when)
        self.assertEqual(log.exists(), asked, when)
        self.assertTrue(made.exists(), when)
        time.sleep(0.02)  # more than the steps of a file system's clock

    def test_asked_again(self):
        os.mkdir("sources")
        main = self.work / "sources/main.cpp"
        pathlib.Path("CMakeLists.txt").write_text(
            PROGRAM + "set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/plugins)\nfile(GLOB files sources/*.cpp)\n"
            "add_executable(program ${files})\n")
        main.write_text("int main() {}\n")
        self.expect_asked("at first", True)
        self.expect_asked("nothing has changed", False)
        main.touch()
        self.expect_asked("a source was changed", True)
        self.expect_asked("nothing has changed", False)
        (self.work / "sources/more.cpp").write_text("int more;\n")
        self.expect_asked("a source is new", True)
        (self.work / "sources/more.cpp").unlink()
        self.expect_asked("a source was removed", True)
        pathlib.Path("CMakeLists.txt").touch()
        self.expect_asked("the project was changed", True)
        self.expect_asked("nothing has changed", False)
        self.expect_asked("another option", True, "-DANYTHING=ON")
        self.expect_asked("the same option", False, "-DANYTHING=ON")
        self.expect_asked("for another command", True, "-DANYTHING=ON", package="other")
        for _ in range(2):  # in turns
            self.expect_asked("for the first command", False, "-DANYTHING=ON")
            self.expect_asked("for the other command", False, "-DANYTHING=ON", package="other")
        main.touch()
        self.expect_asked("a source was changed", True, "-DANYTHING=ON")
        self.expect_asked("it was built for the first only", True, "-DANYTHING=ON", package="other")
        subprocess.run(["cmake", "-S", ".", "-B", "build", "-DCMAKE_BUILD_TYPE=Debug"], check=True,
                       stdout=subprocess.DEVNULL)
        self.expect_asked("configured by hand", True, "-DANYTHING=ON")
        os.unlink("build/plugins/program")
        self.expect_asked("what was made is gone", True, "-DANYTHING=ON")
        main.write_text("wrong\n")
        for _ in range(2):  # a build that had failed does not count
            self.said_by(self.refused, "the build failed", build_targets, "program", options=["-DANYTHING=ON"],
                         checkout=self.work)


class Requirements(ScriptTest):
    def expect_refused(self, sentence, *words):
        """By CMake, which is asked without MeshLab."""
        done = subprocess.run(["cmake", "-S", CHECKOUT, "-B", "build", "-DCMAKE_DISABLE_FIND_PACKAGE_MeshLab=ON", *words],
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn(sentence, done.stderr)

    def test_older_eigen(self):
        pathlib.Path("Eigen3Config.cmake").write_text("set(Eigen3_VERSION 3.3.9)\n")
        self.expect_refused("Eigen 3.4 or later is needed, not 3.3.9", f"-DEigen3_DIR={self.work}")

    def test_older_compiler(self):
        self.expect_refused("GCC 11 or later is needed, not 10.2.1", "-DCMAKE_CXX_COMPILER_FORCED=1",
                            "-DCMAKE_CXX_COMPILER_ID_RUN=1", "-DCMAKE_CXX_COMPILER_ID=GNU", "-DCMAKE_CXX_COMPILER_VERSION=10.2.1",
                            "-DCMAKE_CXX_STANDARD_COMPUTED_DEFAULT=17")


class Locales(ScriptTest):
    def test_same_in_any_country(self):
        pathlib.Path("CMakeCache.txt").write_text("CMAKE_HOME_DIRECTORY:INTERNAL=/somewhere\n")
        program = 'import pathlib, subprocess\nfrom environment.build import cached\nprint(cached(pathlib.Path("."), "CMAKE_HOME_DIRECTORY"), 0.5)\n'
        program += 'print(subprocess.check_output(["sh", "-c", "echo $LC_ALL"], text=True).strip())'
        for name in ("C", "tr_TR", "de_DE", "ja_JP"):
            if name != "C":
                made = subprocess.run(["localedef", "-i", name, "-f", "UTF-8", f"{name}.UTF-8"],
                                      stderr=subprocess.DEVNULL)
                if made.returncode != 0:
                    self.skipTest(f"the locale {name} cannot be made here")
                name += ".UTF-8"
            script = python(program, env={**os.environ, "LOCPATH": str(self.work), "LC_ALL": name},
                            stdout=subprocess.PIPE, text=True)
            self.assertEqual(script.communicate()[0], f"/somewhere 0.5\n{name}\n")


unittest.main()
