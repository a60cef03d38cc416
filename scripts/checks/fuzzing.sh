# SPDX-License-Identifier: GPL-3.0-or-later
# Fuzzing of the core and of the readers of meshes: inputs made up by libFuzzer, from all registered meshes on, and from
# small files of all formats.

require checks/clang_build environment/in_parallel environment/messages

FUZZ_PARTS=(precompute extract)
FUZZ_FORMATS=(ply stl obj off)
FUZZ_SECONDS=60 # of a check; what is found by chance is looked for by ./test --fuzz

# fuzz_part CHECKOUT SECONDS CORPUS PART: new inputs of interest go to CORPUS/PART
fuzz_part() {
    local folder corpus=$3/$4 work
    folder=$(checks_folder "$1") work=$(checks_folder "$1")/fuzz/$4
    mkdir -p "$work" "$corpus"
    ASAN_OPTIONS=detect_leaks=0 LAPLACIAN_LINES_THREADS=1 LLVM_PROFILE_FILE=/dev/null \
        "$folder/tests/fuzz/fuzz_$4" -max_total_time="$2" -max_len=4096 -len_control=0 -seed=1 -timeout=60 \
        -rss_limit_mb=3000 -artifact_prefix="$work/" -print_final_stats=1 \
        "$corpus" "$folder/fuzz/seeds/$4" "$1/tests/fuzz/found" >"$work/log" 2>&1 ||
        {
            grep -E 'ERROR|runtime error|^[a-z]+: |Test unit written' "$work/log" >&2 || tail -n 20 "$work/log" >&2
            return 1
        }
    awk -v part="$4" '/ cov: / { for (i = 1; i < NF; ++i) if ($i == "ft:") features = $(i + 1) }
        $1 == "stat::number_of_executed_units:" { units = $2 }
        END { print part ": " units " inputs, " features " features" }' "$work/log"
}

# fuzz CHECKOUT SECONDS CORPUS: all parts at once, from seeds that are always the same and from the CORPUS
fuzz() {
    local seeds
    seeds=$(checks_folder "$1")/fuzz/seeds
    rm -rf "$seeds"
    LLVM_PROFILE_FILE=/dev/null "$(checks_folder "$1")/tests/fuzz/write_seeds" "$seeds" ||
        fail "the fuzzers' seeds could not be written"
    say "fuzzing twice for $2 seconds"
    { in_parallel fuzz_part "$1" "$2" "$3" -- "${FUZZ_PARTS[@]}" &&
        in_parallel fuzz_part "$1" "$2" "$3" -- "${FUZZ_FORMATS[@]}"; } ||
        fail "an input broke something: copy the file named above to tests/fuzz/found, where a test runs it, and fix the code"
}

# Forgets what it has learnt, so that it does much the same each time.
check_by_fuzzing() {
    local corpus found
    corpus=$(checks_folder "$1")/fuzz/new
    rm -rf "$corpus"
    found=$(fuzz "$1" "$FUZZ_SECONDS" "$corpus") || return 1
    printf '%s\n' "${found//$'\n'/; }"
}

# fuzz_alone CHECKOUT SECONDS: what it learns is kept in the build folder for the next time
fuzz_alone() {
    build_checks "$1" "${FUZZ_PARTS[@]/#/fuzz_}" "${FUZZ_FORMATS[@]/#/fuzz_}" write_seeds
    fuzz "$1" "$2" "$(checks_folder "$1")/fuzz/corpus"
}
