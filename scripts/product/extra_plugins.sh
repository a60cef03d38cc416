# SPDX-License-Identifier: GPL-3.0-or-later
# The folder from which MeshLab 2022.02 and later load plugins that a user has added.

require environment/messages environment/packages environment/whole_files product/stage

# expect_extra_plugins PACKAGES: PACKAGES is where ./run --package puts what is for all users
expect_extra_plugins() {
    has_extra_plugins || fail "MeshLab $(meshlab_version) loads no plugins from a user's folder; to have them for all users, run ./run --package and, as root, apt install $1/*.deb"
}

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

# is_installed FILE: by install_plugins, and unchanged since
is_installed() {
    [[ -e $(install_record) ]] && grep -qxF "file $(checksum "$1") $1" "$(install_record)"
}

# recorded KIND: its lines of the record
recorded() {
    [[ ! -e $(install_record) ]] || grep "^$1 " "$(install_record)" || true
}

# install_plugins PLUGIN...: into the user's own folder, in place of those installed before. The record has the old and the
# new ones until all are there.
install_plugins() {
    local folder plugin target folders old new
    refuse_installed_plugins "$@"
    folder=$(extra_plugins_folder "$(user_data_folder)")
    for plugin in "$@"; do
        target=$folder/$(basename "$plugin")
        [[ ! -e $target ]] || is_installed "$target" ||
            fail "$target is there already, but ./run has not installed it; remove it first"
    done
    make_folders "$(dirname "$(install_record)")" >/dev/null
    folders=$(recorded folder && make_folders "$folder")
    old=$(recorded file)
    new=$(for plugin in "$@"; do printf 'file %s %s\n' "$(checksum "$plugin")" "$folder/$(basename "$plugin")"; done)
    put_file <(printf '%s\n' "$folders" "$old" "$new") "$(install_record)"
    for plugin in "$@"; do
        put_file "$plugin" "$folder/$(basename "$plugin")"
    done
    { grep -vF " $folder/" <<<"$old" || true; } | remove_recorded # of another version of MeshLab
    put_file <(printf '%s\n' "$folders" "$new") "$(install_record)"
    say "installed in $folder; ./run --uninstall removes them"
}

uninstall_plugins() {
    local record
    record=$(install_record)
    [[ -e $record ]] || fail "./run --install has installed nothing here"
    tac "$record" | remove_recorded
    rm "$record"
    rmdir --ignore-fail-on-non-empty "$(dirname "$record")"
}

# remove_recorded: what the lines on stdin tell of
remove_recorded() {
    local kind path
    while read -r kind _ path; do
        if [[ $kind == folder ]]; then
            [[ ! -d $path ]] || rmdir --ignore-fail-on-non-empty "$path"
        elif [[ ! -e $path ]]; then
            continue
        elif is_installed "$path"; then
            rm "$path"
            say "removed $path"
        else
            say "left alone, because it is not what ./run has installed: $path"
        fi
    done
}
