# SPDX-License-Identifier: GPL-3.0-or-later
# MeshLab with Laplacian lines switched on, on a picture. The GUI driver does the clicking.

require environment/messages environment/whole_files product/comparison product/display product/models product/private_home product/sheet

readonly MESHLAB_MINUTES=15 # more than a mesh of ten million triangles takes to load and prepare
readonly DRIVER_ERROR=3     # the exit code of MeshLab when the driver ends it
readonly NOISE_SEED=1
readonly LINE_SIDE=900      # pixels of a picture's shorter side, above which lines get wider with it
declare -gA NAMED_VIEWS=([front]="0,0" [right]="90,0" [back]="180,0" [left]="-90,0" [top]="0,90" [bottom]="0,-90")

# What the options of a picture say
PICTURE_SIZE=1200x900 PICTURE_UP=y PICTURE_ZOOM=1 PICTURE_PROJECTION=perspective PICTURE_KINDS='' PICTURE_NOISE=''
declare -ga PICTURE_VIEWS=() PICTURE_OPTIONS=()

# picture_option OPTION [VALUE]...: sets them by the first of the words, and OPTION_WORDS to how many it has
picture_option() {
    local option=$1 value=${2:-} number='[0-9]+(\.[0-9]+)?'
    OPTION_WORDS=2
    case $option in
    --size)
        [[ $value =~ ^[1-9][0-9]*x[1-9][0-9]*$ ]] || fail "--size needs WIDTHxHEIGHT, such as 1200x900"
        PICTURE_SIZE=$value
        ;;
    --view)
        [[ -n ${NAMED_VIEWS[${value:-none}]:-} || $value =~ ^-?$number,-?(0*[1-8]?[0-9](\.[0-9]+)?|0*90(\.0+)?)$ ]] ||
            fail "--view needs front, back, left, right, top or bottom, or AZIMUTH,ELEVATION in degrees, such as 30,15; the elevation is from -90 to 90"
        PICTURE_VIEWS+=("$value")
        ;;
    --up)
        [[ $value =~ ^[xyz]$ ]] || fail "--up needs the axis that points upwards: x, y or z"
        PICTURE_UP=$value
        ;;
    --zoom)
        [[ $value =~ ^$number$ ]] && awk -v zoom="$value" 'BEGIN { exit !(zoom >= 0.1 && zoom <= 10) }' ||
            fail "--zoom needs a factor from 0.1 to 10"
        PICTURE_ZOOM=$value
        ;;
    --kinds)
        [[ -n $value && $value != -* ]] || fail "--kinds needs names of kinds of lines with commas between, such as all or apparent_ridges,valleys"
        PICTURE_KINDS=$value
        ;;
    --noise)
        [[ $value =~ ^$number$ ]] && awk -v noise="$value" 'BEGIN { exit !(noise > 0 && noise <= 2) }' ||
            fail "--noise needs a share of the mean edge, above 0 and up to 2"
        PICTURE_NOISE=$value
        ;;
    --orthographic)
        PICTURE_PROJECTION=orthographic
        OPTION_WORDS=1
        ;;
    esac
    PICTURE_OPTIONS+=("$option")
}

# is_odd_name NAME: it would mean something else to the driver, whose lines are UTF-8, or to MeshLab, whose names are of
# the user's locale
is_odd_name() (
    [[ $(locale charmap) == UTF-8 ]] || LC_ALL=C
    [[ $1 == *[^[:print:]]* ]]
)

# drivable_mesh MESH_OR_EMPTY FOLDER: as prepare_mesh(), but MESH is a link if its name is an odd one
drivable_mesh() {
    prepare_mesh "$@"
    is_odd_name "$MESH" || return 0
    ln -s "$MESH" "$2/mesh.${MESH##*.}"
    MESH=$2/mesh.${MESH##*.}
}

# write_driver_script FOLDER TEXT: FOLDER/script. MeshLab without the end of its script would stay open.
write_driver_script() {
    printf '%s\n' "$2" >"$1/script" || fail "cannot write $1/script"
}

# run_meshlab STAGE FOLDER: MeshLab with the driver script FOLDER/script; its chatter goes to FOLDER/log.
run_meshlab() {
    # bash's own remark on a signal goes nowhere
    { LAPLACIAN_LINES_DRIVER=$2/script "$1/bin/meshlab" >"$2/log" 2>&1; } 2>/dev/null
}

# explain_failure FOLDER CODE: why MeshLab has ended, in a line
explain_failure() {
    local log=$1/log code=$2 reason doing
    reason=$(sed -n 's/^meshlab_driver: reason: //p' "$log" | tail -n 1)
    [[ -n $reason ]] || reason=$(sed -n 's/^meshlab_driver: error: //p' "$log" | tail -n 1)
    doing=$(sed -n 's/^meshlab_driver: line [0-9]*: //p' "$log" | tail -n 1)
    if [[ -n $reason ]]; then
        printf '%s\n' "$reason"
    elif [[ $doing == "load "* ]]; then
        printf "MeshLab's own reader of .%s files has ended MeshLab (exit code %d); the file may be damaged\n" "${doing##*.}" "$code"
    else
        printf 'MeshLab has ended with code %d; the last it said: %s\n' "$code" "$(tail -n 1 "$log")"
    fi
}

# user_settings FOLDER: the driver's commands in FOLDER/settings, if there is such a file
user_settings() {
    [[ ! -e $1/settings ]] || cat "$1/settings"
}

check_picture() {
    [[ $1 == *.png ]] || fail "the picture has to be a .png file, not $1"
    [[ ! -d $1 ]] || fail "the picture cannot be $1, which is a folder"
    [[ -d $(dirname "$1") && -w $(dirname "$1") ]] || fail "cannot write into the folder of $1"
}

# frame_command VIEW: has the mesh fill the view, as seen from there
frame_command() {
    local view=${NAMED_VIEWS[${1:-front}]:-$1}
    printf 'frame %s %s %s %s\n' "${view/,/ }" "$PICTURE_UP" "$PICTURE_ZOOM" "$PICTURE_PROJECTION"
}

# drawing ROW VIEW COLUMN: the file of this drawing, by the numbers of the three
drawing() {
    printf '%s/drawing_%d_%d_%d.png\n' "$DRAWINGS" "$1" "$2" "$3"
}

# kernel_file ROW VIEW: takes the size of the kernel in the drawing
kernel_file() {
    printf '%s/kernel_%d_%d\n' "$DRAWINGS" "$1" "$2"
}

# load_commands ROW: opens its mesh, with noise if it has some
load_commands() {
    local noisy=$DRAWINGS/noisy_$1.ply
    printf '%s\n' "load ${MESH_FILES[$1]}"
    [[ -z ${MESH_NOISES[$1]} ]] ||
        printf '%s\n' "write-noisy ${MESH_NOISES[$1]} $NOISE_SEED \"$noisy\"" "trigger Delete Current Mesh" "load $noisy"
}

# drawing_script FIRST FOLDER: draws the rows from the FIRST-th on by one MeshLab, on white paper. What stands between
# "together" and the end of its line is done before MeshLab redraws: each redraw of a large mesh takes its time. The style
# Publication looks the same, but what the user sets besides would not count. Lines show what is large enough for the
# picture, while kinds are compared at one kernel.
drawing_script() {
    local row view column settings=()
    mapfile -t settings < <(user_settings "$2")
    [[ -n $PICTURE_KINDS ]] || settings=("setdeco Scale = With the View" "${settings[@]}")
    printf '%s\n' "time-limit $((MESHLAB_MINUTES * 60))" wait "check Show Layer Dialog on" "check Show Info Panel off" \
        "check Show Trackball off" "size $PICTURE_SIZE" "scale-lines $LINE_SIDE" wait-for-levels
    for ((row = $1; row < ${#MESH_FILES[@]}; ++row)); do
        load_commands "$row"
        printf '%s\n' "size $PICTURE_SIZE"
        printf 'together %s' draw-lines
        printf ' ; %s' "setdeco Surface = Paper" "setdeco Background = Paper Color" "${settings[@]}"
        for view in "${!PICTURE_VIEWS[@]}"; do
            printf ' ; %s' "$(frame_command "${PICTURE_VIEWS[view]}")"
            ! columns_have_edges || printf ' ; write-kernel %s' "$(kernel_file "$row" "$view")"
            for column in "${!COLUMN_LABELS[@]}"; do
                column_commands "$column" "$(drawing "$row" "$view" "$column")"
            done
        done
        printf ' ; %s\n' "trigger Delete Current Mesh"
    done
    printf 'quit\n'
}

# first_undrawn FIRST: the first row from there on whose drawings are not all there, or the number of rows
first_undrawn() {
    local row=$1
    while ((row < ${#MESH_FILES[@]})) &&
        [[ -e $(drawing "$row" $((${#PICTURE_VIEWS[@]} - 1)) $((${#COLUMN_LABELS[@]} - 1))) ]]; do
        ((++row))
    done
    printf '%d\n' "$row"
}

# draw_meshes STAGE FOLDER: all drawings of MESH_FILES, by as few MeshLabs as their failures allow. Sets FAILED_MESHES.
draw_meshes() {
    local stage=$1 folder=$2 first=0 undrawn code
    while ((first < ${#MESH_FILES[@]})); do
        write_driver_script "$folder" "$(drawing_script "$first" "$folder")"
        code=0
        (
            use_private_home "$folder/home"
            run_meshlab "$stage" "$folder"
        ) || code=$?
        undrawn=$(first_undrawn "$first")
        # It may have been brought down by what was drawn before: only a mesh that comes first is to blame.
        if ((undrawn < ${#MESH_FILES[@]})) && ((code == DRIVER_ERROR || undrawn == first)); then
            say "${MESH_NAMES[undrawn]}: $(explain_failure "$folder" "$code")"
            FAILED_MESHES+=("${MESH_NAMES[undrawn]}")
            ((++undrawn))
        fi
        first=$undrawn
    done
}

# add_row FILE NAME NOISE
add_row() {
    MESH_FILES+=("$1")
    MESH_NAMES+=("$2${3:+, with noise}")
    MESH_NOISES+=("$3")
}

# prepare_meshes FOLDER MESH...: fills MESH_FILES and MESH_NAMES with what MeshLab is to draw, a row each, and MESH_NOISES
# with how far its vertices are moved; FAILED_MESHES with the rest
prepare_meshes() {
    local folder=$1 mesh file
    MESH_FILES=() MESH_NAMES=() MESH_NOISES=() FAILED_MESHES=()
    shift
    for mesh in "$@"; do
        mkdir "$folder/${#MESH_FILES[@]}_${#FAILED_MESHES[@]}"
        if file=$(drivable_mesh "$mesh" "$folder/${#MESH_FILES[@]}_${#FAILED_MESHES[@]}" && printf '%s' "$MESH"); then
            add_row "$file" "${mesh:-$(basename "$file")}" ""
            [[ -z $PICTURE_NOISE ]] || add_row "$file" "${mesh:-$(basename "$file")}" "$PICTURE_NOISE"
        else
            FAILED_MESHES+=("$mesh")
        fi
    done
}

# label_of ROW VIEW COLUMN
label_of() {
    local view=${PICTURE_VIEWS[$2]} name=${MESH_NAMES[$1]%, with noise} label blur=
    [[ $view != *,* ]] || view="${view/,/°, }°"
    label="$(plain_label "$(basename "${name%.gz}")")${view:+ $view}"
    [[ -z ${MESH_NOISES[$1]} ]] || label+=", noise of ${MESH_NOISES[$1]} mean edges, seed $NOISE_SEED"
    [[ ${COLUMN_DETECTORS[$3]} == - ]] || blur=", σ = $(blur_of "$(kernel_file "$1" "$2")") px"
    printf '%s%s%s' "$label" "${COLUMN_LABELS[$3]:+\n${COLUMN_LABELS[$3]}}" "$blur"
}

# finish_edges ROW VIEW: finds the edges in its pictures of the shaded surface
finish_edges() {
    local column width=${PICTURE_SIZE%x*} height=${PICTURE_SIZE#*x} scale
    scale=$(awk -v side=$((width < height ? width : height)) -v least="$LINE_SIDE" 'BEGIN { print side / least }')
    for column in "${!COLUMN_LABELS[@]}"; do
        [[ ${COLUMN_DETECTORS[column]} == - ]] ||
            draw_edges "$column" "$(blur_of "$(kernel_file "$1" "$2")")" "$scale" "$(drawing "$1" "$2" "$column")"
    done
}

# has_drawings ROW VIEW: all that the row of a sheet holds
has_drawings() {
    local column
    for column in "${!COLUMN_LABELS[@]}"; do
        [[ -e $(drawing "$1" "$2" "$column") ]] || return 1
    done
}

# put_together FILE: the one drawing that there is, or a sheet of all; there, the kinds of a drawing are together, or the
# views of a mesh
put_together() {
    local target=$1 row view column together=${#COLUMN_LABELS[@]}
    local -a cells=()
    ((together > 1)) || together=${#PICTURE_VIEWS[@]}
    for row in "${!MESH_FILES[@]}"; do
        for view in "${!PICTURE_VIEWS[@]}"; do
            has_drawings "$row" "$view" || continue
            finish_edges "$row" "$view"
            for column in "${!COLUMN_LABELS[@]}"; do
                cells+=("$(label_of "$row" "$view" "$column")" "$(drawing "$row" "$view" "$column")")
            done
        done
    done
    ((${#cells[@]})) || fail "no picture was written"
    if ((${#MESH_FILES[@]} + ${#FAILED_MESHES[@]} == 1 && ${#cells[@]} == 2)); then
        put_file "${cells[1]}" "$target"
    else
        make_sheet "$DRAWINGS/sheet.png" "$PICTURE_SIZE" "$together" "${cells[@]}"
        put_file "$DRAWINGS/sheet.png" "$target"
    fi
    say "the picture is $target"
}

# take_pictures STAGE FOLDER PICTURE MESH...: one picture, or a sheet of one for each mesh, view and column, as the options
# say. A sheet goes on without the meshes that fail, and then ends with an error.
take_pictures() {
    local stage=$1 folder=$2 picture=$3 target
    target=$(readlink -f "$(dirname "$picture")")/$(basename "$picture")
    ((${#PICTURE_VIEWS[@]})) || PICTURE_VIEWS=("")
    DRAWINGS=$folder
    prepare_meshes "$folder" "${@:4}"
    # room for the window around the view and for the dialogs beside it
    start_display $((${PICTURE_SIZE%x*} + 600)) $((${PICTURE_SIZE#*x} + 300))
    say "drawing $((${#MESH_FILES[@]} * ${#PICTURE_VIEWS[@]} * ${#COLUMN_LABELS[@]})) times $PICTURE_SIZE in MeshLab"
    draw_meshes "$stage" "$folder"
    put_together "$target"
    ((${#FAILED_MESHES[@]} == 0)) || fail "not drawn: ${FAILED_MESHES[*]}"
}
