# SPDX-License-Identifier: GPL-3.0-or-later
"""The packages: MeshLab shows filters and decoration after the .deb is installed, in a copy of the system, and with the
files of the .zip; removing the .deb leaves nothing."""
import resource
import tempfile
import zipfile

from harness import *
from product.extra_plugins import has_extra_plugins, install_plugins
from product.package import make_packages, packages_in
from product.stage import built_plugins, installed_meshlab, stage_meshlab

SCRIPT = """wait
open torus.ply
size 800x600
expect-action Compute Laplacian Lines
expect-action Generate Laplacian Lines Polylines
expect-action Laplacian Lines unchecked
check Laplacian Lines on
setdeco Line Color = #ff0000
setdeco Contour Color = #ff0000
grab lines.png
"""
PLUGINS, DRIVER = built_plugins(BUILD, "plugins"), built_plugins(BUILD, "driver")
NOT_THERE = "no action 'Compute Laplacian Lines'"
folder = WORK / "packages"


def expect_lines(stage):
    """Shown by the MeshLab of this stage."""
    pathlib.Path("lines.png").unlink(missing_ok=True)
    drive(SCRIPT, stage=stage)
    expect(red_pixels("lines.png") > 500, "no lines are drawn")


def in_copy(*command, shared=()):
    """Runs a command, as root, in a copy of the system that is gone when it ends: an overlay, which keeps its changes
    in memory. The folders `shared` and /tmp are the system's own; what else is mounted is not there."""
    with tempfile.TemporaryDirectory() as place:
        return subprocess.run(["setpriv", "--pdeathsig", "KILL", "unshare", "--mount", "--pid", "--fork",
                               "--kill-child",
                               CHECKOUT / "tests/meshlab/enter_copy", place, *shared, "--", *command]).returncode


def in_installed_copy(deb):
    stage = WORK / "deb_stage"
    expect(run_in_work(["dpkg", "--install", deb]) == 0, "the .deb cannot be installed")
    stage_meshlab(stage, DRIVER)
    expect_lines(stage)
    # a checkout's plugins replace the installed ones of the same name, but not for the MeshLab that is installed
    stage_meshlab(stage, PLUGINS + DRIVER)
    expect_lines(stage)
    if has_extra_plugins():
        expect(said_by(install_plugins, PLUGINS) == 1, "the plugins were installed twice")
        expect_text("log", "would be loaded twice; .* apt remove meshlab-laplacian-lines")
    expect(run_in_work(["dpkg", "--remove", "meshlab-laplacian-lines"]) == 0, "the package cannot be removed")
    expect_no_text("log", "(?i)warning")
    expect(not list(installed_meshlab().glob("plugins/*laplacian_lines*")), "the package leaves files")


def make_in_vain(kilobytes):
    """Without room, the packages that are there stay as they are."""
    before = {file: file.read_bytes() for file in folder.iterdir()}
    most = resource.getrlimit(resource.RLIMIT_FSIZE)[1]
    resource.setrlimit(resource.RLIMIT_FSIZE, (kilobytes << 10, most))
    code = said_by(make_packages, BUILD, folder)
    resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))
    expect(code == 1, f"{kilobytes} kB are enough for the packages")
    expect_text("log", "the packages could not be made; the whole output is in .*log")
    expect({file: file.read_bytes() for file in folder.iterdir()} == before and not (BUILD / "packages.new").exists(),
           f"packages without room are {os.listdir(folder)}")


def check_contents(deb, archive):
    version = re.match(r"\d+\.\d+", meshlab_version())[0]
    pathlib.Path("depends").write_text(output("dpkg-deb", "--field", deb, "Depends"))
    expect_text("depends", rf"meshlab \(>= {version}~\), meshlab \(<< {version}\.\), .*libqt5core5")
    contents = [line.split() for line in output("dpkg-deb", "--contents", deb).splitlines()]
    plugins = installed_meshlab() / "plugins"
    names = {f".{plugins}/{plugin}" for plugin in ("libdecorate_laplacian_lines.so", "libfilter_laplacian_lines.so")}
    names.add("./usr/share/doc/meshlab-laplacian-lines/copyright")
    expect({words[5] for words in contents if words[0][0] != "d"} == names, f"the .deb holds {contents}")
    # other packages have these folders too, but for the last
    folders = {f".{place}/" for place in (plugins, pathlib.Path("/usr/share/doc/meshlab-laplacian-lines"))
               for place in (place, *place.parents[:-1])}
    expect({words[5] for words in contents if words[0][0] == "d"} - {"./"} == folders,
           f"the .deb has the folders of {contents}")
    with zipfile.ZipFile(archive) as there:
        expect(sorted(there.namelist()) == ["LICENSE", "README.md", "libdecorate_laplacian_lines.so",
                                            "libfilter_laplacian_lines.so"],
               f"the .zip holds {there.namelist()}")
        there.extractall("zip")


def main():
    folder.mkdir()
    (folder / "of_another_version.deb").touch()
    make_packages(BUILD, folder)
    archive, deb = packages_in(folder)
    for kilobytes in (50, 200, 400, 800):
        make_in_vain(kilobytes)
    check_contents(deb, archive)
    torus()
    stage_meshlab(WORK / "zip_stage", [*(WORK / "zip").glob("*.so"), *DRIVER])
    expect_lines(WORK / "zip_stage")
    # with nothing but the driver, none; in a copy of the system with the .deb, all
    stage_meshlab(WORK / "deb_stage", DRIVER)
    drive_to_failure(NOT_THERE, SCRIPT, stage=WORK / "deb_stage")
    if os.geteuid() != 0 or in_copy("true") != 0:
        skip("a copy of the system takes root's rights, and a machine that allows overlays of its system")
    expect(in_copy("env", "TEST_GOES_ON=1", "python3", "-B", TEST, shared=[CHECKOUT, BUILD]) == 0,
           "what the .deb installs does not work")
    expect(not os.path.exists("/usr/share/doc/meshlab-laplacian-lines"), "the copy was the system itself")


if os.environ.get("TEST_GOES_ON"):
    in_installed_copy(packages_in(folder)[1])
else:
    main()
