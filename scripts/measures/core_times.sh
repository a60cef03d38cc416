# SPDX-License-Identifier: GPL-3.0-or-later
# Times of the core: which meshes, and how the programs in benchmarks/ are built and run.

require environment/build environment/messages environment/packages product/models

# build_benchmarks CHECKOUT TARGET PACKAGES...: sets PROGRAM
build_benchmarks() {
    local checkout=$1 target=$2
    ensure_packages "${CORE_PACKAGES[@]}" "${@:3}"
    say "building $target"
    build_targets "$checkout" "$target" -- -DLAPLACIAN_LINES_BUILD_BENCHMARKS=ON
    PROGRAM=$(build_folder "$checkout")/benchmarks/$target
}

# table_models CHECKOUT NAME...: sets MODELS to those that can be had, or to one of our own making
table_models() {
    local checkout=$1 name
    MODELS=()
    for name in "${@:2}"; do
        if [[ $name != dragon* ]]; then
            ! model_beside "$checkout" "$name" || MODELS+=("$MESH")
        elif (stanford_dragon "${name#dragon}"); then
            MODELS+=("$(dragon_file "${name#dragon}")")
        else
            say "left out: the model $name cannot be fetched"
        fi
    done
    if ((${#MODELS[@]})); then return; fi
    bumpy_torus
    MODELS=("$MESH")
}

commit_of() {
    git -C "$1" describe --always --dirty --abbrev=12 2>/dev/null || printf 'unknown\n'
}

# measure_core PROGRAM COMMIT FILE ARGS...: prints the table; FILE takes all figures as JSON
measure_core() {
    local program=$1 commit=$2 file=$3
    shift 3
    printf 'Commit %s\n' "$commit"
    "$program" --json "$file" "$@" || fail "the table could not be made"
}

# measure_in_meshlab CHECKOUT MESH FILE: a table of what the plugins take there; FILE takes JSON, null if it is left out
measure_in_meshlab() {
    local checkout=$1 mesh=$2 file=$3 package
    printf 'null\n' >"$file"
    for package in meshlab xvfb; do
        package_installed "$package" || {
            say "left out: times in MeshLab, for the package $package is not installed"
            return 0
        }
    done
    say "measuring in MeshLab"
    "$checkout/benchmarks/in_meshlab.sh" "$mesh" >"$file.part" || {
        say "left out: times in MeshLab"
        return 0
    }
    mv "$file.part" "$file"
    printf '\n| in MeshLab, %s | |\n|---|--:|\n' "$(basename "$mesh")"
    grep -oE '"[a-z_]+": [0-9.]+' "$file" | sed -E 's/"([a-z_]+)_(m?s)": (.*)/| \1, \2 | \3 |/; s/_/ /g'
}

# join_figures COMMIT CORE IN_MESHLAB: one JSON object of files with JSON
join_figures() {
    printf '{"commit": "%s",\n"core": %s,\n"in_meshlab": %s}\n' "$1" "$(<"$2")" "$(<"$3")"
}

# count_instructions PROGRAM MESH: a table of the instructions of redraws
count_instructions() {
    local program=$1 mesh=$2 work
    work=$(mktemp -d)
    say "counting instructions in callgrind: a minute"
    {
        "$program" --prepare "$work/mesh" "$mesh" &&
            valgrind --tool=callgrind --instr-atstart=no --callgrind-out-file="$work/dump" \
                "$program" "$work/mesh"
    } >"$work/redraws" 2>"$work/log" || {
        tail -n 5 "$work/log" >&2
        rm -rf "$work"
        fail "the instructions could not be counted"
    }
    printf '| instructions | a redraw, millions | a vertex | a triangle with a crossing |\n|---|--:|--:|--:|\n'
    awk -F '\t' '
        sub(/^desc: Trigger: Client Request: /, "") { key = $0 }
        sub(/^totals: /, "") { total[key] = $0 }
        NF == 5 {
            triangle = $5 ? sprintf("%.0f", total[$1] / $5) : "–"
            printf "| %s | %.1f | %.0f | %s |\n", $2, total[$1] / $3 / 1e6, total[$1] / $3 / $4, triangle
        }' "$work"/dump* "$work/redraws"
    rm -rf "$work"
}
