#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# ./run --install and --uninstall: the MeshLab that the user starts has the plugins in between, and only then.
source "$(dirname "$(readlink -f "$0")")/harness.sh"
require product/extra_plugins

plugins=("$LAPLACIAN_LINES_BUILD"/plugins/*.so)

# refuses REASON COMMAND...
refuses() {
    ! ("${@:2}") 2>"$WORK/log" || fail "not refused: ${*:2}"
    expect_text "$WORK/log" "$1"
}

if ! has_extra_plugins; then
    code=0
    LAPLACIAN_LINES_BUILD=$WORK/build "$CHECKOUT/run" --install 2>"$WORK/log" || code=$?
    ((code == 1)) || fail "installing ended with $code"
    # package.sh does what it says
    expect_text "$WORK/log" "MeshLab 2020.* loads no plugins from a user's folder; .* run ./run --package and, as root, apt install $WORK/build/packages/\\*.deb$"
    [[ ! -e $WORK/build ]] || fail "it was built before it was refused"
    exit
fi

STAGE=$WORK/unchanged # MeshLab itself, with the driver as the user's only plugin
mkdir -p "$STAGE/bin"
ln -s /usr/bin/meshlab "$STAGE/bin"
folder=$(extra_plugins_folder "$(user_data_folder)")
mkdir -p "$folder"
cp "$LAPLACIAN_LINES_BUILD"/driver/*.so "$folder"
ls "$folder" >"$WORK/before"

small_torus "$WORK/torus.ply"
cat >"$WORK/actions" <<'END'
wait
open torus.ply
expect-action Compute Laplacian Lines
expect-action Laplacian Lines unchecked
check Laplacian Lines on
size 300x200
grab lines.png
END

drive_to_failure "no action 'Compute Laplacian Lines'" <"$WORK/actions"
install_plugins "${plugins[@]}"
drive <"$WORK/actions"
install_plugins "${plugins[@]}" # in place of the first ones
uninstall_plugins
drive_to_failure "no action 'Compute Laplacian Lines'" <"$WORK/actions"
diff "$WORK/before" <(ls "$folder") || fail "there are other files than before"
[[ ! -e $(install_record) ]] || fail "the record is left"
refuses '--install has installed nothing here' uninstall_plugins

touch "$folder/$(basename "${plugins[0]}")"
refuses 'is there already, but ./run has not installed it' install_plugins "${plugins[@]}"
