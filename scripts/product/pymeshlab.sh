# SPDX-License-Identifier: GPL-3.0-or-later
# PyMeshLab as a host of the filter plugin: a Python environment in the cache folder, and a build for the MeshLab that
# its package holds, which is of double precision and no other one's. Functions that cannot do their work set OBSTACLE.

require environment/build environment/cache environment/headers environment/meshlab_releases environment/messages
require environment/obstacles environment/packages environment/python_environments

PYMESHLAB_VERSION=2025.7
PYMESHLAB_MESHLAB=2025.07 # what it is made of, by its number and the host that has the same
PYMESHLAB_HOST=2025
PYTHON_PACKAGES=("pymeshlab==$PYMESHLAB_VERSION" numpy matplotlib)

# ensure_pymeshlab: sets PYMESHLAB_PYTHON
ensure_pymeshlab() {
    ensure_python_environment pymeshlab "$PYMESHLAB_VERSION" "0.5 GB" "${PYTHON_PACKAGES[@]}" || return 1
    PYMESHLAB_PYTHON=$ENVIRONMENT_PYTHON
}

# ensure_pymeshlab_headers: sets MESHLAB_SOURCE_DIR
ensure_pymeshlab_headers() {
    MESHLAB_SOURCE_DIR=$(cache_folder)/headers/$PYMESHLAB_MESHLAB
    [[ -d $MESHLAB_SOURCE_DIR/src/common ]] && return 0
    say "fetching the headers of MeshLab $PYMESHLAB_MESHLAB from the source package of Debian ${HOST_SUITE[$PYMESHLAB_HOST]}"
    publish_into "$MESHLAB_SOURCE_DIR" unpack_headers meshlab "${HOST_SUITE[$PYMESHLAB_HOST]}" &&
        [[ $(cat "$MESHLAB_SOURCE_DIR/ML_VERSION") == "$PYMESHLAB_MESHLAB" ]] && return 0
    rm -rf "$MESHLAB_SOURCE_DIR"
    obstacle "the source of MeshLab $PYMESHLAB_MESHLAB could not be fetched; unpack it yourself to $MESHLAB_SOURCE_DIR"
}

# build_for_pymeshlab CHECKOUT TARGET CMAKE_OPTIONS...: in CHECKOUT/build/pymeshlab; call it in a subshell
build_for_pymeshlab() {
    local checkout=$1 target=$2 package
    shift 2
    package=$("$PYMESHLAB_PYTHON" -c 'import importlib.util as u; print(u.find_spec("pymeshlab").submodule_search_locations[0])') ||
        fail "$PYMESHLAB_PYTHON has no PyMeshLab"
    export LAPLACIAN_LINES_BUILD=$checkout/build/pymeshlab
    ensure_packages "${BUILD_PACKAGES[@]}" "${TEST_PACKAGES[@]}"
    say "building the filter for PyMeshLab $PYMESHLAB_VERSION"
    build_targets "$checkout" "$target" -- -DMESHLAB_COMMON_LIBRARY="$package/lib/libmeshlab-common.so" \
        -DLAPLACIAN_LINES_PYTHON="$PYMESHLAB_PYTHON" "$@"
}

# run_python CHECKOUT ARGS...: Python with PyMeshLab and the module laplacian_lines
run_python() {
    local checkout=$1
    shift
    ensure_pymeshlab && ensure_pymeshlab_headers || fail "$OBSTACLE"
    (build_for_pymeshlab "$checkout" filter_laplacian_lines) || exit 1
    PYTHONPATH=$checkout/build/pymeshlab/python${PYTHONPATH:+:$PYTHONPATH} "$PYMESHLAB_PYTHON" "$@"
}
