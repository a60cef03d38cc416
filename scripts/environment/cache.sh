# SPDX-License-Identifier: GPL-3.0-or-later
# One folder holds all that is downloaded or generated; deleting it is always safe.

cache_folder() {
    printf '%s\n' "${LAPLACIAN_LINES_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/laplacian-lines}"
}

# Where ccache keeps what was compiled.
compiled_folder() {
    printf '%s/ccache\n' "$(cache_folder)"
}

# publish_into FOLDER COMMAND ARGS...: run COMMAND ARGS... SCRATCH and rename SCRATCH to FOLDER when it succeeds,
# so that an interrupted run never leaves half a folder that later runs would trust.
publish_into() {
    local folder=$1
    shift
    local scratch
    mkdir -p "$(dirname "$folder")" && scratch=$(mktemp -d "$folder.XXXXXX") || return 1
    if ! "$@" "$scratch"; then
        rm -rf "$scratch"
        return 1
    fi
    # mktemp makes it private; a shared cache should stay readable
    chmod 755 "$scratch" && rm -rf "$folder" && mv -T "$scratch" "$folder"
}
