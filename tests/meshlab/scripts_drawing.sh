#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Measured drawings in scripts: the example, the same bytes as from ./run --drawing but for what they say of their making,
# and errors.
source "$(dirname "$(readlink -f "$0")")/harness.sh"
EXAMPLE=$CHECKOUT/docs/examples/laplacian_lines_drawing.mlx
PROGRAM=$LAPLACIAN_LINES_BUILD/bin/laplacian-lines
VERSION=$("$PROGRAM" --version | cut -d " " -f 2)

MESHES=(torus.ply)

# draw FILE [KEY=VALUE...]: of MESHES
draw() {
    local file=$1
    shift
    write_script script.mlx file="$file" "$@"
    rm -f "$WORK/$file"
    serve -i "${MESHES[@]}" -s script.mlx
    ((SERVER_CODE == 0)) || fail "the script with $* ended with $SERVER_CODE"
    [[ -s $WORK/$file ]] || fail "the script with $* wrote no $file"
}

# without_provenance FILE
without_provenance() {
    case $1 in
    *.pdf) pdftocairo -svg "$1" - ;;
    *.dxf) awk '$0 == "999" { getline; next } { print }' "$1" ;;
    *) grep -v '<metadata>' "$1" ;;
    esac
}

# expect_same_as_program FILE OPTIONS...: those of ./run --drawing of MESHES
expect_same_as_program() {
    local file=$1
    shift
    if [[ ! -x $PROGRAM ]]; then
        say "not compared: there is no $PROGRAM"
        return
    fi
    (cd "$WORK" && "$PROGRAM" "program_$file" "$@" "${MESHES[@]}" >/dev/null)
    grep -q "laplacian_lines\":\"$VERSION\"" "$WORK/$file" || fail "$file does not say what has drawn it"
    cmp <(without_provenance "$WORK/$file") <(without_provenance "$WORK/program_$file") || fail "$file differs from what --drawing $* writes"
}

# refuse REASON [KEY=VALUE...]: no file is left behind
refuse() {
    refuse_settings "$1" file=refused.svg "${@:2}"
    [[ ! -e $WORK/refused.svg ]] || fail "a drawing was written with ${*:2}"
}

torus "$WORK/torus.ply"
draw front.svg
expect_same_as_program front.svg
expect_text "$WORK/log" 'Inner lines have a kernel of √h = [0-9.]* mm on paper'
expect_text "$WORK/log" 'Drawing of torus\.ply: /.*/front\.svg, scale 50:1 on paper of 210 x 297 mm\. The object is 2\.[0-9]* x 2\.[0-9]* x .* mm in size, with 1 mm to the unit'
draw plate.dxf views=six paper=2 unit=1 up=2 title=Torus arrangement=1
expect_same_as_program plate.dxf --views six --paper a3 --unit cm --up z --title Torus --arrangement third
expect_text "$WORK/log" 'plate\.dxf, scale .* on paper of (297 x 420|420 x 297) mm\. .*, with 10 mm to the unit'
draw cut.svg views=top,30,15 sections="x=0.5 y=0.4" scale=10:1 strokes=1 furniture=false paper=6
expect_same_as_program cut.svg --views top,30,15 --section x=0.5 --section y=0.4 --scale 10:1 --strokes plain \
    --furniture none --paper fit
expect_text "$WORK/log" 'scale 10:1 on paper of'
draw section.svg views=left sections=z=0.5 wall=1
expect_same_as_program section.svg --views left --section z=0.5 --wall filled
draw alone.svg views= sections=z=0.5
expect_same_as_program alone.svg --section z=0.5
draw plate.pdf views=front,left title="A plate"
[[ $(head -c 5 "$WORK/plate.pdf") == %PDF- ]] || fail "plate.pdf is not a PDF"
expect_same_as_program plate.pdf --views front,left --title "A plate"

# kinds of lines by mixtures, whose numbers are those of Settings
draw ridges.svg settings=5
expect_same_as_program ridges.svg --kinds apparent_ridges
! cmp -s "$WORK/ridges.svg" "$WORK/front.svg" || fail "apparent ridges look like the usual lines"

draw plate.png views=six
expect_same_as_program plate.png --views six
draw hidden.svg views=30,40 hidden=1
expect_same_as_program hidden.svg --views 30,40 --hidden dashed
draw iso.svg views=30,40 weights=1
expect_same_as_program iso.svg --views 30,40 --weights iso

# --- layers together
awk '$1 == "end_header" { body = 1; print; next } body && NF == 3 { print $1 + .9, $2 + .3, $3 - 2; next } 1' \
    "$WORK/torus.ply" >"$WORK/behind.ply"
printf '%s\n' ply 'format ascii 1.0' 'element vertex 1' 'property float x' 'property float y' 'property float z' \
    end_header '0 0 9' >"$WORK/points.ply"
MESHES=(torus.ply behind.ply)
draw both.svg layers=1 views=front,20,10 sections=x=0.5 hidden=1
expect_same_as_program both.svg --views front,20,10 --section x=0.5 --hidden dashed
expect_text "$WORK/log" 'Drawing of torus\.ply, behind\.ply: .*both\.svg, .* Together the objects are 3\.[0-9]* x'
cp "$WORK/both.svg" "$WORK/two.svg"
MESHES=(points.ply torus.ply behind.ply)
draw both.svg layers=1 views=front,20,10 sections=x=0.5 hidden=1
expect_text "$WORK/log" 'points\.ply is left out of the drawing: it has no faces\.'
cmp "$WORK/both.svg" "$WORK/two.svg" || fail "points change the drawing"
draw current.svg
grep -q '>[^<]*behind\.ply<' "$WORK/current.svg" && ! grep -q 'torus\.ply' "$WORK/current.svg" ||
    fail "the current layer is not drawn alone"
MESHES=(torus.ply)

# a field of other options is used
sed '/<\/FilterScript>/d' "$CHECKOUT/docs/examples/laplacian_lines.mlx" >"$WORK/both.mlx"
sed -i 's/name="kernel_size" \(.*\) value="0"/name="kernel_size" \1 value="0.2"/' "$WORK/both.mlx"
write_script script.mlx file=coarse.svg
sed -n '/<filter /,$p' "$WORK/script.mlx" >>"$WORK/both.mlx"
serve -i torus.ply -s both.mlx
((SERVER_CODE == 0)) || fail "both filters after each other ended with $SERVER_CODE"
! grep -q 'computed with the default options' "$WORK/log" || fail "the attributes are not used"
! cmp -s "$WORK/coarse.svg" "$WORK/front.svg" || fail "the attributes make no difference"

refuse_settings '"plate\.bmp" does not end in \.svg' file=plate.bmp
refuse_settings '"missing.drawing\.svg" cannot be written' file='missing\/drawing.svg'
refuse 'At the scale 1000:1 the views take .* Take the scale ' scale=1000:1
refuse '"half" is not a scale' scale=half
refuse '"above" is not a view' views=above
refuse '"y" is not a section' sections=y
refuse 'There is no window whose view could be drawn' views=window
refuse 'The decoration Laplacian Lines has drawn nothing here' settings=1
refuse '"Unit of the Mesh" is 4\. It has to be one of 0 \(mm\)' unit=4
