# SPDX-License-Identifier: GPL-3.0-or-later
# STAGE/bin/meshlab and meshlabserver: the installed MeshLab with our plugins beside its own, and with nothing written
# outside STAGE. Nothing that is as it should be is touched: another MeshLab may just be starting from there.

require environment/turns environment/whole_files product/server

multiarch() {
    dpkg-architecture -qDEB_HOST_MULTIARCH 2>/dev/null || gcc -print-multiarch
}

installed_meshlab_folder() {
    printf '/usr/lib/%s/meshlab\n' "$(multiarch)"
}

# stage_meshlab STAGE PLUGIN...
stage_meshlab() {
    local stage=$1
    take_turn "$stage"
    mkdir -p "$stage/bin"
    copy_meshlab "$stage/system" "${@:2}"
    stage_program "$stage" meshlab
    if [[ -e /usr/bin/meshlabserver ]]; then
        stage_program "$stage" meshlabserver
    else
        stage_server "$@"
    fi
    end_turn
}

# copy_meshlab FOLDER PLUGIN...: MeshLab finds its libraries, plugins and shaders from the place of its executable, if that
# one's folder is called "bin". Executables have to be copies, because Qt follows links.
copy_meshlab() {
    local folder=$1 installed libraries name
    installed=$(installed_meshlab_folder)
    libraries=$folder/lib/$(multiarch)/meshlab
    mkdir -p "$folder/bin" "$folder/share"
    for name in meshlab meshlabserver; do
        [[ -e /usr/bin/$name ]] || continue
        # A running MeshLab may hold the old copy: it is replaced instead of written into.
        cmp -s "/usr/bin/$name" "$folder/bin/$name" || put_file "/usr/bin/$name" "$folder/bin/$name" 755
    done
    link_all "$libraries" "$installed"/*.so
    # MeshLab loads both of two plugins with the same decorations and stops at their parameters: ours replaces an
    # installed one of the same name.
    link_all "$libraries/plugins" "$installed"/plugins/*.so "${@:2}"
    link_all "$folder/share" /usr/share/meshlab
}

# link_all FOLDER FILE...: the links in FOLDER are to these files; of two with the same name, to the last one
link_all() {
    local folder=$1 file link
    local -A files=()
    for file in "${@:2}"; do files[${file##*/}]=$file; done
    mkdir -p "$folder"
    for link in "$folder"/*; do
        [[ ! -L $link || -n ${files[${link##*/}]:-} ]] || rm "$link"
    done
    for file in "${files[@]}"; do
        link=$folder/${file##*/}
        [[ -L $link && $link -ef $file ]] || ln -sfn "$file" "$link"
    done
}

# stage_program STAGE NAME: from 2022.02 on, MeshLab would also load the plugins that the user has added: give it
# another folder to look for them. Its OpenGL needs an X display, also on Wayland. Plugins that are compiled with
# sanitizers need their library, $SANITIZER_LIBRARY, in the program.
stage_program() {
    write_program "$1/bin/$2" <<-END
		#!/bin/sh
		${SANITIZER_LIBRARY:+export LD_PRELOAD=$SANITIZER_LIBRARY}
		XDG_DATA_HOME=$(printf %q "$1/system/data") QT_QPA_PLATFORM=xcb exec $(printf %q "$1/system/bin/$2") "\$@"
	END
}

write_program() {
    put_file /dev/stdin "$1" 755
}
