# SPDX-License-Identifier: GPL-3.0-or-later
# The plugins as packages.

require environment/messages environment/turns environment/whole_files

packages_are_whole() {
    dpkg-deb --fsys-tarfile "$1"/*.deb >/dev/null && cmake -E tar tf "$1"/*.zip >/dev/null
}

# make_packages BUILD FOLDER: of the plugins that are built there, in place of those in FOLDER, which stay if they cannot be
# made
make_packages() {
    local build=$1 folder=$2 scratch=$1/packages.new package
    say "making the packages"
    take_turn "$build"
    rm -rf "$scratch"
    # CPack would first build all that can be built; it does not for generators without a target "preinstall".
    quietly "$scratch.log" cpack --config "$build/CPackConfig.cmake" -D CPACK_CMAKE_GENERATOR=Ninja \
        -D CPACK_OUTPUT_FILE_PREFIX="$scratch" -B "$scratch" && packages_are_whole "$scratch" || {
        rm -rf "$scratch"
        fail "the packages could not be made; the whole output is in $scratch.log"
    }
    mkdir -p "$folder"
    for package in "$scratch"/*.{deb,zip}; do
        put_file "$package" "$folder/${package##*/}"
        say "$folder/${package##*/}"
    done
    for package in "$folder"/*.{deb,zip}; do
        [[ -e $scratch/${package##*/} ]] || rm -f "$package" # of another version
    done
    rm -rf "$scratch"
    end_turn
}
