#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Lines as a layer of polylines, from the dialog of the filter: its views, its errors, and where the layer lies.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

torus "$WORK/torus.ply"
counts='Lines of torus.ply: [1-9]\d* Laplacian lines, [1-9]\d* occluding contours, .*[1-9]\d* segments; '
drive <<END
wait
open torus.ply
size 800x600
look 0.5 -2 3  0 0 0
# the view of the window is what the dialog begins with
trigger Generate Laplacian Lines Polylines
apply
close
expect-log torus.ply has no precomputed attributes; computed with the default options in
expect-log ${counts}perspective, from the viewpoint 0.5 -2 3\n
show-layer torus_laplacian_lines
show-layer torus_laplacian_lines
delete-layer torus_laplacian_lines

trigger Generate Laplacian Lines Polylines
set View = Orthographic, along the View Direction
set View Direction = 1 2 2
set Visible Lines Only = off
apply
expect-log ${counts}orthographic, along the view direction 1 2 2\n
select-layer 0
look 3 0 1  0 0 0
set View = Perspective, from the Viewpoint
set Viewpoint = View Pos.
apply
close
expect-log ${counts}perspective, from the viewpoint 3 0 1\n
delete-layer torus_laplacian_lines(1)
delete-layer torus_laplacian_lines

# with results of the other filter
select-layer 0
trigger Compute Laplacian Lines
set Laplace Operator = Cotangent
apply
close
slot window updateLayerDialog
trigger Generate Laplacian Lines Polylines
apply
close
delete-layer torus_laplacian_lines
expect-no-log (?s)computed with the default.*computed with the default.*computed with the default.*computed with the default

# an orthographic window
trigger Toggle Orthographic Camera
look 0 -3 4  0 0 0
trigger Generate Laplacian Lines Polylines
apply
close
expect-log ${counts}orthographic, along the view direction -?[\d.e-]+ -0.6 0.8\n

# a layer without faces, and views without lines
trigger Generate Laplacian Lines Polylines
expect-modal PreConditions' Failure.*Generate Laplacian Lines Polylines
button OK
delete-layer torus_laplacian_lines
trigger Generate Laplacian Lines Polylines
set View = Perspective, from the Viewpoint
set Viewpoint = 1 0 0
apply
expect-modal Filter Failure.*The viewpoint is inside the surface
button OK
set View Direction = 0 0 0
apply
expect-modal Filter Failure.*"View Direction" is 0 0 0, which is not a direction
button OK
set View Direction = 0 0 1
set View = Orthographic, along the View Direction
set Laplacian Lines = off
set Ridges = off
set Occluding Contours = off
apply
expect-modal Filter Failure.*No lines are seen from there
button OK
close
expect-log No lines are seen from there, so no layer was created
END

# the current one of several views, and a layer with a transformation: outlines lie around the surface that is seen
drive <<END
wait
open torus.ply
check Show Info Panel off
check Show Trackball off
$(move_layer 'X Scale = 2' 'Y Scale = 0.7' 'X Translation = 0.3')
size 800x600
look 3 -3 5  0 0 0
grab surface.png
trigger Generate Laplacian Lines Polylines
apply
close
show-layer 0
grab lines.png
show-layer 0
delete-layer torus_laplacian_lines
size 1200x860
trigger Horizontally
view 1
look 1 2 6  0 0 0
view 0
look 6 2 1  0 0 0
trigger Generate Laplacian Lines Polylines
apply
close
expect-log perspective, from the viewpoint 6 2 1\n
select-layer 0
view 1
trigger Generate Laplacian Lines Polylines
apply
close
expect-log perspective, from the viewpoint 1 2 6\n
END

# extent FILE: left, top, right and bottom of what is not background
extent() {
    convert "$1" -alpha off -bordercolor white -border 1 -fuzz 4% -trim -format '%O %w %h' info: |
        awk -F'[+ ]' '{ print $2, $3, $2 + $4, $3 + $5 }'
}
read -ra surface < <(extent "$WORK/surface.png")
read -ra lines < <(extent "$WORK/lines.png")
for side in 0 1 2 3; do
    difference=$((surface[side] - lines[side]))
    ((difference >= -4 && difference <= 4)) || fail "lines end at ${lines[*]}, the surface at ${surface[*]}"
done

# numbers of what is said of "Lines of torus.ply" in a log, a line each
line_counts() {
    sed -n -E 's/.*Lines of torus\.ply: (.* segments); .*/\1/p' "$1"
}

# Sides are those of MeshLab's menu, which is what the dialog begins with
drive <<END
wait
open torus.ply
$(for side in Front Back Left Right Top Bottom; do
    printf '%s\n' "trigger $side" 'trigger Generate Laplacian Lines Polylines' apply 'select-layer 0' \
        "set View = $side" apply close 'select-layer 0'
done)
log sides.txt
END
mapfile -t directions < <(sed -n -E 's/.*Lines of .* along the view direction ([^ ]+ [^ ]+ [^ ]+).*/\1/p' "$WORK/sides.txt" |
    awk '{ printf "%.4f %.4f %.4f\n", $1 + 0, $2 + 0, $3 + 0 }' | sed 's/-0\.0000/0.0000/g')
((${#directions[@]} == 12)) || fail "sides.txt tells of ${#directions[@]} layers"
for number in 0 2 4 6 8 10; do
    [[ ${directions[number]} == "${directions[number + 1]}" ]] ||
        fail "MeshLab looks along ${directions[number]}, the filter along ${directions[number + 1]}"
done

# As the decoration draws: nothing before it has, then its lines, its light and its colors, whatever else is set
drive <<END
wait
open torus.ply
size 800x600
look 0 -2 3  0 0 0
trigger Generate Laplacian Lines Polylines
set Settings = As the Decoration
apply
expect-modal Filter Failure.*The decoration Laplacian Lines has drawn nothing here
button OK
close
check Laplacian Lines on
setdeco Detail = 80
setdeco Ridge Angle = 25
setdeco Line Color = #ff0000
setdeco Contour Color = #ff0000
setdeco Hidden Lines = Faint
setdeco Light Position = Fixed to the Camera
setdeco Light Azimuth = 90
setdeco Light Elevation = 0
trigger Generate Laplacian Lines Polylines
set Settings = As the Decoration
set Occluding Contours = off
apply
close
check Show Info Panel off
check Show Trackball off
show-layer 0
grab red.png
show-layer 0
select-layer 0
setdeco Ridge Angle = 10
trigger Generate Laplacian Lines Polylines
set Settings = As the Decoration
apply
set Settings = As Set Below
set Detail = 80
set Visible Lines Only = off
set Light Position = Along the Light Direction
set Light Direction = 1 0 0
select-layer 0
apply
close
log counts.txt
END
mapfile -t counts < <(line_counts "$WORK/counts.txt")
((${#counts[@]} == 3)) || fail "counts.txt tells of ${#counts[@]} layers"
[[ ${counts[0]} == *'occluding contours'* ]] || fail "the decoration draws contours, the filter ${counts[0]}"
[[ ${counts[0]} != "${counts[1]}" ]] || fail "the decoration's ridge angle does not count"
[[ ${counts[1]} == "${counts[2]}" ]] || fail "as the decoration ${counts[1]}, with the same settings ${counts[2]}"
# thin lines in their color, without the dots and the gray that MeshLab's edges have by themselves
red=$(red_pixels "$WORK/red.png")
ink=$(convert "$WORK/red.png" -alpha off -fill black +opaque white -negate -format '%[fx:round(mean*w*h)]' info:)
((red > 1000 && red == ink && red < 10000)) || fail "red.png has $red red pixels, $ink in all"
