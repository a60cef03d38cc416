# SPDX-License-Identifier: GPL-3.0-or-later
# The folder from which MeshLab 2022.02 and later load plugins that a user has added.

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
    local plugin
    for plugin in "$@"; do
        plugin=$(installed_meshlab_folder)/plugins/$(basename "$plugin")
        [[ ! -e $plugin ]] || fail "$plugin is installed for all users and would be loaded twice; remove it first"
    done
}
