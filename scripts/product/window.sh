# SPDX-License-Identifier: GPL-3.0-or-later
# MeshLab's window with Laplacian lines switched on, of meshes and projects. The GUI driver opens them.

require environment/messages product/picture

is_project() {
    [[ ${1,,} == *.@(mlp|mlb|aln) ]]
}

# find_opening NAME FOLDER: sets OPENING to the driver's command that opens a mesh, a project or, without a NAME, the dragon
find_opening() {
    local project
    if is_project "$1"; then
        project=$(readlink -f -- "$1") # no link elsewhere: the names in it are of files beside it
        ! is_odd_name "$project" || fail "MeshLab cannot open a project of this name, $1: rename it or its folder"
        OPENING="open-project $project"
    else
        mkdir -p "$2"
        drivable_mesh "$1" "$2"
        OPENING="load $MESH"
    fi
}

# open_window STAGE FOLDER NAME...: meshes and projects, in one window. MeshLab keeps what was set in its dialogs only if it
# is told to.
open_window() {
    local stage=$1 folder=$2 name code=0 openings=()
    for name in "${@:3}"; do
        find_opening "$name" "$folder/${#openings[@]}"
        openings+=("$OPENING")
    done
    write_driver_script "$folder" "$(
        printf '%s\n' "time-limit $((MESHLAB_MINUTES * 60))" wait "${openings[@]}" draw-all-lines
        user_settings "$folder"
    )"
    say "opening MeshLab; Laplacian Lines is under Render"
    run_meshlab "$stage" "$folder" || code=$?
    ((code == 0)) || fail "$(last_opened "$folder"): $(explain_failure "$folder" "$code")"
}

# last_opened FOLDER: by MeshLab, as its log says
last_opened() {
    sed -nE 's/^meshlab_driver: line [0-9]+: (load|open-project) //p' "$1/log" | tail -n 1
}
