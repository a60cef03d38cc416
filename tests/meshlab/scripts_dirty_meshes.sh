#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Meshes with faults in scripts: what is left out is counted in the log, and a mesh without a surface is refused.
# From 2022.02 on, MeshLab itself takes out some of the faults when it opens a mesh.
source "$(dirname "$(readlink -f "$0")")/harness.sh"
require product/extra_plugins

# left_out TEXT: what of it is left for the filter to leave out
left_out() {
    if has_extra_plugins; then
        sed -E 's/[0-9]+ vertices with non-finite coordinates(, )?//; s/[0-9]+ triangles without area(, )?//' <<<"$1"
    else
        printf '%s\n' "$1"
    fi
}

# try VERTICES FACES [LEFT_OUT]: the torus with the vertices and faces, separated by commas, added; all is used, or the
# log says that LEFT_OUT was not
try() {
    awk -v more_vertices="$1" -v more_faces="$2" '
        BEGIN { v = split(more_vertices, vertex, ","); f = split(more_faces, face, ",") }
        /^element vertex/ { $3 += v }
        /^element face/ { $3 += f }
        NF == 4 && $1 == "3" && !added++ { for (i = 1; i <= v; ++i) print vertex[i] }
        { print }
        END { for (i = 1; i <= f; ++i) print face[i] }' "$WORK/torus.ply" >"$WORK/dirty.ply"
    serve -i dirty.ply -s script.mlx -o out.ply
    ((SERVER_CODE == 0)) || fail "the mesh with vertices '$1' and faces '$2' was refused"
    local expected
    expected=$(left_out "${3:-}")
    if [[ -n $expected ]]; then
        expect_text "$WORK/log" "^Left out: $expected\$"
    else
        ! grep -q 'Left out' "$WORK/log" || fail "something of the whole mesh was left out"
    fi
}

# refuse VERTICES FACES: a mesh of nothing but these
refuse() {
    local vertices faces
    IFS=, read -ra vertices <<<"$1"
    IFS=, read -ra faces <<<"$2"
    {
        printf 'ply\nformat ascii 1.0\nelement vertex %s\nproperty float x\nproperty float y\nproperty float z\n' ${#vertices[@]}
        printf 'element face %s\nproperty list uchar int vertex_indices\nend_header\n' ${#faces[@]}
        printf '%s\n' "${vertices[@]}" "${faces[@]}"
    } >"$WORK/dirty.ply"
    serve -i dirty.ply -s script.mlx -o none.ply
    ((SERVER_CODE != 0)) || fail "the mesh of vertices '$1' and faces '$2' was accepted"
    expect_text "$WORK/log" 'The mesh has no triangle with an area|The mesh lacks: Any Faces'
    [[ ! -e $WORK/none.ply ]] || fail "a mesh was written"
}

small_torus "$WORK/torus.ply"
write_script script.mlx
try "" ""
try "nan 0 0,inf 1 1,0 0 nan" "" "3 vertices with non-finite coordinates"
try "" "3 0 0 1,3 5 5 5" "2 triangles without area"
try "3 3 3,4 4 4" "" "2 vertices without triangles"
# the added vertices are 1200 to 1203
try "nan 0 0,3 3 3,inf 0 0,5 5 5" "3 0 1 1200,3 0 1201 1,3 7 7 8" \
    "2 vertices with non-finite coordinates, 2 triangles without area, 1 vertex without triangles"

# each triangle with vertices of its own: 3 for each of the 2400, of which 1200 count
awk '/^element vertex/ { $3 = 7200 }
    /^end_header/ { print; inside = 1; next }
    !inside { print; next }
    NF == 3 { vertex[n++] = $0 }
    NF == 4 { for (i = 2; i <= 4; ++i) print vertex[$i] }
    END { for (i = 0; i < 7200; i += 3) print 3, i, i + 1, i + 2 }' "$WORK/torus.ply" >"$WORK/soup.ply"
serve -i soup.ply -s script.mlx -o out.ply
((SERVER_CODE == 0)) || fail "the soup was refused"
expect_text "$WORK/log" '^Cuts closed: 6000 duplicated vertices count as others$'
expect_text "$WORK/out.ply" '^element vertex 7200$'

refuse "0 0 0,1 0 0,2 0 0" "3 0 1 2"
refuse "0 0 0,1 0 0,0 nan 0" "3 0 1 2"
refuse "0 0 0,1 0 0,0 1 0" ""
