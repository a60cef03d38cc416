#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What the dialog of measured drawings has besides MeshLab's fields: check marks for views, a likely unit, size and scale
# before anything is drawn, a button that looks for the file, and what it was last applied with.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

# write_box FILE SIZE: a cube
write_box() {
    awk -v half="$(($2 / 2))" 'BEGIN {
        print "OFF\n8 6 0"
        for (i = 0; i < 8; ++i) print (i % 2 * 2 - 1) * half, (int(i / 2) % 2 * 2 - 1) * half, (int(i / 4) * 2 - 1) * half
        print "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5"
    }' >"$1"
}

torus "$WORK/torus.ply"
write_box "$WORK/box.off" 80
drive <<END
wait
open torus.ply
size 800x600
look 0 0 6  0 0 0
trigger Export Laplacian Lines Drawing
expect-field Unit of the Mesh = m
expect-field Window = on
expect-field Front = off
expect-in-dialog 1 unit = 1 m: the object is 2\.\d+ × 2\.\d+ × \S+ m large\. In perspective, without a scale, on A4\.
# check marks write the text, and follow it
set Front = on
expect-field Views = window, front
set Window = off
expect-field Views = front
expect-in-dialog Fits A4 at 1:20\.
set Views = 30,15 six
expect-field Bottom = on
set Top = off
expect-field Views = 30,15, front, back, left, right, bottom
expect-in-dialog Fits A4 at 1:50\.
# size and scale follow the other fields, and what is refused is said
set Unit of the Mesh = mm
expect-in-dialog 1 unit = 1 mm: the object is 2\.\d × 2\.\d × \S+ mm large\. Fits A4 at 25:1|20:1\.
set Scale = 5000:1
expect-in-dialog At the scale 5000:1 the views take
set Scale = half
expect-in-dialog "half" is no scale
set Scale = 2:1
set Paper = fit
expect-in-dialog Fits \S+ x \S+ mm at 2:1\.
defaults
expect-field Views = window
expect-field Window = on
expect-field Front = off
expect-field Unit of the Mesh = m
expect-field Scale = fit
# what was applied is there when the dialog opens again, for the same mesh all of it
set Window = off
set Left = on
set Walls = Filled
set Title = Find 17
set Unit of the Mesh = mm
set File = $WORK/kept.dxf
apply
expect-log kept.dxf, scale 50:1 on paper
close
trigger Compute Laplacian Lines
close
trigger Export Laplacian Lines Drawing
expect-field Views = left
expect-field Left = on
expect-field Walls = Filled
expect-field Title = Find 17
expect-field Unit of the Mesh = mm
expect-field File = $WORK/kept.dxf
expect-in-dialog Fits A4 at 50:1\.
# what was not applied is not kept, nor what was refused
set Scale = half
apply
expect-modal "half" is no scale
button OK
close
trigger Export Laplacian Lines Drawing
expect-field Scale = fit
defaults
expect-field Views = window
expect-field Walls = Hatched
expect-field Title = 
expect-field Unit of the Mesh = m
expect-field File = $WORK/torus_drawing.svg
close
END
[[ -s $WORK/kept.dxf ]] || fail "kept.dxf was not written"

# The next session; another mesh has a file, a title and a unit of its own
drive <<END
wait
open box.off
size 800x600
trigger Export Laplacian Lines Drawing
expect-field Views = left
expect-field Walls = Filled
expect-field Title = 
expect-field Unit of the Mesh = mm
expect-field File = $WORK/box_drawing.dxf
expect-in-dialog 1 unit = 1 mm: the object is 80 × 80 × 80 mm large\. Fits A4 at 2:1\.
screen dialog.png
close
open torus.ply
trigger Export Laplacian Lines Drawing
expect-field Title = Find 17
expect-field Unit of the Mesh = mm
expect-in-dialog the object is 2\.
set Layers = All Visible Layers
expect-in-dialog together the objects are 80 × 80 × 80 mm large
click ...
expect-modal .
# typing it and the return key close the box
set-modal File name: = $WORK/found.svg
expect-field File = $WORK/found.svg
apply
expect-log Drawing of box.off, torus.ply: \S*found.svg
close
END
[[ -s $WORK/found.svg ]] || fail "the file that was looked for was not written"
