# SPDX-License-Identifier: GPL-3.0-or-later
"""Files and folders that are written whole or not at all, and locks on folders."""

import contextlib
import fcntl
import os
import pathlib
import shutil
import stat
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
    """Has fill(SCRATCH) fill a folder, renamed to `folder` if that returns true, so that an interrupted run leaves
    nothing half done that later runs would trust. Returns whether it did."""
    scratch = None
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        scratch = pathlib.Path(tempfile.mkdtemp(prefix=folder.name + ".", dir=folder.parent))
        if not fill(scratch):
            return False
        scratch.chmod(0o755)  # mkdtemp makes it private; a shared cache should stay readable
        shutil.rmtree(folder, ignore_errors=True)
        scratch.rename(folder)
    except OSError as error:
        say(f"cannot write {folder}: {error.strerror}")
        return False
    finally:
        if scratch:
            shutil.rmtree(scratch, ignore_errors=True)
    return True


def put_file(data, target, mode=None):
    """Writes bytes, or a copy of the file of this path, as `target`, or as what that links to, with the usual rights or
    those of `mode`. What was there is whole until it is replaced, and stays if there is no room; into devices and pipes
    is written."""
    if mode is None:
        mode = 0o666 & ~umask()
    place = pathlib.Path(os.path.realpath(target))
    if not place.parent.is_dir():
        raise Failure(f"cannot write {target}: there is no such folder")
    if place.is_dir():
        raise Failure(f"cannot write {target}: it is a folder")
    try:
        if place.exists() and not stat.S_ISREG(place.stat().st_mode):
            with place.open("wb") as file:
                file.write(data if isinstance(data, bytes) else pathlib.Path(data).read_bytes())
            return
        handle, beside = tempfile.mkstemp(prefix=".laplacian_lines_", dir=place.parent)
    except OSError as error:
        raise Failure(f"cannot write into the folder of {target}: {error.strerror}") from None
    try:
        with open(handle, "wb") as file:
            if isinstance(data, bytes):
                file.write(data)
            else:
                with open(data, "rb") as source:
                    shutil.copyfileobj(source, file)
            file.flush()
            os.fsync(handle)
        os.chmod(beside, mode)
        os.rename(beside, place)
    except BaseException as error:
        os.unlink(beside)
        if not isinstance(error, OSError):
            raise
        raise Failure(f"cannot write {target}: {error.strerror}; what was there is unchanged") from None


def umask():
    mask = os.umask(0)
    os.umask(mask)
    return mask


@contextlib.contextmanager
def turn(folder):
    """Locks a folder against other scripts: ./run and ./test may be called at once in one checkout. The lock also ends
    with its script, when the last of its programs ends."""
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
        except OSError:
            pass  # a file system without locks
        yield
