#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The packages: MeshLab shows filters and decoration after the .deb is installed, in a copy of the system, and with the
# files of the .zip; removing the .deb leaves nothing.
source "$(dirname "$(readlink -f "$0")")/harness.sh"
require product/extra_plugins product/package
# shellcheck source=/dev/null
source "$CHECKOUT/tests/meshlab/system_copy.sh"

folder=$WORK/packages
mkdir "$folder"
touch "$folder/of_another_version.deb"
make_packages "$LAPLACIAN_LINES_BUILD" "$folder"
deb=$(echo "$folder"/meshlab-laplacian-lines_*.deb)
zip=$(echo "$folder"/meshlab-laplacian-lines-*.zip)
[[ ! -e $folder/of_another_version.deb ]] || fail "old packages are left"

# without room, the packages that are there stay as they are
sums=$(cd "$folder" && sha256sum -- *)
for kilobytes in 50 200 400 800; do
    ! (ulimit -f "$kilobytes" && make_packages "$LAPLACIAN_LINES_BUILD" "$folder") 2>"$WORK/log" ||
        fail "$kilobytes kB are enough for the packages"
    expect_text "$WORK/log" 'the packages could not be made; the whole output is in .*log'
    [[ $(cd "$folder" && sha256sum -- *) == "$sums" && ! -e $LAPLACIAN_LINES_BUILD/packages.new ]] ||
        fail "packages without room are $(ls -l "$folder")"
done

version=$(meshlab_version | grep -oE '^[0-9]+\.[0-9]+')
dpkg-deb --field "$deb" Depends >"$WORK/depends"
expect_text "$WORK/depends" "meshlab \\(>= $version~\\), meshlab \\(<< $version\\.\\), .*libqt5core5"
dpkg-deb --contents "$deb" | awk '$1 !~ /^d/ { print $6 }' | sort >"$WORK/contents"
plugins=.$(installed_meshlab_folder)/plugins
diff "$WORK/contents" <(printf '%s\n' "$plugins/libdecorate_laplacian_lines.so" "$plugins/libfilter_laplacian_lines.so" \
    ./usr/share/doc/meshlab-laplacian-lines/copyright) || fail "the .deb holds other files"
# other packages have these folders too, but for the last
folders_to() { if [[ $1 != . ]]; then folders_to "$(dirname "$1")" && printf '%s/\n' "$1"; fi; }
dpkg-deb --contents "$deb" | awk '$1 ~ /^d/ { print $6 }' | sort -u >"$WORK/contents"
diff "$WORK/contents" <({ folders_to "$plugins" && folders_to ./usr/share/doc/meshlab-laplacian-lines; } | sort -u) ||
    fail "the .deb has other folders"
mkdir "$WORK/zip"
(cd "$WORK/zip" && cmake -E tar xf "$zip" && ls) >"$WORK/contents"
diff "$WORK/contents" <(printf '%s\n' LICENSE README.md libdecorate_laplacian_lines.so libfilter_laplacian_lines.so) ||
    fail "the .zip holds other files"

torus "$WORK/torus.ply"
cat >"$WORK/script.txt" <<'END'
wait
open torus.ply
size 800x600
expect-action Compute Laplacian Lines
expect-action Generate Laplacian Lines Polylines
expect-action Laplacian Lines unchecked
check Laplacian Lines on
setdeco Line Color = #ff0000
setdeco Contour Color = #ff0000
grab lines.png
END

# lines_are_shown: by the MeshLab of this test's stage
lines_are_shown() {
    rm -f "$WORK/lines.png"
    drive <"$WORK/script.txt"
    (($(red_pixels "$WORK/lines.png") > 500)) || fail "no lines are drawn"
}

# the files of the .zip
STAGE=$WORK/zip_stage
stage_meshlab "$STAGE" "$WORK"/zip/*.so "$LAPLACIAN_LINES_BUILD"/driver/*.so
lines_are_shown

# with nothing but the driver, none; in a copy of the system with the .deb, all
STAGE=$WORK/deb_stage
stage_meshlab "$STAGE" "$LAPLACIAN_LINES_BUILD"/driver/*.so
drive_to_failure "no action 'Compute Laplacian Lines'" <"$WORK/script.txt"
if ! can_copy_system; then
    say "skipped: $OBSTACLE"
    exit 77
fi
in_installed_copy() {
    dpkg --install "$deb" >"$WORK/log" 2>&1 || fail "the .deb cannot be installed"
    stage_meshlab "$STAGE" "$LAPLACIAN_LINES_BUILD"/driver/*.so
    lines_are_shown
    # a checkout's plugins replace the installed ones of the same name, but not for the MeshLab that is installed
    stage_meshlab "$STAGE" "$LAPLACIAN_LINES_BUILD"/plugins/*.so "$LAPLACIAN_LINES_BUILD"/driver/*.so
    lines_are_shown
    if has_extra_plugins; then
        ! (install_plugins "$LAPLACIAN_LINES_BUILD"/plugins/*.so) 2>"$WORK/log" || fail "the plugins were installed twice"
        expect_text "$WORK/log" 'would be loaded twice; .* apt remove meshlab-laplacian-lines'
    fi
    dpkg --remove meshlab-laplacian-lines >"$WORK/log" 2>&1 || fail "the package cannot be removed"
    ! grep -i warning "$WORK/log" || fail "removing the package warns"
    ! ls "$(installed_meshlab_folder)"/plugins/*laplacian_lines* || fail "the package leaves files"
}
mkdir "$WORK/copy"
export STAGE WORK deb LAPLACIAN_LINES_BUILD
in_copy "$WORK/copy" "$CHECKOUT" "$LAPLACIAN_LINES_BUILD" -- bash -c "
    set -euo pipefail
    source '$CHECKOUT/scripts/require.sh' environment/messages product/extra_plugins product/stage
    $(declare -f run_driver drive red_pixels expect_text lines_are_shown in_installed_copy)
    DRIVE_SECONDS=$DRIVE_SECONDS
    in_installed_copy" || fail "what the .deb installs does not work"
[[ ! -e /usr/share/doc/meshlab-laplacian-lines ]] || fail "the copy was the system itself"
