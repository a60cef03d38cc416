# SPDX-License-Identifier: GPL-3.0-or-later
"""The packages: MeshLab shows filters and decoration after the .deb is installed, in a copy of the system, and with the
files of the .zip; the command draws, an older .deb is upgraded, and purging it leaves nothing."""
import gzip
import tempfile
import zipfile

from harness import *
from product.extra_plugins import has_extra_plugins, install_plugins
from product.package import make_packages, packages_in
from product.stage import built_plugins, installed_meshlab, stage_meshlab

SCRIPT = """wait
load torus.ply
size 800x600
expect-action Compute Laplacian Lines
expect-action Generate Laplacian Lines Polylines
expect-action Laplacian Lines unchecked
check Laplacian Lines on
setdeco Line Color = #ff0000
grab lines.png
"""
PLUGINS, DRIVER = built_plugins(BUILD, "plugins"), built_plugins(BUILD, "driver")
NOT_THERE = "no action 'Compute Laplacian Lines'"
DOCUMENTS = pathlib.Path("/usr/share/doc/meshlab-laplacian-lines")
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
    for package in (WORK / "older.deb", deb):
        expect(run_in_work(["dpkg", "--install", package]) == 0, f"{package} cannot be installed")
    expect(not (DOCUMENTS / "gone").exists(), "upgrading leaves files")
    expect_command()
    stage_meshlab(stage, DRIVER)
    expect_lines(stage)
    # a checkout's plugins replace the installed ones of the same name, but not for the MeshLab that is installed
    stage_meshlab(stage, PLUGINS + DRIVER)
    expect_lines(stage)
    if has_extra_plugins():
        expect(said_by(install_plugins, PLUGINS) == 1, "the plugins were installed twice")
        expect_text("log", "would be loaded twice; .* apt remove meshlab-laplacian-lines")
    expect(run_in_work(["dpkg", "--purge", "meshlab-laplacian-lines"]) == 0, "the package cannot be purged")
    expect_no_text("log", "(?i)warning")
    expect(not list(installed_meshlab().glob("plugins/*laplacian_lines*")), "the package leaves files")
    expect(not output("find", "/usr", "-iname", "*laplacian-lines*", "-not", "-path", f"{CHECKOUT}/*"),
           "the package leaves files")


def completed(*words):
    """What bash makes of the last one."""
    script = ('source /usr/share/bash-completion/completions/laplacian-lines; COMP_WORDS=(laplacian-lines "$@"); '
              'COMP_CWORD=$#; _laplacian_lines; printf "%s\\n" "${COMPREPLY[@]}"')
    return output("bash", "-c", script, "bash", *words).split()


def expect_command():
    """It draws, and its manual and its completion know all options that its help has."""
    expect(run_in_work(["laplacian-lines", "installed.svg", "--views", "front,left", "torus.ply"]) == 0, "it draws nothing")
    expect_text("installed.svg", "<path")
    options = re.findall(r"(?m)^ +(--[a-z-]+)", output("laplacian-lines", "--help"))
    expect(len(options) > 15, f"the help has the options {options}")
    manual = gzip.open("/usr/share/man/man1/laplacian-lines.1.gz", "rt", encoding="utf-8").read().replace("\\-", "-")
    expect(completed("--unit", "c") == ["cm"] and completed("--un") == ["--unit"], "words are not completed")
    for option in options:
        expect(re.search(rf"(?m)^\.B {option}( |$)", manual), f"the manual has no {option}")
        expect(option in completed(option), f"{option} is not completed")


def make_older(deb):
    """The same with a lower version and one more file."""
    older = WORK / "older"
    run_in_work(["dpkg-deb", "--raw-extract", deb, older])
    control = older / "DEBIAN/control"
    control.write_text(control.read_text().replace("\nVersion: ", "\nVersion: 0~"))
    (older / str(DOCUMENTS)[1:] / "gone").touch()
    expect(run_in_work(["dpkg-deb", "--build", older, WORK / "older.deb"]) == 0, "no older .deb can be made")
    shutil.rmtree(older)


def check_contents(deb, archive):
    version = re.match(r"\d+\.\d+", meshlab_version())[0]
    pathlib.Path("depends").write_text(output("dpkg-deb", "--field", deb, "Depends"))
    expect_text("depends", rf"meshlab \(>= {version}~\), meshlab \(<< {version}\.\), .*libqt5core5")
    contents = [line.split() for line in output("dpkg-deb", "--contents", deb).splitlines()]
    plugins = installed_meshlab() / "plugins"
    names = {f".{plugins}/{plugin}" for plugin in ("libdecorate_laplacian_lines.so", "libfilter_laplacian_lines.so")}
    names |= {f"./usr/{name}" for name in ("bin/laplacian-lines", "share/bash-completion/completions/laplacian-lines",
                                           "share/lintian/overrides/meshlab-laplacian-lines",
                                           "share/man/man1/laplacian-lines.1.gz")}
    names |= {f".{DOCUMENTS}/{name}" for name in ("changelog.gz", "copyright")}
    expect({words[5] for words in contents if words[0][0] != "d"} == names, f"the .deb holds {contents}")
    folders = {f".{place}/" for name in names for place in pathlib.PurePath(f"/{name}").parents[:-1]}
    expect({words[5] for words in contents if words[0][0] == "d"} - {"./"} == folders,
           f"the .deb has the folders of {contents}")
    with zipfile.ZipFile(archive) as there:
        expect(sorted(there.namelist()) == ["LICENSE", "libdecorate_laplacian_lines.so", "libfilter_laplacian_lines.so"],
               f"the .zip holds {there.namelist()}")
        there.extractall("zip")


def main():
    folder.mkdir()
    (folder / "of_another_version.deb").touch()
    make_packages(BUILD, folder)
    archive, deb = packages_in(folder)
    check_contents(deb, archive)
    make_older(deb)
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
    expect(not DOCUMENTS.exists(), "the copy was the system itself")


if os.environ.get("TEST_GOES_ON"):
    in_installed_copy(packages_in(folder)[1])
else:
    main()
