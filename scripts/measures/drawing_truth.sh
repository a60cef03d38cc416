# SPDX-License-Identifier: GPL-3.0-or-later
# Measured drawings against what has to be seen: exact lines of CAD parts, and silhouettes of meshes of every kind.

require environment/build environment/cache environment/messages environment/python_environments product/models

EXACT_LINES_TOOLS=(cadquery==2.5.2)
TRUTH_SCANS=(bunny igea armadillo)

# part_folder CHECKOUT: where the parts are that the generator in CHECKOUT makes
part_folder() {
    printf '%s/cad_parts/%s\n' "$(cache_folder)" \
        "$(cat "$1"/benchmarks/truth/*.py <(echo "${EXACT_LINES_TOOLS[@]}") | sha256sum | cut -c1-12)"
}

# ensure_parts CHECKOUT PART...: sets PART_FILES to those of the parts, of all without PART; some minutes at the first time
ensure_parts() {
    local checkout=$1 folder
    shift
    ensure_python_environment exact_lines 1 "1 GB" "${EXACT_LINES_TOOLS[@]}" || fail "$OBSTACLE"
    folder=$(part_folder "$checkout")
    say "making the missing parts and their exact lines in $folder"
    "$ENVIRONMENT_PYTHON" -B "$checkout/benchmarks/truth/make_parts.py" "$folder" "$@" >&2 ||
        fail "the parts could not be made"
    PART_FILES=("$folder"/*.part)
    (($# == 0)) || PART_FILES=("${@/#/$folder/}") PART_FILES=("${PART_FILES[@]/%/.part}")
}

# build_truth CHECKOUT: sets TRUTH_PROGRAMS, the folder of the two programs
build_truth() {
    ensure_toolchain
    say "building drawing_truth and drawing_silhouettes"
    build_targets "$1" drawing_truth drawing_silhouettes -- -DLAPLACIAN_LINES_BUILD_BENCHMARKS=ON
    TRUTH_PROGRAMS=$(build_folder "$1")/benchmarks/truth
}

# split_truth_arguments ARGS...: sets TRUTH_OPTIONS and TRUTH_NAMES; each option has a value
split_truth_arguments() {
    TRUTH_OPTIONS=() TRUTH_NAMES=()
    while (($#)); do
        if [[ $1 == -* ]]; then
            (($# >= 2)) || fail "$1 needs a value; see ./bench --help"
            TRUTH_OPTIONS+=("$1" "$2")
            shift
        else
            TRUTH_NAMES+=("$1")
        fi
        shift
    done
}

# hold_against_parts CHECKOUT: by TRUTH_OPTIONS, those of TRUTH_NAMES
hold_against_parts() {
    local checkout=$1
    ensure_parts "$checkout" "${TRUTH_NAMES[@]}"
    "$TRUTH_PROGRAMS/drawing_truth" --left-out "$checkout/benchmarks/truth/left_out.tsv" \
        "${TRUTH_OPTIONS[@]}" "${PART_FILES[@]}"
}

# hold_against_silhouettes CHECKOUT: by TRUTH_OPTIONS; TRUTH_NAMES are files of scans, without them those that lie beside
# the checkout, and the dragon if it was fetched
hold_against_silhouettes() {
    local checkout=$1 name
    if ((!${#TRUTH_NAMES[@]})); then
        for name in "${TRUTH_SCANS[@]}"; do
            ! model_beside "$checkout" "$name" || TRUTH_NAMES+=("$MESH")
        done
        [[ ! -s $(dragon_file) ]] || TRUTH_NAMES+=("$(dragon_file)")
    fi
    "$TRUTH_PROGRAMS/drawing_silhouettes" "${TRUTH_OPTIONS[@]}" "${TRUTH_NAMES[@]}"
}
