# SPDX-License-Identifier: GPL-3.0-or-later
# ./run --drawing: measured drawings by our own program, which needs no display.

require environment/build environment/messages environment/packages product/models

DRAWING_PACKAGES=(fonts-dejavu-core)

# build_drawing_program CHECKOUT
build_drawing_program() {
    ensure_toolchain "${DRAWING_PACKAGES[@]}"
    configure "$1"
    compile "$1" laplacian_lines_drawing
}

# run_drawing CHECKOUT FOLDER ARGS...: ARGS as the program takes them, but that MESH may be missing or gzipped; FOLDER
# takes unpacked copies.
run_drawing() {
    local program folder=$2 arguments=() files=()
    program=$(build_folder "$1")/bin/laplacian_lines_drawing
    shift 2
    while (($#)); do
        case $1 in
        -h | --help)
            "$program" --help
            return
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
    ((${#files[@]})) || fail "--drawing needs the name of a file: FILE.svg, FILE.pdf or FILE.dxf"
    ((${#files[@]} <= 2)) || fail "one mesh at a time: ${files[1]} or ${files[2]}?"
    [[ -z ${files[1]:-} ]] || check_mesh "${files[1]}"
    prepare_mesh "${files[1]:-}" "$folder"
    "$program" "${files[0]}" "${arguments[@]}" "$MESH"
}
