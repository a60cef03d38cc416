# SPDX-License-Identifier: GPL-3.0-or-later
"""What the scripts tell the user: one line a step, on stderr so that stdout stays the program's own. The output of
other programs is kept in logs. And how scripts end: with what they have begun, when a signal comes."""

import contextlib
import os
import pathlib
import signal
import subprocess
import sys


class Failure(Exception):
    """What the user is told before the script ends with code 1."""


class Obstacle(Exception):
    """Why something cannot be had here, where that is no error of the script: the caller decides what follows."""


def say(text):
    line = f"laplacian-lines: {text}\n"
    try:
        line = os.fsencode(line)
    except UnicodeEncodeError:  # more than the user's locale can say
        line = line.encode("utf-8", "surrogateescape")
    sys.stderr.flush()
    os.write(2, line)


def exit_code(returncode):
    """As shells tell it: 128 and the signal."""
    return returncode if returncode >= 0 else 128 - returncode


class Signals:
    """A signal ends the script at once; one that comes while a process is begun, as soon as that can be ended, too."""

    def __init__(self):
        self.held, self.others, self.code = False, False, 0

    def take(self, number, _):
        if number == signal.SIGINT and self.others:
            return
        self.code = 128 + number
        if not self.held:
            sys.exit(self.code)

    def __enter__(self):
        self.held = True

    def __exit__(self, *_):
        self.held = False
        if self.code:
            sys.exit(self.code)


signals = Signals()


def run_main(main):
    """Runs main(), which returns an exit code or None, and ends the script."""
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signals.take)
    try:
        code = main()
    except Failure as failure:
        if str(failure):
            say(failure)
        code = 1
    sys.exit(code)


def run(command, interactive=False, **options):
    """The exit code of a command in the foreground, which ends with this script; of an interactive one, Ctrl+C is its
    own affair."""
    process, signals.others = None, interactive
    try:
        with signals:
            process = subprocess.Popen(command, **options)
        return exit_code(process.wait())
    finally:
        signals.others = False
        if process and process.poll() is None:
            process.terminate()


@contextlib.contextmanager
def started(command, **options):
    """A process, which ends at the end of the block with all that it has begun."""
    process = None
    try:
        with signals:
            process = subprocess.Popen(command, start_new_session=True, **options)
        yield process
    finally:
        if process and process.poll() is None:
            os.killpg(process.pid, signal.SIGTERM)


def run_together(jobs):
    """Runs jobs at once, each a log, a command and options of Popen; whether each succeeds. What they begin keeps the
    turns of this script (see files.py)."""
    with contextlib.ExitStack() as stack:
        processes = []
        for log, command, options in jobs:
            pathlib.Path(log).parent.mkdir(parents=True, exist_ok=True)
            file = stack.enter_context(open(log, "wb"))
            processes.append(stack.enter_context(started(command, stdout=file, stderr=file, close_fds=False,
                                                         **options)))
        return [process.wait() == 0 for process in processes]


def show_end(log):
    os.write(2, b"".join(pathlib.Path(log).read_bytes().splitlines(keepends=True)[-40:]))


def quietly(log, command, **options):
    """Whether the command succeeds. Its output goes to the log, its end to the user when the command fails."""
    (succeeded,) = run_together([(log, command, options)])
    if not succeeded:
        show_end(log)
    return succeeded


@contextlib.contextmanager
def logged(log):
    """What is printed in the block goes to the log."""
    kept = os.dup(1), os.dup(2)
    with open(log, "wb") as file:
        for number in (1, 2):
            os.dup2(file.fileno(), number)
    try:
        yield
    finally:
        sys.stdout.flush()
        for number, was in zip((1, 2), kept):
            os.dup2(was, number)
            os.close(was)


def output(*command, **options):
    """What a command prints, without the last line's end; None if it fails or is not there."""
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, **options)
    except OSError:
        return None
    return os.fsdecode(done.stdout).rstrip("\n") if done.returncode == 0 else None


def duration(seconds):
    """In words."""
    return f"{seconds:.0f} s" if seconds < 60 else f"{int(seconds) // 60} min {int(seconds) % 60} s"
