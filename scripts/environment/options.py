# SPDX-License-Identifier: GPL-3.0-or-later
"""Options of a command line."""

import argparse
import re

from environment.messages import Failure


class Parser(argparse.ArgumentParser):
    """What is wrong is a Failure."""

    def __init__(self, *words, **options):
        super().__init__(*words, allow_abbrev=False, formatter_class=argparse.RawDescriptionHelpFormatter, **options)
        self._negative_number_matcher = re.compile(r"-\d")  # "-30,15" is no option either, as from Python 3.14 on

    def error(self, message):
        raise Failure(f"{message}; see --help")
