#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# OBJ files can be read, in MeshLab's window and by meshlabserver: with all kinds of indices, colors and materials.
# MeshLab 2020.09's own reader ends the program on all of them.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

# to_obj PLY OBJ: of an ASCII file of triangles, with indices of vertices alone and with others
to_obj() {
    awk '/^element vertex/ { vertices = $3 }
        header_read && ++line <= vertices { print "v", $1, $2, $3 }
        header_read && line > vertices { print "f", $2 - vertices, $3 + 1 "/1", $4 + 1 "//2" }
        /^end_header/ { header_read = 1 }' "$1" >"$2"
}

torus "$WORK/torus.ply"
to_obj "$WORK/torus.ply" "$WORK/torus.obj"
drive_lines torus.obj <<'END'
expect-lines
trigger Reload
expect-lines
END

printf 'newmtl red\nKd 1 0 0\n' >"$WORK/colors.mtl"
cat >"$WORK/colors.obj" <<'END'
mtllib colors.mtl
v 0 0 0 1 0 0
v 1 0 0 0 1 0
v 1 1 0 0 0 1
v 0 1 0 1 1 1
v 2 2 0 1 1 1
vt 0 0
vt 1 1
vn 0 0 1
usemtl red
f 1/1/1 2/1/1 3/2/1 4/2/1
f 2/1/1 5/2/1 3/1/1
f -5/1/1 -4/1/1 5/2/1 3/2/1 4/2/1
END
if [[ -x $STAGE/bin/meshlabserver ]]; then
    serve -i colors.obj -o colors.ply -m vc fc
    ((SERVER_CODE == 0)) || fail "meshlabserver ended with $SERVER_CODE"
    expect_text "$WORK/colors.ply" '^element vertex 5$'
    expect_text "$WORK/colors.ply" '^element face 6$'
fi
drive <<'END'
wait
open colors.obj
expect-log Opened mesh .*colors.obj
END

# Only the reader that stands in for MeshLab's: a file whose faces lead nowhere is refused with the reason
[[ $(meshlab_version) == 2020.* ]] || exit 0

# refuses REASON: bad.obj
refuses() {
    drive_to_failure "MeshLab says: Opening Failure: .*bad.obj' $1" <<'END'
wait
open bad.obj
sleep 500
END
    serve -i bad.obj -o none.ply
    ((SERVER_CODE == 255)) || fail "meshlabserver ended with $SERVER_CODE"
    expect_text "$WORK/log" "bad.obj: $1"
}
for index in 0 9 -4; do
    printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 %s\n' "$index" >"$WORK/bad.obj"
    refuses "A face refers to a vertex, a normal or a texture"
done
printf 'v 0 0 0\nv 1 0 0\nl 1 3\n' >"$WORK/bad.obj"
refuses "A line refers to a vertex that the file does not have"
