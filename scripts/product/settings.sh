# SPDX-License-Identifier: GPL-3.0-or-later
# Parameters of the decoration that are named on the command line. What they are called and which values they take, a
# program knows that is built from the decoration's own table.

require environment/messages

# write_settings BUILD FILE NAME=VALUE...: FILE gets the driver's commands that set them
write_settings() {
    local reason
    reason=$("$1/bin/decoration_settings" "${@:3}" 2>&1 >"$2") || fail "$reason"
}
