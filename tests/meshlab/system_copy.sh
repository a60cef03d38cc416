# SPDX-License-Identifier: GPL-3.0-or-later
# A copy of the system to install packages in.

require environment/obstacles

# in_copy FOLDER SHARED... -- COMMAND...: runs COMMAND, as root, in a copy of the system that is gone when it ends, and
# which keeps its changes in FOLDER's memory: an overlay. The folders SHARED and /tmp are the system's own; what else is
# mounted is not there.
in_copy() {
    setpriv --pdeathsig KILL unshare --mount --pid --fork --kill-child "$(dirname "${BASH_SOURCE[0]}")/enter_copy" "$@"
}

can_copy_system() {
    ((EUID == 0)) || obstacle "a copy of the system takes root's rights" || return 1
    local folder
    folder=$(mktemp -d)
    in_copy "$folder" -- true 2>/dev/null || obstacle "this machine does not allow overlays of its system"
    local code=$?
    rmdir "$folder"
    return "$code"
}
