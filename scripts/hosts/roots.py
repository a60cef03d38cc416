# SPDX-License-Identifier: GPL-3.0-or-later
"""Other releases of Debian in folders ("roots"), to build and test with the MeshLab that they package. Made by
debootstrap from the mirror that this machine's apt uses, and entered like a chroot in namespaces of their own: mounts
there end with the last process. What is not available raises Unavailable."""

import contextlib
import fcntl
import hashlib
import inspect
import os
import pathlib
import re

from environment import packages
from environment.build import CHECKOUT
from environment.files import cache_folder, compiled_folder, publish_into
from environment.headers import debian_mirror
from environment.messages import Failure, Unavailable, output, run, say

SUITES = {"2020": "bookworm", "2022": "trixie", "2025": "forky"}  # by the year in MeshLab's version
NAMESPACES = "setpriv --pdeathsig KILL unshare --mount --pid --fork --kill-child".split()
ENTER = pathlib.Path(__file__).with_name("enter_root")


def machine_apt_settings():
    """How this machine reaches its mirrors, for the apt of a root."""
    kept = re.findall(r"(?im)^Acquire::(?:http|https|ftp|ForceIPv|Retries|Check-).*$", output("apt-config", "dump") or "")
    # testing's lists run out while a mirror or a frozen snapshot of it lags behind
    return "\n".join([*kept, 'Acquire::Check-Valid-Until "false";', 'Acquire::Languages "none";',
                      'APT::Sandbox::User "";']) + "\n"


def enter(root, access, binds, command, **options):
    """The exit code of a command in the root, which it sees with this access, ro or rw. A bind, ro:FOLDER or rw:FOLDER,
    is a folder of this machine that is there under the same name; ro:FOLDER=NAME under another. Only with rw is there a
    network."""
    network = [] if access == "rw" else ["--net"]
    return run([*NAMESPACES, "--ipc", *network, ENTER, root, access, *binds, "--", "env",
                f"PYTHONPATH={CHECKOUT}/scripts", *command], **options)


def run_in_root(suite, build, command, kind="", install=None):
    """In the root of this release, which has the checkout, this build folder, and what is compiled, and no network."""
    with ensured_root(suite, kind, install or install_toolchain) as root:
        for folder in (build, compiled_folder()):
            folder.mkdir(parents=True, exist_ok=True)
        binds = [f"ro:{CHECKOUT}", f"rw:{build}", f"rw:{compiled_folder()}"]
        if (headers := cache_folder() / "headers").is_dir():
            binds.append(f"ro:{headers}")
        environment = {**os.environ, "LAPLACIAN_LINES_CACHE": str(cache_folder()), "LAPLACIAN_LINES_BUILD": str(build)}
        if enter(root, "ro", binds, command, env=environment) != 0:
            raise Failure(f"{' '.join(map(str, command[:4]))} failed in {root}")


def run_with_network(root, kept, command, log):
    """Whether a command in a root that is being made succeeds. It can call apt-get and the scripts, and fetch headers."""
    headers = cache_folder() / "headers"
    headers.mkdir(parents=True, exist_ok=True)
    binds = [f"ro:{CHECKOUT}", f"rw:{headers}", f"rw:{kept}=/var/cache/apt/archives"]
    binds += [f"ro:{os.path.realpath(file)}={file}" for file in
              ("/etc/resolv.conf", "/etc/hosts", "/etc/ssl/certs", "/etc/apt/auth.conf.d") if os.path.exists(file)]
    environment = {**os.environ, "LAPLACIAN_LINES_CACHE": str(cache_folder())}
    return enter(root, "rw", binds, command, env=environment, stdout=log, stderr=log) == 0


def install_toolchain(root, kept, log):
    """What ./test would install there, MeshLab's headers included."""
    program = "from environment import build, packages; build.ensure_toolchain(*packages.DISPLAY, *packages.TEST)"
    return run_with_network(root, kept, ["python3", "-B", "-c", program], log)


@contextlib.contextmanager
def ensured_root(suite, kind, install):
    """The root, locked against its being replaced. One of a kind of its own has what install(ROOT, FOLDER OF PACKAGES, LOG)
    puts there, which returns whether it succeeds. When what it is made from changes, it is made anew."""
    if os.geteuid() != 0 or output("unshare", "--mount", "--pid", "--fork", "--net", "--ipc", "true") is None:
        raise Unavailable("making a root needs root's rights, and a machine that allows private mounts (unshare)")
    root, mirror = cache_folder() / "roots" / (suite + kind), debian_mirror()
    if not mirror:
        raise Unavailable("roots are made from this machine's Debian mirror, and its apt configuration names none")
    recipe = [suite, mirror, *packages.BUILD, *packages.DISPLAY, *packages.TEST, *packages.MESHLAB_RECOMMENDS,
              *map(inspect.getsource, (make_root, run_with_network, install))]
    wanted = hashlib.sha256("\n".join(recipe).encode()).hexdigest()
    root.parent.mkdir(parents=True, exist_ok=True)
    with open(f"{root}.lock", "wb") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not (root / "recipe").exists() or (root / "recipe").read_text() != wanted:
            make_root(suite, mirror, root, wanted, install)
        fcntl.flock(lock, fcntl.LOCK_SH)
        yield root


def make_root(suite, mirror, root, recipe, install):
    packages.ensure_packages("debootstrap")
    say(f"making a root of Debian {suite} in {root}: 1.3 GB, a few minutes")
    kept = cache_folder() / "packages" / root.name  # so that a root made anew downloads only what is new
    (kept / "partial").mkdir(parents=True, exist_ok=True)

    def fill(scratch):
        # debootstrap of an older release knows no newer one, but all are made like sid
        if run([*NAMESPACES, "--mount-proc", "debootstrap", "--variant=minbase", "--include=ca-certificates,python3",
                f"--cache-dir={kept}", suite, scratch, mirror, "/usr/share/debootstrap/scripts/sid"], stdout=log, stderr=log):
            return False
        (scratch / "etc/apt/apt.conf.d/00laplacian-lines").write_text(machine_apt_settings())
        (scratch / "recipe").write_text(recipe)
        return install(scratch, kept, log)

    with open(f"{root}.log", "wb") as log:
        made = publish_into(root, fill)
    if not made:
        raise Unavailable(f"the root of Debian {suite} could not be made; its log is {root}.log")
