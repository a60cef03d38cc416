#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A file that scripts write is there whole, or what was there before; devices and pipes are written into.
set -euo pipefail

# shellcheck source=/dev/null
source "$(readlink -f "$(dirname "${BASH_SOURCE[0]}")")/../../scripts/require.sh" environment/cache \
    environment/headers environment/messages environment/whole_files product/extra_plugins product/models product/picture \
    product/server product/stage
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
head -c 100000 /dev/zero >new
mkdir place folder
target="place/s%d \\n.png"

put_file new "$target"
cmp new "$target" || fail "the file is another one"
[[ $(stat -c %a "$target") == $(printf '%o' $((0666 & ~$(umask)))) ]] || fail "the file has other rights than usual"
echo old >"$target"
for kilobytes in 1 50 97; do
    ! (ulimit -f "$kilobytes" && put_file new "$target") 2>log || fail "$kilobytes kB were enough"
    [[ $(<"$target") == old && $(find place -type f | wc -l) == 1 ]] || fail "something is left, or the old file is lost"
    grep -qF "cannot write $target: File too large; what was there is unchanged" log || fail "nothing says so: $(<log)"
done
! (put_file new folder) 2>log && grep -q 'it is a folder' log || fail "a folder is not a file: $(<log)"
! (put_file new nowhere/a.png) 2>log && grep -q 'no such folder' log || fail "of a folder that is not there: $(<log)"

ln -s "$target" link
put_file new link
[[ -L link ]] && cmp new "$target" || fail "not the file that the link names is written"
ln -sf /dev/null link
put_file new link
[[ -c /dev/null && -L link ]] || fail "a device was replaced"
mkfifo pipe
cat <pipe >what_was_read &
put_file new pipe
wait "$!"
[[ -p pipe ]] && cmp new what_was_read || fail "a pipe is not written into"

[[ $(plain_label '@a%w\n') == '\@a%%w\\n' ]] || fail "labels say something to ImageMagick"
[[ $(plain_label $'a\ngrab b') == 'a?grab b' ]] || fail "labels have several lines"
[[ $(plain_label $'caf\xe9 ü') == 'caf? ??' && $(plain_label 'ü') == 'ü' ]] || fail "labels are no UTF-8"
cp new $'mesh\ngrab b.ply'
drivable_mesh $'mesh\ngrab b.ply' folder 2>/dev/null
[[ $MESH != *$'\n'* ]] && cmp new "$MESH" || fail "a name of a mesh is a command: $MESH"

touch -d '2001-01-01' older
touch -d '2001-01-02' begun
expect_outputs begun -i older -o new -o "$target" || fail "outputs that are there are missed"
! expect_outputs begun -o new -o older -o nowhere/a.ply 2>log || fail "outputs that were not written are not missed"
[[ $(<log) == *"older was not written"*"nowhere/a.ply was not written" ]] || fail "it says: $(<log)"

# --- what is kept in the cache and in the user's folders

# within KILOBYTES COMMAND...: fails for files that get larger, and says which one
within() {
    ! (ulimit -f "$1" && "${@:2}") 2>log || fail "not refused: ${*:2}"
}

export LAPLACIAN_LINES_CACHE=$work/cache XDG_DATA_HOME=$work/data
bumpy_torus
cp "$MESH" torus.ply
within 100 bumpy_torus
cmp torus.ply "$MESH" && grep -qF "cannot write $MESH: File too large" log || fail "the model is lost: $(<log)"

fill() { head -c 100000 /dev/zero >"$1/file"; }
publish_into cache/thing fill
within 50 publish_into cache/thing fill
[[ $(stat -c %s cache/thing/file) == 100000 && $(ls cache) == $'models\nthing' ]] || fail "half a folder is left"
! publish_into new/thing touch called 2>log && [[ ! -e called ]] || fail "a folder was filled that cannot be made"

apt-get() { touch called; }
mkdir full
ln -s /dev/full full/apt.conf
! source_apt_get full update 2>log && [[ ! -e called ]] || fail "apt-get runs with half of its configuration"

echo old | write_program program
within 1 write_program program <new
[[ -x program && $(<program) == old ]] || fail "half a program is left: $(<log)"

# a MeshLab that loads users' plugins
# shellcheck disable=SC2317
meshlab_version() { echo 2022.02+x; }
refuse_installed_plugins() { :; }
mkdir plugins
head -c 50000 /dev/urandom >plugins/liba.so
head -c 90000 /dev/urandom >plugins/libb.so
install_plugins plugins/*.so 2>/dev/null
folder=$(extra_plugins_folder "$XDG_DATA_HOME")
cp -r plugins old
head -c 50000 /dev/urandom >plugins/liba.so
head -c 90000 /dev/urandom >plugins/libb.so
within 60 install_plugins plugins/*.so
grep -qF "cannot write $folder/libb.so: File too large" log || fail "nothing says what could not be installed: $(<log)"
cmp plugins/liba.so "$folder/liba.so" && cmp old/libb.so "$folder/libb.so" || fail "half a plugin is installed"
within 1 install_plugins plugins/*.so
cmp plugins/liba.so "$folder/liba.so" && cmp old/libb.so "$folder/libb.so" || fail "what was installed is lost"
install_plugins plugins/*.so 2>/dev/null
cmp plugins/libb.so "$folder/libb.so" || fail "the new plugins are not installed"
meshlab_version() { echo 2025.07+x; }
install_plugins plugins/*.so 2>/dev/null
[[ ! -e $folder/liba.so ]] || fail "plugins of another version are left"
uninstall_plugins 2>/dev/null
[[ -z $(find "$XDG_DATA_HOME" -mindepth 1) ]] || fail "left: $(find "$XDG_DATA_HOME")"
