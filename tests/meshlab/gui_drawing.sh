#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Measured drawings from the dialog of the filter: the window's view, files, errors, and layers that were moved.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

# paths FILE: what is drawn, whatever it is called
paths() {
    grep -o ' d="[^"]*"' "$WORK/$1"
}

# outlines FILE: how many there are
outlines() {
    sed -n '/class="outline"/,/<\/g>/p' "$WORK/$1" | grep -c '<path'
}

# expect_same_lines A B: as many, and nine in ten begin at the same hundredth of a millimetre: cameras are of floats
expect_same_lines() {
    local count other same
    count=$(paths "$1" | wc -l)
    other=$(paths "$2" | wc -l)
    ((50 * (count - other) <= count && 50 * (other - count) <= count)) || fail "$1 has $count lines, $2 $other"
    same=$(comm -12 <(starts "$1") <(starts "$2") | wc -l)
    ((10 * same >= 9 * count)) || fail "only $same of $count lines of $1 and $2 begin at the same places"
}

# starts FILE: where lines begin
starts() {
    paths "$1" | sed -E 's/ d="M(-?[0-9]*)(\.?[0-9]{0,2})[0-9]* (-?[0-9]*)(\.?[0-9]{0,2}).*/\1\2 \3\4/' | sort
}

torus "$WORK/torus.ply"
drawn='Drawing of torus.ply: /\S*/'
drive <<END
wait
open torus.ply
size 800x600
look 0 0 6  0 0 0
# the dialog begins with the view of the window and a file beside the mesh
trigger Export Laplacian Lines Drawing
sleep 300
screen dialog.png
set Unit of the Mesh = mm
apply
expect-log Inner lines have a kernel of √h = [0-9.]* mm on paper
expect-log ${drawn}torus_drawing.svg, in perspective and so without a scale on paper of 210 x 297 mm. The object is 2.\S* x 2.\S* x \S* mm in size
set Views = front
set File = front.svg
apply
expect-log ${drawn}front.svg, scale 50:1 on paper of 210 x 297 mm
set File = refused.bmp
apply
expect-modal Filter Failure.*"refused.bmp" does not end in .svg, .pdf, .dxf or .png
button OK
set File = missing/refused.svg
apply
expect-modal Filter Failure.*"missing/refused.svg" cannot be written
button OK
set File = refused.svg
set Scale = 500:1
apply
expect-modal Filter Failure.*Take the scale 50:1, a larger paper
button OK
set Scale = 10:1
set Paper = fit
set Views = six, window
set Title = A torus & more
set Unit of the Mesh = cm
set File = plate.pdf
apply
expect-log plate.pdf, scale 10:1 on paper of \S+ x \S+ mm. The object is .* with 10 mm to the unit
close

# an orthographic window
trigger Toggle Orthographic Camera
look 6 0 0  0 0 0
trigger Export Laplacian Lines Drawing
defaults
set Unit of the Mesh = mm
set File = window.svg
apply
set Views = right
set File = right.svg
apply
close
expect-no-log (?s)in perspective.*in perspective
END
expect_same_lines window.svg right.svg
grep -q '>perspective, not to scale' "$WORK/torus_drawing.svg" || fail "the perspective view is not called one"
grep -q '>1:\|>[0-9.]*:1 ' "$WORK/front.svg" || fail "the front view says no scale"
[[ $(head -c 5 "$WORK/plate.pdf") == %PDF- ]] || fail "plate.pdf is not a PDF"
[[ ! -e $WORK/refused.svg && ! -e $WORK/refused.bmp ]] || fail "a refused drawing was written"

# A window in perspective: the far face of a cube is to the near one, which hides it, as their distances; an eye within
cat >"$WORK/cube.ply" <<END
ply
format ascii 1.0
element vertex 8
property float x
property float y
property float z
element face 6
property list uchar int vertex_indices
end_header
-1 -1 -1
1 -1 -1
1 1 -1
-1 1 -1
-1 -1 1
1 -1 1
1 1 1
-1 1 1
4 0 3 2 1
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
END
drive <<END
wait
open cube.ply
size 800x600
look 0 0 6  0 0 0
trigger Export Laplacian Lines Drawing
defaults
set Unit of the Mesh = mm
set Hidden Lines = Dashed
set Strokes = Plain
set File = cube.svg
apply
set Views = front, window
set File = mixed.svg
apply
expect-log mixed.svg, scale
close
look 0 0 0.5  0 0 -1
trigger Export Laplacian Lines Drawing
defaults
set Unit of the Mesh = mm
set File = refused.svg
apply
expect-modal Filter Failure.*eye of a view in perspective is inside the surface
button OK
close
END
# the upper edges of both faces, the far one's before the near one's
widths=$(paths cube.svg | grep -oE 'l[0-9.]+ 0' | tr -d l | sort -un | cut -d' ' -f1 | xargs)
awk '{ ratio = $1 / $2; exit !(NF == 2 && ratio > 5 / 7 - .002 && ratio < 5 / 7 + .002) }' <<<"$widths" ||
    fail "the faces of the cube are $widths mm wide"
grep -q '>View (perspective, not to scale)<' "$WORK/mixed.svg" || fail "the view beside others is not called perspective"

# All visible layers, each with its own results; a hidden one is none of them
write_bumpy_torus 120 60 >"$WORK/ring.ply"
drive <<END
wait
open torus.ply
open ring.ply
select-layer ring
$(move_layer 'X Translation = 0.9' 'X Rotation = 80')
trigger Compute Laplacian Lines
apply
close
size 800x600
trigger Export Laplacian Lines Drawing
defaults
set Unit of the Mesh = mm
set Views = front, 30,20
set Layers = All Visible Layers
set File = both.svg
apply
expect-no-log has no precomputed attributes
expect-log Drawing of torus.ply, ring.ply: \S*both.svg, .* Together the objects are 3
set Layers = Current Layer
set File = ring.svg
apply
expect-log Drawing of ring.ply: \S*ring.svg, .* The object is
close
show-layer torus
sleep 200
trigger Export Laplacian Lines Drawing
defaults
set Unit of the Mesh = mm
set Views = front, 30,20
set Layers = All Visible Layers
set File = shown.svg
apply
close
show-layer ring
sleep 200
trigger Export Laplacian Lines Drawing
defaults
set Unit of the Mesh = mm
set Layers = All Visible Layers
set File = refused.svg
apply
expect-modal Filter Failure.*No visible layer can be drawn
button OK
close
END
cmp "$WORK/ring.svg" "$WORK/shown.svg" || fail "a hidden layer is drawn"
(($(outlines both.svg) > $(outlines ring.svg))) || fail "one of two layers is not drawn"
[[ ! -e $WORK/refused.svg ]] || fail "nothing was drawn into a file"

# Layers as they stand: turned, larger, stretched; and as the decoration draws
drive <<END
wait
open torus.ply
size 800x600
look 0 0 6  0 0 0
trigger Export Laplacian Lines Drawing
defaults
set Unit of the Mesh = mm
set Views = left
set File = $WORK/left.svg
apply
close
$(move_layer 'Y Rotation = -90')
trigger Export Laplacian Lines Drawing
defaults
set Unit of the Mesh = mm
set Views = front
set File = $WORK/turned.svg
apply
close
$(move_layer 'X Scale = 2' 'Y Scale = 2' 'Z Scale = 2')
trigger Export Laplacian Lines Drawing
defaults
set Unit of the Mesh = mm
set Views = front
set File = $WORK/twice.svg
apply
expect-log scale 20:1 on paper of 210 x 297 mm. The object is [45].\S* x [45]
close
expect-no-log transformation stretches it
trigger Compute Laplacian Lines
apply
close
$(move_layer 'X Scale = 3')
trigger Export Laplacian Lines Drawing
defaults
set Unit of the Mesh = mm
set File = $WORK/stretched.svg
set Views = front
apply
expect-log transformation stretches it: its lines are computed anew
expect-log The object is [78]\S* x 2.\S* x
set Settings = As the Decoration
apply
expect-modal Filter Failure.*The decoration Laplacian Lines has drawn nothing here
button OK
close
check Laplacian Lines on
setdeco Detail = 0
setdeco Ridges = off
trigger Export Laplacian Lines Drawing
defaults
set Unit of the Mesh = mm
set Views = front
set Settings = As the Decoration
set File = $WORK/as_drawn.svg
apply
close
END
expect_same_lines left.svg turned.svg
(($(paths as_drawn.svg | wc -l) < $(paths stretched.svg | wc -l))) ||
    fail "the decoration's settings do not count"
