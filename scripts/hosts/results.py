# SPDX-License-Identifier: GPL-3.0-or-later
"""How the stages of a run ended: a line for each as it ends, and all of them at the end of the run."""

import time

from environment.messages import Failure, Obstacle, duration, say


class Results:
    def __init__(self, required):
        """Skipped is what an Obstacle has kept from running, a failure if `required`."""
        self.required, self.lines, self.failed, self.began = required, [], False, time.monotonic()

    def stage(self, name, function, *words):
        """Runs it. It returns a remark on its success, None or "" if there is none. Returns whether it has
        succeeded."""
        began, succeeded = time.monotonic(), False
        try:
            remark = function(*words)
            result, succeeded = f"passed, {remark}" if remark else "passed", True
        except Obstacle as reason:
            result = f"skipped: {reason}"
            self.failed |= self.required
        except Failure as failure:
            if str(failure):
                say(failure)
            result, self.failed = "FAILED", True
        self.lines.append(f"{name}: {result}, {duration(time.monotonic() - began)}")
        say(self.lines[-1])
        return succeeded

    def tell(self):
        """The exit code."""
        if len(self.lines) > 1:
            say("all stages:")
            for line in self.lines:
                say(f"    {line}")
            say(f"    together {duration(time.monotonic() - self.began)}")
        return int(self.failed)
