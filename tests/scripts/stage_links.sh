#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The links of a stage: of two plugins with one name the last, none that is no longer wanted, and those that are right
# stay as they are, for a MeshLab that is just starting from there.
set -euo pipefail

# shellcheck source=/dev/null
source "$(readlink -f "$(dirname "${BASH_SOURCE[0]}")")/../../scripts/require.sh" environment/messages product/stage
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/installed" "$work/ours"
touch "$work"/installed/{a,b}.so "$work"/ours/{b,c}.so

link_all "$work/links" "$work"/installed/*.so "$work"/ours/*.so
touch "$work/links/file"
[[ $(cd "$work/links" && readlink a.so b.so c.so) == "$work/installed/a.so
$work/ours/b.so
$work/ours/c.so" ]] || fail "the links are wrong"

before=$(stat -c %i:%z "$work/links/a.so")
link_all "$work/links" "$work"/installed/*.so
[[ $(stat -c %i:%z "$work/links/a.so") == "$before" ]] || fail "a link that was right was made anew"
[[ $(readlink "$work/links/b.so") == "$work/installed/b.so" ]] || fail "a link still leads to our plugin"
[[ ! -L $work/links/c.so && -e $work/links/file ]] || fail "a link is left, or a file was removed"
