#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A file that scripts write is there whole, or what was there before; devices and pipes are written into.
set -euo pipefail

# shellcheck source=/dev/null
source "$(readlink -f "$(dirname "${BASH_SOURCE[0]}")")/../../scripts/require.sh" environment/messages \
    environment/whole_files product/picture product/server
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
    grep -q 'what was there is unchanged' log || fail "nothing says so: $(<log)"
done
! (put_file new folder) 2>log && grep -q 'it is a folder' log || fail "a folder is no file: $(<log)"
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
cp new $'mesh\ngrab b.ply'
drivable_mesh $'mesh\ngrab b.ply' folder 2>/dev/null
[[ $MESH != *$'\n'* ]] && cmp new "$MESH" || fail "a name of a mesh is a command: $MESH"

touch -d '2001-01-01' older
touch -d '2001-01-02' begun
expect_outputs begun -i older -o new -o "$target" || fail "outputs that are there are missed"
! expect_outputs begun -o new -o older -o nowhere/a.ply 2>log || fail "outputs that were not written are not missed"
[[ $(<log) == *"older was not written"*"nowhere/a.ply was not written" ]] || fail "it says: $(<log)"
