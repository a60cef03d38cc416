#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# program.sh PROGRAM: what the program of drawings makes of meshes and of mistakes, and how large others' programs find
# its drawings.
# shellcheck source=/dev/null
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/harness.sh"

# refused SENTENCE ARGS...: the program ends with an error that holds SENTENCE and leaves no file
refused() {
    local sentence=$1
    shift
    ! "$PROGRAM" "$@" >out 2>error || fail "not refused: $*"
    grep -qF -- "$sentence" error || fail "$* says: $(cat error)"
    ! ls plate.* 2>/dev/null || fail "$* left a file"
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
    "$PROGRAM" "$mesh.svg" "${bare[@]}" --scale 1:1 "$mesh" >out
    grep -q "100 x 100 x 100 mm" out || fail "$mesh has another size"
    (($(grep -c "<path" "$mesh.svg") == 1)) || fail "the outline of $mesh is not one line"
done

refused "does not end in" plate.jpg cube.off
refused "cannot be written" missing/plate.svg cube.off
refused "there is no such file" plate.svg missing.ply
refused "PLY, OBJ, STL and OFF" plate.svg "$PROGRAM"
refused "is not a view" plate.svg --views above cube.off
refused "is not a section" plate.svg --section y cube.off
refused "not a scale" plate.svg --scale 2 cube.off
refused "not a size of detail" plate.svg --kernel 2 cube.off
refused "not a size of detail" plate.svg --smoothing 0mm cube.off
refused "Take the scale" plate.svg --scale 9:1 cube.off
refused "has to be one of" plate.svg --up w cube.off
refused "--kinds is \"ridge\". It has to be some of usual, laplacian_lines, " plate.svg --kinds ridge cube.off
refused "unknown option" plate.svg --colour red cube.off
refused "needs a value" plate.svg cube.off --up
printf 'OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n' >points.off
refused "no faces" plate.svg points.off
: >empty.ply
refused "empty.ply: the mesh cannot be read" plate.svg empty.ply
printf 'nonsense' >nonsense.stl
refused "nonsense.stl: the mesh cannot be read: it ends within its header." plate.svg nonsense.stl
sed -E '3,10s/.*/nan nan nan/' cube.off >nowhere.off
refused "no triangle with an area" plate.svg nowhere.off
refused "cannot be written" /proc/plate.svg cube.off

# what is not finite is left out, and a size that can hardly be meant gives advice
sed 's/^100 100 100$/nan nan nan/' cube.off >hole.off
"$PROGRAM" hole.svg "${bare[@]}" hole.off >out 2>error
grep -q "hole.off is drawn incomplete: 1 of 8 vertices" error || fail "nothing says what is left out: $(cat error)"
grep -q "100 x 100 x 100 mm" out || fail "a vertex that is not finite changes the size: $(cat out)"
awk 'NR > 2 && NR < 11 { print $1 / 1e5, $2 / 1e5, $3 / 1e5; next } { print }' cube.off >metres.off
"$PROGRAM" metres.svg --scale 1:1 --unit m "${bare[@]}" metres.off >out
grep -q "1 x 1 x 1 mm in size" out || fail "1 mm in metres: $(cat out)"
"$PROGRAM" metres.svg "${bare[@]}" metres.off >out
grep -q "if it is in metres, say --unit m" out || fail "no advice: $(cat out)"

# texts of PDF can be searched
"$PROGRAM" searched.pdf --views front --title "Find 17 äöü" cube.off >/dev/null
pdftotext searched.pdf searched.txt
grep -q "Find 17 äöü" searched.txt && grep -q "100.0 × 100.0 × 100.0 mm" searched.txt ||
    fail "the text of a PDF is: $(<searched.txt)"

# a damaged file is refused, or drawn and called incomplete
cat >cut.stl <<'END'
solid cut
facet normal 0 0 1
 outer loop
  vertex 0 0 0
  vertex 100 0 0
  vertex 0 100 0
 endloop
endfacet
facet normal 0 0 1
 outer loop
  vertex 100 0 0
  vertex 100 100
END
refused "cut.stl: the file is damaged: line 12: it ends without \"endsolid\". With --damaged draw, the 1 triangles" \
    plate.svg cut.stl
"$PROGRAM" incomplete.svg --views top --up z --damaged draw cut.stl >out 2>error
grep -q "cut.stl is drawn incomplete: line 12" error || fail "nothing says that it is incomplete: $(cat error)"
grep -q "incomplete: cut.stl" incomplete.svg || fail "the sheet does not say that it is incomplete"
head -n 12 cube.off >half.off
refused "half.off: " plate.svg half.off
mkdir dash
cp cube.off dash/--dash.off
(cd dash && "$PROGRAM" dash.svg "${bare[@]}" -- --dash.off >/dev/null) || fail "a name after -- is none"

# --- several meshes in a file are one drawing

mkdir scene more_of_them
cp cube.off scene/near.off
awk 'NR > 2 && NR < 11 { print $1 + 50, $2, $3 - 300; next } { print }' cube.off >scene/far.off
"$PROGRAM" together.svg "${bare[@]}" --title "{name}" --scale 1:1 --paper a3 scene/near.off scene/far.off >out
grep -q "together the objects are 150 x 100 x 400 mm" out || fail "two cubes have another size: $(cat out)"
# the far one's outline is an angle beside the near one's
(($(grep -c "<path" together.svg) == 2)) || fail "two cubes have other outlines than theirs"
"$PROGRAM" folder.svg "${bare[@]}" --title "{name}" --scale 1:1 --paper a3 scene >/dev/null
"$PROGRAM" order.svg "${bare[@]}" --title "{name}" --scale 1:1 --paper a3 scene/{far,near}.off >/dev/null
cmp folder.svg order.svg || fail "a folder is not drawn as its meshes"
"$PROGRAM" notes.svg --title "{name}" scene >/dev/null
grep -q ">far, near<" notes.svg && grep -q "far.off, near.off" notes.svg || fail "the sheet does not name its objects"
refused "points.off: the mesh has no faces" plate.svg cube.off points.off
refused "nowhere.off: " plate.svg cube.off nowhere.off
refused "there is no mesh in the folder" plate.svg more_of_them

# --- several meshes in a folder are a drawing each and a contact sheet

# drawn ARGS...: what the program says of a collection
drawn() {
    "$PROGRAM" plates/ "$@" 2>&1 || true
}

# expect_says TEXT LINE...: TEXT has these lines
expect_says() {
    local text=$1 line
    shift
    for line in "$@"; do grep -qxF -- "$line" <<<"$text" || fail "no line \"$line\" in: $text"; done
}

mkdir -p meshes more
cp cube.off meshes/one.off
sed 's/100/50/g' cube.off >meshes/two.off
cp cube.ply more/three.ply
cp cube.obj more/one.obj
echo "no mesh" >meshes/bad.ply
says=$(drawn --title "{name}" meshes more/three.ply)
expect_says "$says" "plates/one.pdf: drawn" "plates/two.pdf: drawn" "plates/three.pdf: drawn" \
    "plates/contact_sheet.pdf: 3 objects" "3 drawn, 0 unchanged, 1 not drawn"
grep -q "^meshes/bad.ply: not drawn: the mesh cannot be read" <<<"$says" || fail "the bad mesh is not reported: $says"
! "$PROGRAM" plates/ meshes >/dev/null 2>&1 || fail "a mesh that cannot be drawn is not an error"
rm meshes/bad.ply
drawn --title "{name}" meshes more/three.ply >/dev/null
before=$(stat -c '%n %y' plates/{one,two,three}.pdf)
says=$(drawn --title "{name}" meshes more/three.ply)
expect_says "$says" "meshes/one.off: unchanged" "0 drawn, 3 unchanged, 0 not drawn"
[[ $(stat -c '%n %y' plates/{one,two,three}.pdf) == "$before" ]] || fail "what is unchanged was written again"
cp cube.ply meshes/two.ply && rm meshes/two.off plates/one.pdf
expect_says "$(drawn --title "{name}" meshes more/three.ply)" "2 drawn, 1 unchanged, 0 not drawn"
expect_says "$(drawn --title other meshes more/three.ply)" "3 drawn, 0 unchanged, 0 not drawn"
expect_says "$(drawn --format svg meshes more)" "plates/one.off.svg: drawn" "plates/one.obj.svg: drawn" \
    "plates/contact_sheet.svg: 4 objects"
for name in one.off one.obj two three; do
    grep -q ">$name<" plates/contact_sheet.svg || fail "$name is not on the contact sheet"
done
refused "--format is for a folder" plate.svg --format pdf cube.off
refused "there is no mesh in the folder" plates/ plates
refused "have the same name" plates/ cube.off meshes/../cube.off
refused "cannot be written" cube.off/plates/ meshes
refused "between 20 and 2400" plate.png --dpi 5 cube.off
refused "is too large" plate.png --dpi 2400 --paper a0 cube.off

# --- names of files are bytes, in locales of ASCII and of UTF-8

mkdir names
odd=$'caf\xe9 \xff\xc3'
for locale in C C.UTF-8; do
    for name in "$odd" "ü 日本 😀"; do
        cp cube.off "names/$name.off"
        LC_ALL=$locale "$PROGRAM" "names/$name.svg" --title "{name}" --views front "names/$name.off" >out 2>error ||
            fail "in $locale, not drawn: $name: $(<error)"
        [[ -s names/$name.svg && ! -s error ]] && iconv -f UTF-8 "names/$name.svg" >/dev/null || fail "in $locale, of $name: $(<error)"
        grep -qF "the drawing is names/$name.svg" out || fail "in $locale, it says: $(<out)"
        LC_ALL=$locale "$PROGRAM" "names/$name/" --format svg names >out 2>error || fail "in $locale, no folder: $(<error)"
        [[ -s names/$name/$name.svg && -s names/$name/contact_sheet.svg ]] || fail "in $locale: $(ls -R names)"
        rm -r "names/$name"*
    done
    cp cube.off "$odd.off"
    LC_ALL=$locale "$PROGRAM" note.svg --title "{name}" --views front "$odd.off" >out
    grep -qF $'caf\xEF\xBF\xBD \xEF\xBF\xBD\xEF\xBF\xBD.off' note.svg && grep -qF $'>caf\xEF\xBF\xBD \xEF\xBF\xBD\xEF\xBF\xBD<' note.svg ||
        fail "in $locale, the sheet names it: $(grep -a caf note.svg)"
done

# pens of .5 mm stand out by half their width
dpi=600 missing=
"$PROGRAM" kernel.svg --scale 1:1 --paper a2 --kernel 3mm --smoothing 1% cube.off >/dev/null
grep -q '√h 3 mm' kernel.svg || fail "a kernel that is given is not that of the drawing"
for scale in 1:1 1:2; do
    [[ $scale == 1:1 ]] && mm=100 || mm=50
    "$PROGRAM" cube.svg "${bare[@]}" --scale "$scale" cube.off >/dev/null
    "$PROGRAM" cube.pdf "${bare[@]}" --scale "$scale" cube.off >/dev/null
    "$PROGRAM" cube.png "${bare[@]}" --dpi $dpi --scale "$scale" cube.off >/dev/null
    expect_extent "$(extent_mm cube.png $dpi)" "$mm.5" "PNG at $scale"
    if command -v rsvg-convert >/dev/null; then
        rsvg-convert -d $dpi -p $dpi -b white cube.svg -o svg.png
        expect_extent "$(extent_mm svg.png $dpi)" "$mm.5" "SVG at $scale"
    else
        missing=rsvg-convert
    fi
    if command -v pdftoppm >/dev/null; then
        pdftoppm -r $dpi -png -singlefile cube.pdf pdf
        expect_extent "$(extent_mm pdf.png $dpi)" "$mm.5" "PDF at $scale"
    else
        missing=pdftoppm
    fi
done
[[ -z $missing ]] || skip "no $missing"
echo passed
