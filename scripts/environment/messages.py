# SPDX-License-Identifier: GPL-3.0-or-later
"""What scripts print: one line a step, on stderr, since stdout is the program's; other programs' output goes to logs.
And how scripts end on a signal: with what they have started."""

import contextlib
import os
import pathlib
import signal
import subprocess
import sys


class Failure(Exception):
    """Printed before the script ends with code 1."""


class Unavailable(Exception):
    """Something is not available here, which is no error of the script: the caller decides."""


def say(text):
    sys.stderr.flush()
    os.write(2, f"laplacian-lines: {text}\n".encode("utf-8", "surrogateescape"))


def skip(reason):
    """Ends a test, as a failure where LAPLACIAN_LINES_REQUIRED is set."""
    say(f"skipped: {reason}")
    sys.exit(1 if os.environ.get("LAPLACIAN_LINES_REQUIRED") else 77)  # CTest's SKIP_RETURN_CODE


def exit_code(returncode):
    """As in shells: 128 plus the signal."""
    return returncode if returncode >= 0 else 128 - returncode


def run_main(main):
    """Runs main(), which returns an exit code or None, and ends the script, at once on a signal."""
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda number, _: sys.exit(128 + number))
    try:
        code = main()
    except (Failure, Unavailable) as failure:
        if str(failure):
            say(failure)
        code = 1
    sys.exit(code)


@contextlib.contextmanager
def started(command, **options):
    """A process that is ended with the block if it still runs, and then with all that it has started."""
    process = subprocess.Popen(command, start_new_session=True, **options)
    try:
        yield process
    finally:
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGTERM)
            process.wait()


def run(command, interactive=False, **options):
    """The exit code of a command in the foreground, which ends with this script; an interactive one handles Ctrl+C."""
    process = subprocess.Popen(command, **options)
    handler = signal.signal(signal.SIGINT, signal.SIG_IGN) if interactive else None
    try:
        return exit_code(process.wait())
    finally:
        if interactive:
            signal.signal(signal.SIGINT, handler)
        if process.poll() is None:
            process.terminate()


def run_together(jobs):
    """Runs jobs at once, each a log, a command and options of Popen; whether each succeeds. What they start keeps this
    script's locks (see files.py)."""
    with contextlib.ExitStack() as stack:
        processes = []
        for log, command, options in jobs:
            pathlib.Path(log).parent.mkdir(parents=True, exist_ok=True)
            file = stack.enter_context(open(log, "wb"))
            processes.append(stack.enter_context(started(command, stdout=file, stderr=file, close_fds=False, **options)))
        return [process.wait() == 0 for process in processes]


def quietly(log, command, **options):
    """Whether the command succeeds. Its output goes to the log; on failure the user sees the end."""
    (succeeded,) = run_together([(log, command, options)])
    if not succeeded:
        os.write(2, b"".join(pathlib.Path(log).read_bytes().splitlines(keepends=True)[-40:]))
    return succeeded


def output(*command, **options):
    """What a command prints, without newlines at its end; None if it fails or is not there."""
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, **options)
    except OSError:
        return None
    return os.fsdecode(done.stdout).rstrip("\n") if done.returncode == 0 else None
