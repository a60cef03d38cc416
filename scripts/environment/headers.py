# SPDX-License-Identifier: GPL-3.0-or-later
"""MeshLab's headers. No distribution packages them: they come from the source package of the very version that is
installed, because plugins share MeshLab's classes and a near match would crash. The machine's apt sources are read,
never changed."""

import os
import pathlib
import platform
import subprocess
import tempfile

from environment.files import cache_folder, publish_into
from environment.messages import Unavailable, output, say
from environment.packages import meshlab_version

KEYRING = "/usr/share/keyrings/debian-archive-keyring.gpg"
HEADERS = "*/ML_VERSION", "*/src/common", "*/vcglib/vcg", "*/vcglib/wrap"  # beside src/ (2020.09) or inside it (later)


def apt_sources():
    """Triples of address, release and component that this machine's packages come from."""
    rows = output("apt-get", "indextargets", "--format", "$(REPO_URI) $(RELEASE) $(COMPONENT)", "Created-By: Packages")
    return dict.fromkeys(tuple(row.split()) for row in (rows or "").splitlines() if len(row.split()) == 3)


def debian_mirror():
    """The mirror of this machine's release; None if it is not Debian."""
    release = platform.freedesktop_os_release()
    wanted = [release.get("VERSION_CODENAME"), "main"]
    return next((address for address, *of in apt_sources() if of == wanted and release.get("ID") == "debian"), None)


def private_apt(folder, suite=None, kind="deb-src"):
    """Sets up an apt with lists and cache in the folder, for the machine's source packages or another release of Debian.
    Returns whether its mirror is known. The user's own are left alone."""
    sources = [(debian_mirror(), suite, "main")] if suite else apt_sources()
    options = f"[signed-by={KEYRING}] " if os.access(KEYRING, os.R_OK) and debian_mirror() else ""
    (folder / "sources.list").write_text("".join(f"{kind} {options}{' '.join(map(str, row))}\n" for row in sources))
    for name in ("lists/partial", "cache"):
        (folder / name).mkdir(parents=True)
    # -c is read last, so that it can clear the system's hooks. Lists may be out of date on a mirror that lags behind:
    # source packages do not mind.
    (folder / "apt.conf").write_text(f"""#clear APT::Update::Post-Invoke;
#clear APT::Update::Post-Invoke-Success;
Dir::Etc::sourcelist "{folder}/sources.list";
Dir::Etc::sourceparts "/dev/null";
Dir::State::lists "{folder}/lists";
Dir::Cache "{folder}/cache";
APT::Sandbox::User "";
Acquire::Check-Valid-Until "false";
""")
    if not apt_get(folder, "update"):  # sources of other vendors often hold no source packages
        say("not all package sources answered; going on with those that did")
    return None not in (row[0] for row in sources)


def apt_get(folder, *words):
    """Whether the apt in the folder succeeds there."""
    return subprocess.run(["apt-get", "-qq", "-c", folder / "apt.conf", *words], cwd=folder).returncode == 0


def unpack_source(package, folder, suite=None):
    """The tarball alone; some mirrors lack a source package's other files. The package may be NAME=VERSION, of this
    machine's sources or of another release of Debian."""
    with tempfile.TemporaryDirectory() as name:
        apt = pathlib.Path(name)
        return (private_apt(apt, suite) and apt_get(apt, "source", "--tar-only", "--download-only", package) and
                subprocess.run(["tar", "-xf", next(apt.glob("meshlab_*.orig.tar.*")), "-C", folder,
                                "--strip-components=1", "--wildcards", *HEADERS]).returncode == 0)


def ensure_headers(version="", suite=None):
    """The folder of those of the installed MeshLab, or of a version that another release of Debian packages. Raises Unavailable."""
    package = "meshlab" if suite else f"meshlab={meshlab_version()}"
    folder = cache_folder() / "headers" / (version or meshlab_version())

    def fill(scratch):
        return unpack_source(package, scratch, suite) and (scratch / "ML_VERSION").read_text().startswith(version)

    if not (folder / "src/common").is_dir():
        say(f"fetching the headers of MeshLab {folder.name} from its source package")
        if not publish_into(folder, fill):
            raise Unavailable(f"the source of MeshLab {folder.name} could not be fetched; unpack it yourself to {folder}")
    return folder
