# SPDX-License-Identifier: GPL-3.0-or-later
# Configure and build, quietly unless something fails.

# quietly LOG COMMAND...: the output goes to LOG, its end to the user when the command fails.
quietly() {
    local log=$1
    shift
    mkdir -p "$(dirname "$log")"
    "$@" >"$log" 2>&1 && return 0
    tail -n 40 "$log" >&2
    return 1
}

# ensure_toolchain EXTRA_PACKAGES...: all that building takes, MeshLab itself included.
ensure_toolchain() {
    ensure_packages "${BUILD_PACKAGES[@]}" "$@"
    ensure_meshlab_recommends
    ensure_headers
}

# configure ROOT CMAKE_OPTIONS...
configure() {
    local root=$1
    shift
    quietly "$root/build/configure.log" cmake -S "$root" -B "$root/build" \
        -DMESHLAB_SOURCE_DIR="$MESHLAB_SOURCE_DIR" "$@" || fail "cmake could not configure the build"
}

# compile ROOT TARGETS...: all targets when none is named
compile() {
    local root=$1 log=$1/build/build.log
    shift
    quietly "$log" cmake --build "$root/build" --parallel "$(nproc)" ${1:+--target "$@"} ||
        fail "the build failed; its whole output is in $log"
}
