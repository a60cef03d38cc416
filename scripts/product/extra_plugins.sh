# SPDX-License-Identifier: GPL-3.0-or-later
# The folder from which MeshLab 2022.02 and later load plugins that a user has added.

require environment/messages environment/packages product/stage

has_extra_plugins() {
    [[ $(meshlab_version) != 2020.* ]]
}

user_data_folder() {
    printf '%s\n' "${XDG_DATA_HOME:-$HOME/.local/share}"
}

# extra_plugins_folder DATA_FOLDER: MeshLab's, which goes by the first two parts of its version
extra_plugins_folder() {
    local version
    version=$(meshlab_version | grep -oE '^[0-9]+\.[0-9]+')
    printf '%s/VCG/MeshLab_64bit_fp/MeshLabExtraPlugins/%s\n' "$1" "$version"
}

# refuse_installed_plugins PLUGIN...: MeshLab would load plugins of the same name twice and stop at their parameters.
refuse_installed_plugins() {
    local plugin package removal
    for plugin in "$@"; do
        plugin=$(installed_meshlab_folder)/plugins/$(basename "$plugin")
        [[ -e $plugin ]] || continue
        package=$(dpkg-query --search "$plugin" 2>/dev/null | sed 's/: .*//') || package=
        [[ -n $package ]] && removal="apt remove $package" || removal="rm $plugin"
        fail "$plugin is installed for all users and would be loaded twice; to install for you alone, first run: sudo $removal"
    done
}

# What install_plugins has made: one line each, "file CHECKSUM PATH" or "folder - PATH".
install_record() {
    printf '%s/laplacian-lines/installed\n' "$(user_data_folder)"
}

checksum() {
    sha256sum <"$1" | cut -d ' ' -f 1
}

# make_folders FOLDER: makes it and what is missing above it, and prints their lines for the record
make_folders() {
    [[ ! -d $1 ]] || return 0
    make_folders "$(dirname "$1")"
    mkdir "$1"
    printf 'folder - %s\n' "$1"
}

# install_plugins PLUGIN...: into the user's own folder, in place of those installed before
install_plugins() {
    local folder record plugin target
    has_extra_plugins || fail "MeshLab $(meshlab_version) loads no plugins from a user's folder; install them for all users: sudo cmake --install build"
    refuse_installed_plugins "$@"
    record=$(install_record)
    [[ ! -e $record ]] || remove_recorded
    folder=$(extra_plugins_folder "$(user_data_folder)")
    for plugin in "$@"; do
        target=$folder/$(basename "$plugin")
        [[ ! -e $target ]] || fail "$target is there already, but ./run has not installed it; remove it first"
    done
    make_folders "$(dirname "$record")" >/dev/null
    make_folders "$folder" >"$record"
    for plugin in "$@"; do
        target=$folder/$(basename "$plugin")
        printf 'file %s %s\n' "$(checksum "$plugin")" "$target" >>"$record"
        install -m 644 "$plugin" "$target"
    done
    say "installed in $folder; ./run --uninstall removes them"
}

uninstall_plugins() {
    [[ -e $(install_record) ]] || fail "./run --install has installed nothing here"
    remove_recorded
}

remove_recorded() {
    local record kind sum path
    record=$(install_record)
    while read -r kind sum path; do
        if [[ $kind == folder ]]; then
            [[ ! -d $path ]] || rmdir --ignore-fail-on-non-empty "$path"
        elif [[ -e $path && $(checksum "$path") != "$sum" ]]; then
            say "left alone, because it is not what ./run has installed: $path"
        elif [[ -e $path ]]; then
            rm "$path"
            say "removed $path"
        fi
    done < <(tac "$record")
    rm "$record"
    rmdir --ignore-fail-on-non-empty "$(dirname "$record")"
}
