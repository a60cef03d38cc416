#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Edits of a mesh that has attributes and its lines shown: the lines are always those of the geometry as it is.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

# edit FILTER ["LABEL = VALUE"...]: attributes of the geometry before do not count any more
edit() {
    local filter=$1
    shift
    printf 'trigger Compute Laplacian Lines\nset Normal Smoothing Sigma = 6\napply\nclose\nexpect-lines single_strokes=0 normal_sigma=6\n'
    printf 'trigger %s\n' "$filter"
    if (($#)); then
        printf 'set %s\n' "$@"
        printf 'apply\nclose\n'
    fi
    printf 'expect-lines single_strokes=0\nexpect-other-lines single_strokes=0 normal_sigma=6\n'
}

# kept_on_reload OPTION: of the attributes, or none where MeshLab empties them
kept_on_reload() {
    [[ $(meshlab_version) == 2025.* ]] || printf '%s' "$1"
}

torus "$WORK/torus.ply"
drive_lines torus.ply <<END
# the paper's lines, since there are more of them
setdeco Single Strokes = off
# MeshLab shows selections in red
setdeco Line Color = #0000ff
setdeco Contour Color = #0000ff
ink #0000ff
$(edit "Laplacian Smooth" "Smoothing steps = 3")
expect-log torus.ply has changed since its attributes were computed; computed with the default options
$(edit "Subdivision Surfaces: Loop" "Iterations = 1" "Edge Threshold (abs and %) = 3%")
$(edit "Simplification: Quadric Edge Collapse Decimation" "Target number of faces = 9000")
$(edit "Per Vertex Geometric Function" "func z = = z + 0.1 * sin(5 * x)")
trigger Conditional Face Selection
set boolean function = x0 > 0.3
apply
close
expect-lines single_strokes=0
$(edit "Delete Selected Faces")

# two turns inside out and back: the attributes belong to the geometry again
trigger Compute Laplacian Lines
set Normal Smoothing Sigma = 6
apply
close
trigger Invert Faces Orientation
set Force Flip = on
apply
expect-lines single_strokes=0
apply
close
expect-lines single_strokes=0 normal_sigma=6
expect-other-lines single_strokes=0

# what lines do not depend on leaves the attributes valid
trigger Compute Laplacian Lines
set Normal Smoothing Sigma = 6
apply
close
trigger Per Vertex Color Function
apply
close
trigger Conditional Vertex Selection
apply
close
expect-lines single_strokes=0 normal_sigma=6

# a duplicate has no attributes
trigger Duplicate Current layer
$(show_lines)
setdeco Line Color = #0000ff
setdeco Contour Color = #0000ff
show-layer 0
expect-lines single_strokes=0
expect-log torus.ply_copy has no precomputed attributes
select-layer 1
delete-layer 1
show-layer 0
expect-lines single_strokes=0 normal_sigma=6

# attributes that a reload keeps count when the file still has the mesh that they were computed from
trigger Reload
expect-lines single_strokes=0
trigger Compute Laplacian Lines
set Normal Smoothing Sigma = 6
apply
close
expect-lines single_strokes=0 normal_sigma=6
trigger Laplacian Smooth
apply
close
expect-lines single_strokes=0
trigger Reload
expect-lines single_strokes=0 $(kept_on_reload normal_sigma=6)
# but not when edits have left them in another order
trigger Compute Laplacian Lines
set Normal Smoothing Sigma = 6
apply
close
trigger Conditional Face Selection
set boolean function = x0 > 0.3
apply
close
trigger Delete Selected Faces
trigger Remove Unreferenced Vertices
trigger Reload
expect-lines single_strokes=0
END
