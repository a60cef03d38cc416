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


class Obstacle(Exception):
    """Something cannot be had here, which is no error of the script: the caller decides."""


def say(text):
    line = f"laplacian-lines: {text}\n"
    try:
        line = os.fsencode(line)
    except UnicodeEncodeError:  # more than the user's locale can say
        line = line.encode("utf-8", "surrogateescape")
    sys.stderr.flush()
    os.write(2, line)


def exit_code(returncode):
    """As in shells: 128 plus the signal."""
    return returncode if returncode >= 0 else 128 - returncode


class Signals:
    """A signal ends the script at once, or as soon as a process that is being started can be ended, too."""

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
    """The exit code of a command in the foreground, which ends with this script; an interactive one handles Ctrl+C."""
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
    """A process that ends with the block, with all that it has started."""
    process = None
    try:
        with signals:
            process = subprocess.Popen(command, start_new_session=True, **options)
        yield process
    finally:
        if process and process.poll() is None:
            os.killpg(process.pid, signal.SIGTERM)


def run_together(jobs):
    """Runs jobs at once, each a log, a command and options of Popen; whether each succeeds. What they start keeps this
    script's locks (see files.py)."""
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
    """Whether the command succeeds. Its output goes to the log; on failure the user sees the end."""
    (succeeded,) = run_together([(log, command, options)])
    if not succeeded:
        show_end(log)
    return succeeded


@contextlib.contextmanager
def logged(log):
    """Sends the block's output to the log."""
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
    """What a command prints, without the last newline; None if it fails or is not there."""
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, **options)
    except OSError:
        return None
    return os.fsdecode(done.stdout).rstrip("\n") if done.returncode == 0 else None


def duration(seconds):
    """In words."""
    return f"{seconds:.0f} s" if seconds < 60 else f"{int(seconds) // 60} min {int(seconds) % 60} s"
