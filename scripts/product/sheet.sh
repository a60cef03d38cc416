# SPDX-License-Identifier: GPL-3.0-or-later
# Sheets of pictures of one size, each with a label, as wide as a screen shows.

require environment/messages

readonly SHEET_FONT=/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf # of DISPLAY_PACKAGES
readonly SHEET_WIDTH=3840 SHEET_HEIGHT=16000 # pixels, at most: the widest usual screen; ImageMagick's limit
readonly SHEET_GAP=8 LABEL_HEIGHT=60         # around a cell; two lines

# plain_label TEXT: for ImageMagick, which reads UTF-8, and to which %, \ and a first @ say something
plain_label() {
    local text=${1//[[:cntrl:]]/?}
    iconv -f UTF-8 <<<"$text" >/dev/null 2>&1 || text=$(LC_ALL=C && printf '%s' "${text//[^ -~]/?}")
    text=${text//\\/\\\\}
    printf '%s' "${text//%/%%}" | sed 's/^@/\\@/'
}

# whole_share N PARTS: rounded up
whole_share() {
    printf '%d\n' "$((($1 + $2 - 1) / $2))"
}

# sheet_columns CELL_WIDTH COUNT TOGETHER: of COUNT cells, of which TOGETHER stand together: side by side if they fit, in
# rows of nearly the same length if not. With nothing else, as many rows as columns.
sheet_columns() {
    local most=$((SHEET_WIDTH / ($1 + 2 * SHEET_GAP))) count=$2 together=$3 columns=1
    ((most >= 1)) || most=1
    if ((together == 1 || together >= count)); then
        while ((columns * columns < count && columns < most)); do ((++columns)); done
    else
        columns=$(whole_share "$together" "$(whole_share "$together" "$most")")
    fi
    printf '%d\n' "$columns"
}

# sheet_rows COLUMNS COUNT TOGETHER: those that stand together begin a row
sheet_rows() {
    if (($3 == 1)); then
        whole_share "$2" "$1"
    else
        printf '%d\n' "$(($(whole_share "$2" "$3") * $(whole_share "$3" "$1")))"
    fi
}

# lay_out_sheet WIDTHxHEIGHT COUNT TOGETHER: sets SHEET_CELL, the size at which cells are shown, smaller than the pictures if
# the sheet would be too high, and SHEET_COLUMNS
lay_out_sheet() {
    local width=${1%x*} height=${1#*x}
    while SHEET_COLUMNS=$(sheet_columns "$width" "$2" "$3") && ((width > 100)) &&
        (($(sheet_rows "$SHEET_COLUMNS" "$2" "$3") * (height + LABEL_HEIGHT + 2 * SHEET_GAP) > SHEET_HEIGHT)); do
        width=$((width * 4 / 5)) height=$((height * 4 / 5))
    done
    SHEET_CELL=${width}x$height
}

# make_sheet FILE WIDTHxHEIGHT TOGETHER LABEL PICTURE...
make_sheet() {
    local file=$1 together=$3 number=0 cells=()
    lay_out_sheet "$2" $((($# - 3) / 2)) "$together"
    shift 3
    while (($#)); do
        cells+=(-label "$1" "$2")
        shift 2
        ((++number, number % together)) || ((together == 1)) || fill_row "$together"
    done
    montage -font "$SHEET_FONT" -pointsize 18 "${cells[@]}" -tile "${SHEET_COLUMNS}x" \
        -geometry "$SHEET_CELL+$SHEET_GAP+$SHEET_GAP" "$file" || fail "ImageMagick's montage could not put the sheet together"
}

# fill_row TOGETHER: with empty cells after those that stand together
fill_row() {
    local place
    for ((place = $1; place % SHEET_COLUMNS; ++place)); do cells+=(-label "" null:); done
}
