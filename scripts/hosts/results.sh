# SPDX-License-Identifier: GPL-3.0-or-later
# How the stages of a run ended: a line for each as it ends, and all of them at the end of the run.

require environment/durations environment/messages environment/obstacles

RESULTS=()
RUN_FAILED=false
STAGE_BEGAN=$SECONDS

# conclude NAME CODE REMARK REQUIRED: the end of a stage that began when the last one ended. Skipped is what OBSTACLE has
# kept from running, a failure if REQUIRED is true.
conclude() {
    local result=passed${3:+, $3}
    if [[ -n $OBSTACLE ]]; then
        result="skipped: $OBSTACLE"
        ! $4 || RUN_FAILED=true
    elif (($2)); then
        result=FAILED
        RUN_FAILED=true
    fi
    result="$1: $result, $(duration $((SECONDS - STAGE_BEGAN)))"
    RESULTS+=("$result")
    say "$result"
    OBSTACLE= STAGE_BEGAN=$SECONDS
}

# tell_results: fails if a stage has
tell_results() {
    local result
    if ((${#RESULTS[@]} > 1)); then
        say "all stages:"
        for result in "${RESULTS[@]}"; do say "    $result"; done
        say "    together $(duration "$SECONDS")"
    fi
    ! $RUN_FAILED
}
