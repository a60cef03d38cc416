# SPDX-License-Identifier: GPL-3.0-or-later
# STAGE/bin/meshlabserver for MeshLab 2022.02 and later, which have none: our own program of the same arguments.

require product/stage

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
