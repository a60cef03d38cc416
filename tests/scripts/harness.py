# SPDX-License-Identifier: GPL-3.0-or-later
"""What tests of the scripts share: unittest, with an empty folder of its own for each test, in which it is."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

CHECKOUT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(CHECKOUT / "scripts"))
os.environ["PYTHONPATH"] = str(CHECKOUT / "scripts")

from environment.messages import Failure


class ScriptTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        self.addCleanup(os.environ.update, dict(os.environ))
        self.work = pathlib.Path(os.path.realpath(folder.name))
        os.chdir(self.work)
        os.environ.pop("LAPLACIAN_LINES_BUILD", None)

    def said_by(self, function, *words, **options):
        """What a script that does no more than this tells the user."""
        kept = os.dup(2)
        with tempfile.TemporaryFile() as log:
            os.dup2(log.fileno(), 2)
            try:
                function(*words, **options)
            finally:
                os.dup2(kept, 2)
                os.close(kept)
                log.seek(0)
                said = os.fsdecode(log.read())
        return said

    def refused(self, regex, function, *words, **options):
        """The function fails with a sentence that matches."""
        with self.assertRaisesRegex(Failure, regex):
            function(*words, **options)
