# SPDX-License-Identifier: GPL-3.0-or-later
# What the scripts tell the user: one line a step, on stderr so that stdout stays the program's own.

say() {
    printf 'laplacian-lines: %s\n' "$*" >&2
}

fail() {
    say "$*"
    exit 1
}
