# SPDX-License-Identifier: GPL-3.0-or-later
"""Other releases of Debian in folders ("roots"), to build and test with the MeshLab that they package. Made by
debootstrap from the mirror that this machine's apt uses, and entered in namespaces of their own: whatever is mounted
there is gone when the last process ends, however it ends. What cannot be had raises Obstacle."""

import fcntl
import hashlib
import inspect
import os
import pathlib
import re
import shutil

from environment import packages
from environment.build import CHECKOUT
from environment.files import cache_folder, publish_into
from environment.headers import debian_mirror
from environment.messages import Failure, Obstacle, logged, output, run, say

NAMESPACES = "setpriv --pdeathsig KILL unshare --mount --pid --fork --kill-child".split()
ENTER = pathlib.Path(__file__).with_name("enter_root")


def machine_apt_settings():
    """How this machine reaches its mirrors, for the apt of a root."""
    kept = re.findall(r"(?im)^Acquire::(?:http|https|ftp|ForceIPv|Retries|Check-).*$",
                      output("apt-config", "dump") or "")
    # testing's lists run out while a mirror or a frozen snapshot of it lags behind
    return "\n".join([*kept, 'Acquire::Check-Valid-Until "false";', 'Acquire::Languages "none";',
                      'APT::Sandbox::User "";']) + "\n"


def in_root(root, access, binds, command, **environment):
    """The exit code of a command in the root, which it sees with this access, ro or rw. A bind, ro:FOLDER or rw:FOLDER,
    is a folder of this machine that is there under the same name; ro:FOLDER=NAME under another. Only with rw is there a
    network."""
    network = [] if access == "rw" else ["--net"]
    environment = {**os.environ, "LAPLACIAN_LINES_CACHE": str(cache_folder()), **environment}
    return run([*NAMESPACES, "--ipc", *network, ENTER, root, access, *binds, "--", *command], env=environment)


def recipe(suite, mirror, install):
    """What a root is made from: when this changes, it is made anew."""
    words = [suite, mirror, *packages.BUILD, *packages.DISPLAY, *packages.TEST, *packages.MESHLAB_RECOMMENDS]
    words += map(inspect.getsource, (make_root, make_bare_root, run_with_network, install))
    return hashlib.sha256("\n".join(words).encode()).hexdigest()


def make_bare_root(suite, mirror, root, kept):
    # debootstrap of an older release knows no newer one, but all are made like sid
    code = run([*NAMESPACES, "--mount-proc", "debootstrap", "--variant=minbase", "--include=ca-certificates,python3",
                f"--cache-dir={kept}", suite, root, mirror, "/usr/share/debootstrap/scripts/sid"])
    if code == 0:
        (root / "etc/apt/apt.conf.d/00laplacian-lines").write_text(machine_apt_settings())
    return code == 0


def run_with_network(root, kept, command):
    """Whether a command in a root that is being made succeeds. It can call apt-get and the scripts, and fetch headers."""
    binds = [f"ro:{os.path.realpath(file)}={file}"
             for file in ("/etc/resolv.conf", "/etc/hosts", "/etc/ssl/certs", "/etc/apt/auth.conf.d")
             if os.path.exists(file)]
    headers = cache_folder() / "headers"
    headers.mkdir(parents=True, exist_ok=True)
    return in_root(root, "rw", [*binds, f"ro:{CHECKOUT}", f"rw:{headers}", f"rw:{kept}=/var/cache/apt/archives"],
                   ["env", f"PYTHONPATH={CHECKOUT}/scripts", *command]) == 0


def install_toolchain(root, kept):
    """What ./test would install there, MeshLab's headers included."""
    program = "from environment import build, packages; build.ensure_toolchain(*packages.DISPLAY, *packages.TEST)"
    return run_with_network(root, kept, ["python3", "-B", "-c", program])


def can_make_roots():
    if os.geteuid() != 0:
        raise Obstacle("making a root needs root's rights")
    try:
        packages.ensure_packages("debootstrap")
    except Failure as reason:
        say(reason)
        raise Obstacle("debootstrap could not be installed") from None
    if output("unshare", "--mount", "--pid", "--fork", "--net", "--ipc", "true") is None:
        raise Obstacle("this machine does not allow private mounts (unshare)")


def recipe_of(root):
    return (root / "recipe").read_text().strip() if (root / "recipe").exists() else ""


def ensure_root(suite, kind="", install=install_toolchain):
    """The root, and a lock against its being replaced, which is to be kept open. A root of a kind of its own has what
    install(ROOT, FOLDER OF PACKAGES) puts there, which returns whether it succeeds."""
    root = cache_folder() / "roots" / (suite + kind)
    can_make_roots()
    mirror = debian_mirror()
    if not mirror:
        raise Obstacle("roots are made from this machine's Debian mirror, and its apt configuration names none")
    wanted = recipe(suite, mirror, install)
    root.parent.mkdir(parents=True, exist_ok=True)
    lock = open(f"{root}.lock", "wb")
    fcntl.flock(lock, fcntl.LOCK_SH)
    if recipe_of(root) != wanted:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            say(f"{root} has to be made again: waiting until no other tests use it")
            fcntl.flock(lock, fcntl.LOCK_EX)
        if recipe_of(root) != wanted:
            make_root(suite, mirror, root, wanted, install)
        fcntl.flock(lock, fcntl.LOCK_SH)
    return root, lock


def make_root(suite, mirror, root, wanted, install):
    say(f"making a root of Debian {suite} in {root}: 1.3 GB, a few minutes")
    for left in root.parent.glob(f"{root.name}.????????"):  # of a run that was killed
        shutil.rmtree(left, ignore_errors=True)
    kept = cache_folder() / "packages" / root.name  # so that a root made anew downloads only what is new
    (kept / "partial").mkdir(parents=True, exist_ok=True)

    def build(scratch):
        if not (make_bare_root(suite, mirror, scratch, kept) and install(scratch, kept)):
            return False
        (scratch / "recipe").write_text(f"{wanted}\n")
        return True

    with logged(f"{root}.log"):
        made = publish_into(root, build)
    if not made:
        raise Obstacle(f"the root of Debian {suite} could not be made; its log is {root}.log")
