# SPDX-License-Identifier: GPL-3.0-or-later
"""How the stages of a run ended, and what each took: a line as it ends, and a table at the end of the run."""

import os
import time

from environment.messages import Failure, Obstacle, duration, say


def times():
    """Seconds by the clock, and of processor time by this process and all that it has waited for."""
    spent = os.times()
    return time.monotonic(), sum(spent[:4])


class Results:
    def __init__(self, required):
        """Skipped means kept from running by an Obstacle; a failure if `required`."""
        self.required, self.rows, self.failed, self.began = required, [], False, times()

    def stage(self, name, function, *words):
        """Runs it; a remark that it returns is printed. Returns whether it succeeded."""
        began, succeeded = times(), False
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
        self.note(name, result, began)
        say(f"{name}: {result}, {duration(self.rows[-1][0])}")
        return succeeded

    def note(self, name, result, began):
        self.rows.append((*(now - then for now, then in zip(times(), began)), name, result))

    def tell(self):
        """The exit code."""
        if len(self.rows) > 1:
            self.note("together", "", self.began)
            say("seconds by the clock, of processors:")
            for clock, processor, name, result in self.rows:
                say(f"{clock:7.0f}{processor:7.0f}  {name:28}{result}")
        return int(self.failed)
