# SPDX-License-Identifier: GPL-3.0-or-later
# The plugins as packages.

require environment/build environment/messages environment/turns

# make_packages CHECKOUT
make_packages() {
    local packages package
    packages=$(build_folder "$1")/packages
    say "making the packages"
    take_turn "$(build_folder "$1")"
    rm -rf "$packages"
    compile "$1" package
    end_turn
    for package in "$packages"/*.deb "$packages"/*.zip; do
        say "$package"
    done
}
