# SPDX-License-Identifier: GPL-3.0-or-later
# STAGE/bin/meshlabserver: MeshLab 2020.09 has one; for later versions, our own program of the same arguments.

require environment/messages product/stage

# stage_server STAGE PLUGIN...: with the filters among the plugins
stage_server() {
    local stage=$1 plugin arguments=()
    shift
    for plugin in "$@"; do
        [[ $plugin != */libfilter_* ]] || arguments+=(--plugin "$plugin")
    done
    {
        printf '#!/bin/sh\nexec'
        printf ' %q' "$(dirname "$stage")/bin/laplacian_lines_server" "${arguments[@]}"
        printf ' "$@"\n'
    } | write_program "$stage/bin/meshlabserver"
}

# expect_outputs BEGUN ARGS...: MeshLab 2020.09's meshlabserver ends with 0, too, when it cannot write; says what is older
# than the file BEGUN, or not there, of what ARGS name for writing
expect_outputs() {
    local begun=$1 word is_output=false missing=0
    shift
    for word in "$@"; do
        if $is_output && [[ ! $word -nt $begun ]]; then
            say "$word was not written"
            missing=1
        fi
        is_output=false
        [[ $word != -o ]] || is_output=true
    done
    return "$missing"
}

# blame_reader STAGE ARGS...: MeshLab 2020.09's meshlabserver has ended by a signal, which loses what it has said: says
# which of the meshes to read does that alone
blame_reader() {
    local stage=$1 word is_mesh=false
    shift
    for word in "$@"; do
        [[ $word != -* ]] || is_mesh=false
        if $is_mesh && ends_by_signal "$stage/bin/meshlabserver" -i "$word"; then
            say "$word: MeshLab's own reader of .${word##*.} files ends meshlabserver; the file may be damaged"
        fi
        [[ $word != -i ]] || is_mesh=true
    done
}

# ends_by_signal COMMAND...
ends_by_signal() {
    local code=0
    { "$@" >/dev/null 2>&1; } 2>/dev/null || code=$?
    ((code > 128 && code < 192)) # signals; 255 is meshlabserver's own
}
