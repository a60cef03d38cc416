# SPDX-License-Identifier: GPL-3.0-or-later
# STAGE/bin/meshlab: the installed MeshLab with our plugins beside its own, and with nothing written outside STAGE.

multiarch() {
    dpkg-architecture -qDEB_HOST_MULTIARCH 2>/dev/null || gcc -print-multiarch
}

installed_meshlab_folder() {
    printf '/usr/lib/%s/meshlab\n' "$(multiarch)"
}

# stage_meshlab STAGE PLUGIN...
stage_meshlab() {
    if has_extra_plugins; then
        stage_extra_plugins "$@"
        stage_server "$@"
    else
        stage_copy "$@"
    fi
}

# MeshLab 2020.09 finds its library and plugins from the place of its executable: ../lib/ARCHITECTURE/meshlab, if the
# executable's folder is called "bin". The executables have to be copies, because Qt follows links.
stage_copy() {
    local stage=$1 installed plugins plugin name
    shift
    installed=$(installed_meshlab_folder)
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

# From 2022.02 on, MeshLab also loads the plugins in a folder of the user's data: here, a data folder of the stage.
# Settings stay those of the user.
stage_extra_plugins() {
    local stage=$1 plugin folder
    shift
    refuse_installed_plugins "$@"
    folder=$(extra_plugins_folder "$stage/data")
    mkdir -p "$stage/bin" "$folder"
    find "$folder" -type l -delete
    for plugin in "$@"; do
        ln -s "$plugin" "$folder"
    done
    # MeshLab's OpenGL needs an X display, also on Wayland.
    write_program "$stage/bin/meshlab" <<-END
		#!/bin/sh
		XDG_DATA_HOME=$(printf %q "$stage/data") QT_QPA_PLATFORM=xcb exec /usr/bin/meshlab "\$@"
	END
}

write_program() {
    cat >"$1"
    chmod +x "$1"
}
