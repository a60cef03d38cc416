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

# build_folder CHECKOUT: a root's build is apart from this machine's
build_folder() {
    printf '%s\n' "${LAPLACIAN_LINES_BUILD:-$1/build}"
}

# configure CHECKOUT CMAKE_OPTIONS...: without MESHLAB_SOURCE_DIR, as it was configured before or the core alone
configure() {
    local checkout=$1 build
    shift
    build=$(build_folder "$checkout")
    quietly "$build/configure.log" cmake -S "$checkout" -B "$build" \
        ${MESHLAB_SOURCE_DIR:+-DMESHLAB_SOURCE_DIR="$MESHLAB_SOURCE_DIR"} "$@" || fail "cmake could not configure the build"
}

# compile CHECKOUT TARGETS...: all targets when none is named
compile() {
    local build log
    build=$(build_folder "$1")
    log=$build/build.log
    shift
    quietly "$log" cmake --build "$build" --parallel "$(nproc)" ${1:+--target "$@"} ||
        fail "the build failed; its whole output is in $log"
}
