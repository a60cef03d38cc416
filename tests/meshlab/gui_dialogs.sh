#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What users see of parameters on a small screen: dialogs fit it with their buttons, the decoration's panel has first
# things first, shows the others when asked, and has off what a drawing style overrules.
DISPLAY_SIZE=1366x768
source "$(dirname "$(readlink -f "$0")")/harness.sh"

# filter NAME PICTURE: its dialog fits the screen, the help on each parameter as well
filter() {
    printf '%s\n' "trigger $1" 'sleep 300' 'expect-dialog-within 1366x700' "screen $2.png" help 'sleep 300' \
        'expect-dialog-within 1366x700' "screen $2_help.png" close
}

small_torus "$WORK/torus.ply"
drive <<END
wait
open torus.ply
window 1366x768
check Laplacian Lines on
unfold Laplacian Lines
sleep 300
screen panel.png
expect-window-within 1366x768
expect-fields-above 768
expect-wrapped-tool-tips
expect-deco Drawing Style on
expect-deco Occluding Contours on
expect-deco Lines on
expect-deco Borders hidden
expect-deco Line Color on
expect-deco Ridge Angle hidden
expect-deco Show Statistics hidden

# hidden ones can be set by scripts, and keep their values
setdeco Ridge Angle = 40
setdeco Parameters = All
sleep 300
screen panel_all.png
expect-window-within 1366x768
expect-deco Ridge Angle on
expect-deco Light Azimuth off
expect-deco Tones off
setdeco Surface = Toon
expect-deco Tones on
check Laplacian Lines Probe on
setdeco Line Color = #ff0000
setdeco Contour Color = #ff0000
expect-lines ridge_angle=40

setdeco Drawing Style = Publication (Black on White)
sleep 300
screen panel_publication.png
expect-deco Line Color off
expect-deco Surface off
expect-deco Tones off
expect-deco Light Position off
expect-deco Detail on
setdeco Drawing Style = Archaeology (Side Light)
expect-deco Light Azimuth on
expect-deco Light Position off

# as does the choice of lines
setdeco Lines = Apparent Ridges
expect-deco Ridges off
expect-deco Apparent Ridges off
expect-deco Least Apparent Curvature on
setdeco Lines = Laplacian Lines, as Switched
expect-deco Ridges on
sleep 300
expect-window-within 1366x768

# a panel that MeshLab makes anew is arranged like the one before
setdeco Parameters = Basic
open torus.ply
check Laplacian Lines on
unfold Laplacian Lines
sleep 300
expect-deco Line Color off
expect-deco Ridge Angle hidden
expect-fields-above 768
setdeco Drawing Style = Custom
setdeco Surface = As MeshLab Draws It

# what is out of range can be mended, wherever it is, and says what is wrong
setdeco Gradient Threshold t = -1
expect-deco Gradient Threshold t on
expect-fault Gradient Threshold t = is -1\. It has to be
setdeco Gradient Threshold t = 0.8
expect-deco Gradient Threshold t hidden
expect-fault Gradient Threshold t =

$(filter "Compute Laplacian Lines" compute)
$(filter "Generate Laplacian Lines Polylines" polylines)
$(filter "Export Laplacian Lines Drawing" drawing)
END

# with larger letters as well, and other decorations beside it
QT_FONT_DPI=120 drive <<END
wait
open torus.ply
check Laplacian Lines on
unfold Laplacian Lines
sleep 300
window 1366x768
setdeco Parameters = All
sleep 300
check Show Quality Contour on
check Show Normal on
setdeco Lines = Apparent Ridges
sleep 300
screen panel_large.png
expect-window-within 1366x768
check Laplacian Lines off
sleep 300
check Laplacian Lines on
sleep 300
expect-window-within 1366x768
END
