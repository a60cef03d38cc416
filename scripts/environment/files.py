# SPDX-License-Identifier: GPL-3.0-or-later
"""Files and folders that are written whole or not at all, and locks on folders."""

import contextlib
import fcntl
import os
import pathlib
import shutil
import tempfile

from environment.messages import Failure, say


def cache_folder():
    """For all that is downloaded or generated; safe to delete."""
    home = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.environ["HOME"], ".cache")
    return pathlib.Path(os.environ.get("LAPLACIAN_LINES_CACHE") or os.path.join(home, "laplacian-lines"))


def compiled_folder():
    """Where ccache keeps what was compiled."""
    return cache_folder() / "ccache"


def publish_into(folder, fill):
    """Has fill(SCRATCH) fill a folder, renamed to `folder` if that returns true, so that an interrupted run leaves no
    incomplete folder for later runs. Returns whether it did."""
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix=folder.name + ".", dir=folder.parent) as name:
            scratch = pathlib.Path(name, folder.name)
            scratch.mkdir()
            if not fill(scratch):
                return False
            shutil.rmtree(folder, ignore_errors=True)
            scratch.rename(folder)
            return True
    except OSError as error:
        say(f"cannot write {folder}: {error.strerror}")
        return False


def put_file(data, target, mode=None):
    """Atomically writes bytes, or a copy of the file of this path, as `target`, or as what that links to, with the usual
    rights or those of `mode`. An existing file stays if the disk is full; devices and pipes are written directly."""
    place = pathlib.Path(os.path.realpath(target))
    if place.is_dir() or not place.parent.is_dir():
        raise Failure(f"cannot write {target}: {'it is a folder' if place.is_dir() else 'there is no such folder'}")
    content = data if isinstance(data, bytes) else pathlib.Path(data).read_bytes()
    try:
        if place.exists() and not place.is_file():
            place.write_bytes(content)
            return
        with tempfile.TemporaryDirectory(prefix=".laplacian_lines_", dir=place.parent) as scratch:
            beside = pathlib.Path(scratch, place.name)
            with beside.open("wb") as file:
                file.write(content)
                file.flush()
                os.fsync(file.fileno())
            if mode is not None:
                beside.chmod(mode)
            beside.rename(place)
    except OSError as error:
        raise Failure(f"cannot write {target}: {error.strerror}; what was there is unchanged") from None


@contextlib.contextmanager
def locked(folder):
    """Locks a folder against other scripts: ./run and ./test may be called at once in one checkout. A killed script's lock
    ends with the last of its programs."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        lock = (folder / ".lock").open("ab")
    except OSError:
        raise Failure(f"{folder} cannot be written into, and what is missing is built there: run this as its owner, or copy "
                      "the checkout to a place of your own") from None
    with lock:
        os.set_inheritable(lock.fileno(), True)
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            say(f"another run is building in {folder}: waiting until it is done")
            fcntl.flock(lock, fcntl.LOCK_EX)
        yield
