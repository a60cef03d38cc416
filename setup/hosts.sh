# SPDX-License-Identifier: GPL-3.0-or-later
# The programs that load the plugins ("hosts"), and how the tests run in each of them.

# MeshLab by the year in its version, and the release of Debian that packages it. The one that is installed here is
# used where it is; the others need a root.
HOSTS=(2020 2022 2025)
declare -A HOST_SUITE=([2020]=bookworm [2022]=trixie [2025]=forky)

is_host() {
    [[ $1 == pymeshlab || -n ${HOST_SUITE[$1]:-} ]]
}

# host_is_here HOST: whether it is the MeshLab that is installed on this machine
host_is_here() {
    [[ $(meshlab_version 2>/dev/null) == "$1".* ]]
}

# run_tests CHECKOUT LABEL REGEX...: builds and runs the tests with the MeshLab installed here; with a LABEL only those
# that have it, without any also the core's
run_tests() {
    local checkout=$1 label=$2 options=(--output-on-failure --parallel "$(nproc)") target=()
    shift 2
    ensure_toolchain "${DISPLAY_PACKAGES[@]}" "${TEST_PACKAGES[@]}"
    [[ -z $label ]] || { options+=(--label-regex "$label") target=(meshlab_tests); }
    ((!$#)) || options+=(--tests-regex "$(IFS='|' && printf '%s' "$*")")
    say "building the plugins and the tests for MeshLab $(meshlab_version)"
    configure "$checkout" -DLAPLACIAN_LINES_BUILD_TESTS=ON -DLAPLACIAN_LINES_WERROR=ON
    compile "$checkout" "${target[@]}"
    say "running the tests"
    ctest --test-dir "$(build_folder "$checkout")" "${options[@]}"
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
