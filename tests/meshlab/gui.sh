#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A test that is a script of the driver alone:
#   gui.sh FILE.gui
# "== COMMAND..." runs a function of the harness, or any command, in $WORK, with the lines up to the next one on stdin.
# Among these "@FUNCTION ARGS..." stands for what the function prints; or, after "== let NAME", "@NAME ARGS..." for the
# lines there, with $1 and so on in them. $WORK and $CHECKOUT are folders. # begins a comment. "== display WxH" is the
# size of the screen.
TEST_NAME=$(basename "$1" .gui)
DISPLAY_SIZE=$(sed -n 's/^== display //p' "$1")
DISPLAY_SIZE=${DISPLAY_SIZE:-1700x1000}
source "$(dirname "$(readlink -f "$0")")/harness.sh"
declare -A MACROS=([display]='')

# expand: lines on stdin as what they stand for
expand() {
    local line words text i
    while IFS= read -r line; do
        line=${line//\$WORK/$WORK} line=${line//\$CHECKOUT/$CHECKOUT}
        if [[ $line != @* ]]; then
            printf '%s\n' "$line"
            continue
        fi
        eval "words=(${line#@})"
        if [[ -z ${MACROS[${words[0]}]:-} ]]; then
            "${words[@]}"
            continue
        fi
        text=${MACROS[${words[0]}]}
        for i in 1 2 3 4; do text=${text//\$$i/"${words[i]:-}"}; done
        expand <<<"${text%$'\n'}"
    done
}

# run_part COMMAND: on what stands for BODY
run_part() {
    case $1 in
    '' | 'display '*) ;;
    'let '*) MACROS[${1#let }]=$BODY ;;
    *)
        expand <<<"${BODY%$'\n'}" >"$WORK/part"
        eval "$1" <"$WORK/part"
        ;;
    esac
}

test_file=$(readlink -f "$1")
cd "$WORK" || exit
PART='' BODY=''
while IFS= read -r text <&3; do
    case $text in
    '== '*)
        run_part "$PART"
        PART=${text#== } BODY=''
        ;;
    '#'*) ;;
    *) BODY+=$text$'\n' ;;
    esac
done 3<"$test_file"
run_part "$PART"
