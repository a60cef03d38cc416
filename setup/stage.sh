# SPDX-License-Identifier: GPL-3.0-or-later
# A relocatable MeshLab 2020.09 that loads the system's plugins and ours, with nothing written outside the build folder.
#
# MeshLab finds its library and plugins from the place of its executable: ../lib/ARCHITECTURE/meshlab, if the
# executable's folder is called "bin". The executables have to be copies, because Qt follows links.

multiarch() {
    dpkg-architecture -qDEB_HOST_MULTIARCH 2>/dev/null || gcc -print-multiarch
}

# stage_meshlab STAGE PLUGIN...: sets up STAGE/bin/meshlab and STAGE/bin/meshlabserver.
stage_meshlab() {
    local stage=$1 installed plugins plugin name
    shift
    [[ $(meshlab_version) == 2020.* ]] ||
        fail "MeshLab $(meshlab_version) cannot be staged yet, only 2020.09; install the plugins with cmake --install instead"
    installed=/usr/lib/$(multiarch)/meshlab
    plugins=$stage/lib/$(multiarch)/meshlab/plugins
    mkdir -p "$stage/bin" "$plugins"
    for name in meshlab meshlabserver; do
        # A running MeshLab may hold the old copy: replace it instead of writing into it.
        cmp -s "/usr/bin/$name" "$stage/bin/$name" || install "/usr/bin/$name" "$stage/bin/"
    done
    ln -sfn "$installed/libmeshlab-common.so" "$plugins/.."
    find "$plugins" -type l -delete
    ln -s "$installed"/plugins/*.so "$plugins"
    # MeshLab loads both of two plugins with the same decorations and stops at their parameters: ours replaces an
    # installed one of the same name.
    for plugin in "$@"; do
        ln -sfn "$plugin" "$plugins"
    done
}
