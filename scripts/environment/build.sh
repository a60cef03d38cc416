# SPDX-License-Identifier: GPL-3.0-or-later
# Configure and build, quietly unless something fails.

require environment/cache environment/headers environment/messages environment/packages environment/turns

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

# build_targets CHECKOUT TARGETS... [-- CMAKE_OPTIONS...]: configures and compiles, all targets when none is named
build_targets() {
    local checkout=$1 targets=()
    shift
    while (($#)) && [[ $1 != -- ]]; do
        targets+=("$1")
        shift
    done
    take_turn "$(build_folder "$checkout")"
    is_built "$checkout" "${targets[@]}" "$@" || {
        touch "$(build_folder "$checkout")/.begun"
        configure "$checkout" "${@:2}"
        compile "$checkout" "${targets[@]}"
        note_built "$checkout" "${targets[@]}" "$@"
    }
    end_turn
}

# note_built CHECKOUT WORDS...: what was built last, by which words, since .begun
note_built() {
    local build
    build=$(build_folder "$1")
    mv "$build/.begun" "$build/.sources" # what is changed while it is compiled may not be in it
    build_description "$@" >"$build/.built"
}

# is_built CHECKOUT WORDS...: whether that was the latest build, and nothing has been touched since that CMake or make
# would look at. They take seconds to find that out: here are folders of sources, packages, and folders of what was made.
is_built() {
    local build folder sources=() made=()
    build=$(build_folder "$1")
    [[ -e $build/.built && $(<"$build/.built") == "$(build_description "$@")" ]] || return 1
    for folder in "$1"/*/; do
        [[ $folder -ef $build ]] || sources+=("$folder")
    done
    for folder in "$build"/{plugins,driver,bin}; do
        [[ ! -d $folder ]] || made+=("$folder")
    done
    [[ -z $(find "${sources[@]}" "$1/CMakeLists.txt" /var/lib/dpkg/status -newer "$build/.sources" -print -quit 2>&1) &&
        -z $(find "${made[@]}" "$build/CMakeCache.txt" -maxdepth 1 -newer "$build/.built" -print -quit 2>&1) ]]
}

build_description() {
    printf '%s\n' "$@" "${MESHLAB_SOURCE_DIR:-}" "${CXX:-}" "${CXXFLAGS:-}" "${CMAKE_CXX_COMPILER_LAUNCHER:-}"
}

# cached FOLDER NAME: a value of CMake's cache there
cached() {
    sed -n "s/^$2:[A-Z]*=//p" "$1/CMakeCache.txt"
}

# forget_moved_build CHECKOUT BUILD: CMake refuses a build that was made in another place or of another checkout, and
# what it has compiled may belong to the sources there. Builds in folders of BUILD look after themselves.
forget_moved_build() {
    [[ -e $2/CMakeCache.txt ]] || return 0
    [[ ! $(cached "$2" CMAKE_HOME_DIRECTORY) -ef $1 || ! $(cached "$2" CMAKE_CACHEFILE_DIR) -ef $2 ]] || return 0
    say "this checkout was moved or copied with its build: building anew"
    rm "$2/CMakeCache.txt"
    find "$2" -mindepth 1 -type d \( \( -name CMakeFiles -o -name '*_autogen' \) -prune -exec rm -rf {} + \
        -o -exec test -e {}/CMakeCache.txt \; -prune \)
}

# configure CHECKOUT CMAKE_OPTIONS...: without MESHLAB_SOURCE_DIR, as it was configured before or the core alone
configure() {
    local checkout=$1 build launcher=()
    shift
    [[ -n ${CMAKE_CXX_COMPILER_LAUNCHER:-} ]] || ! command -v ccache >/dev/null ||
        launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
    build=$(build_folder "$checkout")
    forget_moved_build "$checkout" "$build"
    quietly "$build/configure.log" cmake -S "$checkout" -B "$build" "${launcher[@]}" -DLAPLACIAN_LINES_PRECOMPILE=ON \
        ${MESHLAB_SOURCE_DIR:+-DMESHLAB_SOURCE_DIR="$MESHLAB_SOURCE_DIR"} "$@" || fail "cmake could not configure the build"
}

# compile CHECKOUT TARGETS...: all targets when none is named. Where there is ccache, nothing is compiled twice, in
# another checkout either. The sloppiness lets it keep precompiled headers; no source of ours uses times.
compile() {
    local checkout=$1 build log
    build=$(build_folder "$1")
    log=$build/build.log
    shift
    CCACHE_DIR=${CCACHE_DIR:-$(compiled_folder)} CCACHE_MAXSIZE=${CCACHE_MAXSIZE:-1G} \
        CCACHE_BASEDIR=$checkout CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=pch_defines,time_macros \
        quietly "$log" cmake --build "$build" --parallel "$(nproc)" ${1:+--target "$@"} ||
        fail "the build failed; its whole output is in $log"
}
