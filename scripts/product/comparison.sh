# SPDX-License-Identifier: GPL-3.0-or-later
# Pictures of several kinds of lines, side by side on a sheet, and of edges that are found in pictures of the shaded
# surface. A program that is built from the decoration's own table knows the kinds, and what the driver has to do for each.

require environment/messages product/image_tools

readonly LINE_WIDTH=1.6 # pixels, as in the decoration's table

# Of each column: what is written over it, the detector of edges or -, the driver's commands before and after a picture
declare -ga COLUMN_LABELS=("") COLUMN_DETECTORS=(-) COLUMN_BEFORE=("") COLUMN_AFTER=("")

# read_columns BUILD NAMES SETTING...: those of kinds by their names, with what the user sets besides
read_columns() {
    local build=$1 names=$2 table label detector before after
    shift 2
    table=$("$build/bin/decoration_settings" --kinds "$names" "$@" 2>&1) || fail "--kinds: $table"
    COLUMN_LABELS=() COLUMN_DETECTORS=() COLUMN_BEFORE=() COLUMN_AFTER=()
    while IFS=$'\t' read -r label detector before after; do
        COLUMN_LABELS+=("$label")
        COLUMN_DETECTORS+=("$detector")
        COLUMN_BEFORE+=("$before")
        COLUMN_AFTER+=("$after")
    done <<<"$table"
    ! columns_have_edges || ensure_image_tools
}

columns_have_edges() {
    [[ ${COLUMN_DETECTORS[*]} == *[a-z]* ]]
}

# column_commands COLUMN FILE: those of one picture, after " ; " each
column_commands() {
    [[ -z ${COLUMN_BEFORE[$1]} ]] || printf ' ; %s' "${COLUMN_BEFORE[$1]}"
    printf ' ; grab %s' "$2"
    [[ -z ${COLUMN_AFTER[$1]} ]] || printf ' ; %s' "${COLUMN_AFTER[$1]}"
}

# blur_of FILE: the standard deviation of the kernel, whose size in pixels is in FILE: exp(-r^2 / 4h) has the square root
# of 2h
blur_of() {
    awk '{ printf "%.1f", sqrt(2) * $1 }' "$1"
}

# draw_edges COLUMN BLUR SCALE PICTURE: puts the edges of the picture in its place, with lines that are wider by SCALE
draw_edges() {
    local width
    width=$(awk -v width="$LINE_WIDTH" -v scale="$3" 'BEGIN { print width * (scale > 1 ? scale : 1) }')
    "$IMAGE_PYTHON" "$SCRIPTS/product/picture_edges.py" "${COLUMN_DETECTORS[$1]}" "$2" "$width" "$4" "$4.part.png" &&
        mv "$4.part.png" "$4" || fail "the edges of the picture could not be found"
}
