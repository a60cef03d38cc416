#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# program.sh PROGRAM: what the program of drawings makes of meshes and of mistakes, and how large others' programs find
# its drawings.
set -euo pipefail

program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

fail() {
    printf 'FAILED: %s\n' "$*" >&2
    exit 1
}

# refused SENTENCE ARGS...: the program ends with an error that holds SENTENCE and leaves no file
refused() {
    local sentence=$1
    shift
    ! "$program" "$@" >out 2>error || fail "not refused: $*"
    grep -qF -- "$sentence" error || fail "$* says: $(cat error)"
    ! ls plate.* 2>/dev/null || fail "$* left a file"
}

# a cube of 100 mm of 12 triangles, in three formats
write_cube() {
    local v f
    v=$(printf '%s\n' "0 0 0" "100 0 0" "100 100 0" "0 100 0" "0 0 100" "100 0 100" "100 100 100" "0 100 100")
    f=$(printf '%s\n' "0 2 1" "0 3 2" "4 5 6" "4 6 7" "0 1 5" "0 5 4" "1 2 6" "1 6 5" "2 3 7" "2 7 6" "3 0 4" "3 4 7")
    { printf 'OFF\n8 12 0\n%s\n' "$v"; awk '{ print 3, $0 }' <<<"$f"; } >cube.off
    { awk '{ print "v", $0 }' <<<"$v"; awk '{ print "f", $1 + 1, $2 + 1, $3 + 1 }' <<<"$f"; } >cube.obj
    {
        printf 'ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n'
        printf 'element face 12\nproperty list uchar int vertex_indices\nend_header\n%s\n' "$v"
        awk '{ print 3, $0 }' <<<"$f"
    } >cube.ply
}

# extent_mm PICTURE DPI: width and height of what is black
extent_mm() {
    convert "$1" -background white -alpha remove -threshold 50% -trim -format '%w %h' info: |
        awk -v dpi="$2" '{ printf "%.2f %.2f\n", $1 * 25.4 / dpi, $2 * 25.4 / dpi }'
}

# expect_extent EXTENT MM WHAT: within a tenth of a millimetre
expect_extent() {
    awk -v mm="$2" '{ exit !($1 > mm - .1 && $1 < mm + .1 && $2 > mm - .1 && $2 < mm + .1) }' <<<"$1" ||
        fail "$3 measures $1, not $2"
}

write_cube
bare=(--views front --strokes plain --furniture none)
for mesh in cube.off cube.obj cube.ply; do
    "$program" "$mesh.svg" "${bare[@]}" --scale 1:1 "$mesh" | grep -q "100 x 100 x 100 mm" || fail "$mesh has another size"
    (($(grep -c "<path" "$mesh.svg") == 1)) || fail "the outline of $mesh is not one line"
done

refused "does not end in" plate.png cube.off
refused "cannot be written" missing/plate.svg cube.off
refused "there is no such file" plate.svg missing.ply
refused "PLY, OBJ, STL and OFF" plate.svg "$program"
refused "is no view" plate.svg --views above cube.off
refused "is no section" plate.svg --section y cube.off
refused "no scale" plate.svg --scale 2 cube.off
refused "Take the scale" plate.svg --scale 9:1 cube.off
refused "has to be one of" plate.svg --up w cube.off
refused "unknown option" plate.svg --colour red cube.off
refused "needs a value" plate.svg cube.off --up
printf 'OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n' >points.off
refused "no faces" plate.svg points.off

# pens of .5 mm stand out by half their width
dpi=600
for scale in 1:1 1:2; do
    [[ $scale == 1:1 ]] && mm=100 || mm=50
    "$program" cube.svg "${bare[@]}" --scale "$scale" cube.off >/dev/null
    "$program" cube.pdf "${bare[@]}" --scale "$scale" cube.off >/dev/null
    if command -v rsvg-convert >/dev/null; then
        rsvg-convert -d $dpi -p $dpi -b white cube.svg -o svg.png
        expect_extent "$(extent_mm svg.png $dpi)" "$mm.5" "SVG at $scale"
    else
        echo "skipped: no rsvg-convert"
    fi
    if command -v pdftoppm >/dev/null; then
        pdftoppm -r $dpi -png -singlefile cube.pdf pdf
        expect_extent "$(extent_mm pdf.png $dpi)" "$mm.5" "PDF at $scale"
    else
        echo "skipped: no pdftoppm"
    fi
done
echo passed
