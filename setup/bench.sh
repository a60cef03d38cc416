# SPDX-License-Identifier: GPL-3.0-or-later
# Times of the core: which meshes, and how the programs in benchmarks/ are built and run.

# build_benchmarks CHECKOUT TARGET PACKAGES...: sets PROGRAM
build_benchmarks() {
    local checkout=$1 target=$2
    ensure_packages "${CORE_PACKAGES[@]}" "${@:3}"
    say "building $target"
    configure "$checkout" -DLAPLACIAN_LINES_BUILD_BENCHMARKS=ON
    compile "$checkout" "$target"
    PROGRAM=$(build_folder "$checkout")/benchmarks/$target
}

# scanned_model CHECKOUT NAME: sets MESH to a model of the table
scanned_model() {
    case $2 in
    dragon) (stanford_dragon) && stanford_dragon ;;
    dragon_res2) (stanford_dragon _res2) && stanford_dragon _res2 ;;
    *)
        MESH=$(compgen -G "$(dirname "$1")/shared/models/$2.*.gz") # models that may lie beside the repository
        ;;
    esac
}

# scanned_models CHECKOUT NAME...: sets MODELS to those that can be had
scanned_models() {
    local checkout=$1 name
    MODELS=()
    for name in "${@:2}"; do
        if scanned_model "$checkout" "$name"; then
            MODELS+=("$MESH")
        else
            say "left out: the model $name cannot be had"
        fi
    done
}

commit_of() {
    git -C "$1" describe --always --dirty --abbrev=12 2>/dev/null || printf 'unknown\n'
}

# measure_models PROGRAM CHECKOUT JSON ARGS...: prints the table; JSON takes all figures, unless it is empty
measure_models() {
    local program=$1 checkout=$2 json=$3 work
    shift 3
    work=$(mktemp -d)
    printf 'Commit %s; ' "$(commit_of "$checkout")"
    "$program" --json "$work/core" "$@" || {
        rm -rf "$work"
        return 1
    }
    if [[ -n $json ]]; then
        printf '{"commit": "%s",\n"core": %s}\n' "$(commit_of "$checkout")" "$(<"$work/core")" >"$json" ||
            fail "cannot write $json"
    fi
    rm -rf "$work"
}

# count_instructions PROGRAM MESH: a table of the instructions of redraws
count_instructions() {
    local program=$1 mesh=$2 work
    work=$(mktemp -d)
    say "counting instructions in callgrind: some minutes"
    OMP_NUM_THREADS=1 valgrind --tool=callgrind --instr-atstart=no --callgrind-out-file="$work/dump" \
        "$program" "$mesh" >"$work/redraws" 2>"$work/log" || {
        tail -n 5 "$work/log" >&2
        rm -rf "$work"
        fail "the instructions could not be counted"
    }
    printf '| instructions | a redraw, millions | a vertex | a triangle with a crossing |\n|---|--:|--:|--:|\n'
    awk -F '\t' '
        /^desc: Trigger: Client Request: / { key = substr($0, 34) }
        /^totals: / { total[key] = substr($0, 9) }
        NF == 5 {
            printf "| %s | %.1f | %.0f | %.0f |\n", $2, total[$1] / $3 / 1e6, total[$1] / $3 / $4, total[$1] / $5
        }' $(find "$work" -name 'dump*') "$work/redraws"
    rm -rf "$work"
}
