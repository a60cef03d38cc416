# SPDX-License-Identifier: GPL-3.0-or-later
# Why something cannot be had here, where that is not an error of the script: the caller decides what follows from it.
# Functions that cannot do their work set OBSTACLE to the reason and return 1.

OBSTACLE=

obstacle() {
    OBSTACLE=$*
    return 1
}
