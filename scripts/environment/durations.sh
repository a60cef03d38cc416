# SPDX-License-Identifier: GPL-3.0-or-later
# How long something took.

# duration SECONDS: in words
duration() {
    if (($1 < 60)); then printf '%d s' "$1"; else printf '%d min %d s' $(($1 / 60)) $(($1 % 60)); fi
}
