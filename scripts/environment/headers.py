# SPDX-License-Identifier: GPL-3.0-or-later
"""MeshLab's headers. No distribution packages them: they come from the source package of the very version that is
installed, because plugins share MeshLab's classes and a near match would crash. The machine's apt sources are read,
never changed."""

import os
import pathlib
import platform
import re
import subprocess
import tempfile

from environment.files import cache_folder, publish_into
from environment.messages import Failure, output, say
from environment.packages import meshlab_version

KEYRING = "/usr/share/keyrings/debian-archive-keyring.gpg"
HEADERS = "*/ML_VERSION", "*/src/common", "*/vcglib/vcg", "*/vcglib/wrap"  # beside src/ (2020.09) or inside it (later)


def debian_mirror():
    """The mirror of this machine's release; None if it is not Debian."""
    release = platform.freedesktop_os_release()
    if release.get("ID") != "debian":
        return None
    format_of_rows = "$(REPO_URI) $(RELEASE) $(COMPONENT)"
    rows = output("apt-get", "indextargets", "--format", format_of_rows, "Created-By: Packages") or ""
    wanted = [release.get("VERSION_CODENAME"), "main"]
    return next((row.split()[0] for row in rows.splitlines() if row.split()[1:] == wanted), None)


def readable(pattern, folder=pathlib.Path("/etc/apt")):
    return [file.read_text(errors="replace") for file in sorted(folder.glob(pattern)) if os.access(file, os.R_OK)]


def write_source_list(folder, suite=None, kind="deb-src"):
    """Entries for apt's sourceparts folder: the machine's sources as source packages, or those of another release of
    Debian. Returns whether there are any."""
    folder.mkdir(parents=True, exist_ok=True)
    if suite:
        mirror = debian_mirror()
        options = f"[signed-by={KEYRING}] " if os.access(KEYRING, os.R_OK) else ""
        (folder / "debian.list").write_text(f"{kind} {options}{mirror} {suite} main\n")
        return mirror is not None
    # one-line style: "deb [options] uri suite components"
    entries = {re.sub(r"^\s*deb(-src)?\s", "deb-src ", line)
               for text in readable("sources.list") + readable("sources.list.d/*.list")
               for line in text.splitlines() if re.match(r"\s*deb(-src)?\s", line) and "cdrom:" not in line}
    (folder / "classic.list").write_text("".join(f"{entry}\n" for entry in sorted(entries)))
    # deb822 style: paragraphs of fields, where "Enabled: no" must keep its meaning
    paragraphs = (re.sub(r"(?mi)^Types:.*", "Types: deb-src", re.sub(r"(?m)^#.*\n", "", text))
                  for text in readable("sources.list.d/*.sources"))
    (folder / "deb822.sources").write_text("\n\n".join(paragraphs))
    return True


def source_apt_get(folder, *words, **options):
    """Whether apt-get succeeds with sources, lists and cache in the folder. Leaves the user's own alone."""
    # -c is read last, so that it can clear the system's hooks. Lists may be out of date on a mirror that lags behind:
    # source packages do not mind. All lines are needed, or apt-get would write the machine's own lists.
    (folder / "apt.conf").write_text(f"""#clear APT::Update::Post-Invoke;
#clear APT::Update::Post-Invoke-Success;
Dir::Etc::sourcelist "/dev/null";
Dir::Etc::sourceparts "{folder}/sources";
Dir::State::lists "{folder}/lists";
Dir::Cache "{folder}/cache";
APT::Sandbox::User "";
Acquire::Check-Valid-Until "false";
""")
    return subprocess.run(["apt-get", "-qq", "-c", folder / "apt.conf", *words], **options).returncode == 0


def unpack_source(package, folder, suite=None, parts=HEADERS):
    """The tarball alone; some mirrors lack a source package's other files. The package may be NAME=VERSION, of this
    machine's sources or of another release of Debian."""
    with tempfile.TemporaryDirectory() as name:
        apt = pathlib.Path(name)
        if not write_source_list(apt / "sources", suite):
            return False
        (apt / "lists/partial").mkdir(parents=True)
        (apt / "cache").mkdir()
        if not source_apt_get(apt, "update"):  # sources of other vendors often hold no source packages
            say("not all package sources answered; going on with those that did")
        return (source_apt_get(apt, "source", "--tar-only", "--download-only", package, cwd=apt) and
                subprocess.run(["tar", "-xf", next(apt.glob("meshlab_*.orig.tar.*")), "-C", folder,
                                "--strip-components=1", "--wildcards", *parts]).returncode == 0)


def ensure_headers():
    """Sets MESHLAB_SOURCE_DIR."""
    version = meshlab_version()
    folder = cache_folder() / "headers" / version
    os.environ["MESHLAB_SOURCE_DIR"] = str(folder)
    if (folder / "src/common").is_dir():
        return
    say(f"fetching the headers of MeshLab {version} from the distribution's source package")
    if not publish_into(folder, lambda scratch: unpack_source(f"meshlab={version}", scratch)):
        raise Failure(f"could not fetch the source package of meshlab {version}; unpack it yourself and name its folder: "
                      "cmake -DMESHLAB_SOURCE_DIR=FOLDER")
