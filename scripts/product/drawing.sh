# SPDX-License-Identifier: GPL-3.0-or-later
# ./run --drawing: measured drawings by our own program, which needs no display.

require environment/build environment/messages environment/packages product/models

DRAWING_PACKAGES=(fonts-dejavu-core)

# build_drawing_program CHECKOUT
build_drawing_program() {
    ensure_toolchain "${DRAWING_PACKAGES[@]}"
    [[ -e $(build_folder "$1")/bin/laplacian-lines ]] || say "building laplacian-lines, for some minutes"
    build_targets "$1" laplacian_lines_drawing
}

# unpack_meshes FOLDER NAME...: sets MESHES to them, files and folders; FOLDER takes unpacked copies, each in a folder
# of its own, since their names may be the same. Without a NAME, the dragon.
unpack_meshes() {
    local folder=$1 name
    shift
    MESHES=()
    for name in "${@:-}"; do
        if [[ -d $name ]]; then
            MESHES+=("$name")
            continue
        fi
        [[ -z $name ]] || check_mesh "$name"
        mkdir -p "$folder/${#MESHES[@]}"
        prepare_mesh "$name" "$folder/${#MESHES[@]}"
        MESHES+=("$MESH")
    done
}

# run_drawing CHECKOUT FOLDER ARGS...: ARGS as the program takes them, but that MESH may be missing or gzipped; FOLDER
# takes unpacked copies.
run_drawing() {
    local program folder=$2 arguments=() files=()
    program=$(build_folder "$1")/bin/laplacian-lines
    shift 2
    while (($#)); do
        case $1 in
        -h | --help | --version)
            "$program" "$1"
            return
            ;;
        --)
            files+=("${@:2}")
            break
            ;;
        --*)
            arguments+=("${@:1:2}")
            shift $(($# < 2 ? 1 : 2))
            ;;
        *)
            files+=("$1")
            shift
            ;;
        esac
    done
    ((${#files[@]})) || fail "--drawing needs the name of a file, FILE.svg, .pdf, .dxf or .png, or of a folder, FOLDER/"
    unpack_meshes "$folder" "${files[@]:1}"
    "$program" "${files[0]}" "${arguments[@]}" "${MESHES[@]}"
}
