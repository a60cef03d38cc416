# SPDX-License-Identifier: GPL-3.0-or-later
# The plugins as packages.

require environment/build environment/messages

# make_packages CHECKOUT
make_packages() {
    local packages package
    packages=$(build_folder "$1")/packages
    rm -rf "$packages"
    say "making the packages"
    compile "$1" package
    for package in "$packages"/*.deb "$packages"/*.zip; do
        say "$package"
    done
}
