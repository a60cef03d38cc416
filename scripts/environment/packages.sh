# SPDX-License-Identifier: GPL-3.0-or-later
# Debian packages: install what is missing, and only that.

require environment/messages

BUILD_PACKAGES=(meshlab g++ make cmake dpkg-dev xz-utils qtbase5-dev libqt5opengl5-dev libglew-dev
    libeigen3-dev libgl-dev libglu1-mesa-dev libgl1-mesa-dri)
DISPLAY_PACKAGES=(xvfb xauth libgl1-mesa-dri fonts-dejavu-core)
CORE_PACKAGES=(g++ make cmake libeigen3-dev) # enough for the core alone
PACKAGING_PACKAGES=(file) # CPack asks it what is a library
TEST_PACKAGES=(python3 libgtest-dev imagemagick ccache librsvg2-bin locales poppler-utils "${PACKAGING_PACKAGES[@]}")

# meshlab 2022 and later show a modal box at start when a bundled plugin misses one of these Recommends;
# 2020.09 depends on all it needs. Names that this distribution does not know are skipped.
MESHLAB_RECOMMENDS=(lib3ds-1-3 libgomp1 libmuparser2v5 libopenctm1 libqhull-r8.0
    libxerces-c3.2t64 libmpfr6 libgmp10)

package_installed() {
    [[ $(dpkg-query -W -f='${db:Status-Abbrev}' "$1" 2>/dev/null) == "ii "* ]]
}

as_root() {
    if ((EUID == 0)); then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo "$@"
    else
        fail "packages are missing and neither root nor sudo is at hand; as root, run: $*"
    fi
}

# missing_packages NAME...: one question for all, since each takes a while
missing_packages() {
    local package
    local -A installed=()
    while read -r package; do installed[$package]=1; done < <(
        dpkg-query -W -f='${db:Status-Abbrev}${Package}\n' "$@" 2>/dev/null | sed -n 's/^ii //p')
    for package in "$@"; do
        [[ -n ${installed[$package]:-} ]] || printf '%s\n' "$package"
    done
}

# ensure_packages NAME...
ensure_packages() {
    local missing
    mapfile -t missing < <(missing_packages "$@" | sort -u)
    ((${#missing[@]})) || return 0
    command -v apt-get >/dev/null || fail "this needs the packages ${missing[*]}, and there is no apt-get to install them"
    say "installing ${missing[*]}"
    as_root apt-get -qq update || say "apt-get update failed; trying with the package lists at hand"
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq -y --no-install-recommends install "${missing[@]}" \
        >/dev/null || fail "could not install ${missing[*]}"
}

meshlab_version() {
    dpkg-query -W -f='${Version}' meshlab
}

# The Recommends matter from 2022 on only; asking apt-cache keeps this free of distribution names.
ensure_meshlab_recommends() {
    [[ $(meshlab_version) == 2020.* ]] && return 0
    local package known=()
    for package in "${MESHLAB_RECOMMENDS[@]}"; do
        apt-cache show "$package" >/dev/null 2>&1 && known+=("$package")
    done
    ensure_packages "${known[@]}"
}
