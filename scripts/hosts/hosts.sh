# SPDX-License-Identifier: GPL-3.0-or-later
# The programs that load the plugins ("hosts"), and how the tests run in each of them: in the MeshLab that is installed
# here where it is the one, in a root otherwise, or in PyMeshLab.

require environment/build environment/cache environment/meshlab_releases environment/messages
require hosts/pymeshlab_tests hosts/roots hosts/tests_here

is_host() {
    [[ $1 == pymeshlab || -n ${HOST_SUITE[$1]:-} ]]
}

# test_meshlab HOST CHECKOUT REGEX...: the tests in that MeshLab. Sets OBSTACLE when it cannot be set up.
test_meshlab() {
    local host=$1 checkout=$2
    shift 2
    if host_is_here "$host"; then
        (run_tests "$checkout" meshlab "$@")
    else
        test_in_root "$host" "$checkout" "$@"
    fi
}

test_in_root() {
    local host=$1 checkout=$2 build binds models
    shift 2
    ensure_root "${HOST_SUITE[$host]}" "$checkout" || return 1
    build=$checkout/build/host-$host
    mkdir -p "$build" "$(compiled_folder)"
    binds=("ro:$checkout" "rw:$build" "ro:$(cache_folder)/headers" "rw:$(compiled_folder)")
    [[ ! -d $(cache_folder)/models ]] || binds+=("ro:$(cache_folder)/models")
    models=$(dirname "$checkout")/shared/models # scanned models that may lie beside the repository
    [[ ! -d $models ]] || binds+=("ro:$(readlink -f "$models")=$models")
    say "MeshLab $host in $ROOT"
    LAPLACIAN_LINES_BUILD=$build in_root "$ROOT" ro "${binds[@]}" -- "$checkout/test" --host "$host" "$@"
}

# test_host HOST CHECKOUT REGEX...
test_host() {
    if [[ $1 == pymeshlab ]]; then
        test_pymeshlab "${@:2}"
    else
        test_meshlab "$@"
    fi
}
