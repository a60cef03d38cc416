# SPDX-License-Identifier: GPL-3.0-or-later
# MeshLab with Laplacian lines switched on, in a window or on a picture. The GUI driver does the clicking.

require environment/messages product/display product/models product/private_home

readonly LINES_ACTION="Laplacian Lines"
readonly SHEET_FONT=/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf # of DISPLAY_PACKAGES
readonly MESHLAB_MINUTES=15 # more than a mesh of ten million triangles takes to load and prepare

# run_meshlab STAGE FOLDER: MeshLab with the driver script FOLDER/script; its chatter goes to FOLDER/log.
run_meshlab() {
    LAPLACIAN_LINES_DRIVER=$2/script "$1/bin/meshlab" >"$2/log" 2>&1
}

# What went wrong, in the driver's words, else the last lines of MeshLab's own.
explain_failure() {
    local reason
    reason=$(sed -n 's/^meshlab_driver: error: line [0-9]*: //p' "$1/log" | tail -n 1)
    if [[ -n $reason ]]; then
        say "$reason"
    else
        tail -n 5 "$1/log" >&2
    fi
}

# user_settings FOLDER: the driver's commands in FOLDER/settings, if there is such a file
user_settings() {
    [[ ! -e $1/settings ]] || cat "$1/settings"
}

# open_window STAGE FOLDER: of MESH. MeshLab keeps what was set in its dialogs only if it is told to.
open_window() {
    local stage=$1 folder=$2
    {
        printf '%s\n' "time-limit $((MESHLAB_MINUTES * 60))" wait "open $MESH" "check $LINES_ACTION on"
        user_settings "$folder"
    } >"$folder/script"
    say "opening MeshLab; $LINES_ACTION is under Render"
    run_meshlab "$stage" "$folder" || {
        explain_failure "$folder"
        fail "MeshLab ended with an error"
    }
}

check_picture() {
    [[ $1 == *.png ]] || fail "the picture has to be a .png file, not $1"
    [[ -d $(dirname "$1") && -w $(dirname "$1") ]] || fail "cannot write into the folder of $1"
}

# picture_script FOLDER SIZE VIEW: a drawing on white paper that the mesh fills, written to FOLDER/picture.png. The style
# Publication looks the same, but what the user sets besides would not count; framed before that, all drawings of a mesh
# lie on each other.
picture_script() {
    local folder=$1 size=$2 view=$3
    printf '%s\n' "time-limit $((MESHLAB_MINUTES * 60))" wait "open $MESH" \
        "check Show Info Panel off" "check Show Trackball off" "check $LINES_ACTION on" \
        "setdeco Surface = Paper" "setdeco Background = Paper Color" "size $size"
    [[ -z $view ]] || printf 'orbit %s\n' "${view/,/ }"
    printf 'fill-view\n'
    user_settings "$folder"
    printf '%s\n' "grab $folder/picture.png" quit
}

# draw STAGE FOLDER PICTURE SIZE VIEW: one picture of MESH, written to PICTURE
draw() {
    local stage=$1 folder=$2 picture=$3 size=$4 view=$5
    picture_script "$folder" "$size" "$view" >"$folder/script"
    say "drawing $size in MeshLab"
    (
        use_private_home "$folder/home"
        run_meshlab "$stage" "$folder"
    ) || {
        explain_failure "$folder"
        fail "no picture was written"
    }
    mv "$folder/picture.png" "$picture"
}

# take_pictures STAGE FOLDER PICTURE SIZE VIEWS MESHES: VIEWS and MESHES name arrays. One picture, or a sheet of one for
# each mesh and view.
take_pictures() {
    local stage=$1 folder=$2 picture=$3 size=$4 target mesh view
    local -n all_views=$5 all_meshes=$6
    local -a sheet=()
    target=$(readlink -f "$(dirname "$picture")")/$(basename "$picture")
    # room for the window around the view and for the dialogs beside it
    start_display $((${size%x*} + 600)) $((${size#*x} + 300))
    for mesh in "${all_meshes[@]}"; do
        prepare_mesh "$mesh" "$folder"
        for view in "${all_views[@]}"; do
            draw "$stage" "$folder" "$folder/sheet_${#sheet[@]}.png" "$size" "$view"
            sheet+=(-label "$(basename "$MESH") ${view/,/°, }${view:+°}" "$folder/sheet_${#sheet[@]}.png")
        done
    done
    if ((${#sheet[@]} == 3)); then
        mv "$folder/sheet_0.png" "$target"
    else
        montage -font "$SHEET_FONT" -pointsize 18 "${sheet[@]}" -geometry +8+8 "$target" || fail "ImageMagick's montage could not put the sheet together"
    fi
    say "the picture is $target"
}
