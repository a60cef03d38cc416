# SPDX-License-Identifier: GPL-3.0-or-later
# Other releases of Debian in folders ("roots"), to build and test with the MeshLab that they package. Made by
# debootstrap from the mirror that this machine's apt uses, and entered in namespaces of their own: whatever is mounted
# there is gone when the last process ends, however it ends. Functions that cannot do their work set OBSTACLE.

require environment/apt_sources environment/build environment/cache environment/messages environment/obstacles
require environment/packages

root_folder() {
    printf '%s/roots/%s\n' "$(cache_folder)" "$1"
}

# machine_apt_settings: how this machine reaches its mirrors, for the apt of a root
machine_apt_settings() {
    apt-config dump | grep -Ei '^Acquire::(http|https|ftp|ForceIPv|Retries|Check-)' || true
    # testing's lists run out while a mirror or a frozen snapshot of it lags behind
    printf '%s\n' 'Acquire::Check-Valid-Until "false";' 'Acquire::Languages "none";' 'APT::Sandbox::User "";'
}

# in_root ROOT ACCESS BINDS... -- COMMAND...: runs COMMAND in ROOT, which it sees with ACCESS (ro or rw). A bind,
# ro:FOLDER or rw:FOLDER, is a folder of this machine that is there under the same name; ro:FOLDER=NAME under another.
# Only with ACCESS rw is there a network.
in_root() {
    local network=()
    [[ $2 == rw ]] || network=(--net)
    LAPLACIAN_LINES_CACHE=$(cache_folder) setpriv --pdeathsig KILL \
        unshare --mount --pid --fork --kill-child --ipc "${network[@]}" "$(dirname "${BASH_SOURCE[0]}")/enter_root" "$@"
}

# What a root is made from: when this changes, it is made anew.
root_recipe() {
    {
        printf '%s\n' "$@" "${BUILD_PACKAGES[@]}" "${DISPLAY_PACKAGES[@]}" "${TEST_PACKAGES[@]}" "${MESHLAB_RECOMMENDS[@]}"
        declare -f build_root make_bare_root install_into_root
    } | sha256sum | cut -d ' ' -f 1
}

make_bare_root() {
    local suite=$1 mirror=$2 root=$3 packages=$4
    # debootstrap of an older release knows no newer one, but all are made like sid
    setpriv --pdeathsig KILL unshare --mount --pid --fork --kill-child --mount-proc \
        debootstrap --variant=minbase --include=ca-certificates --cache-dir="$packages" \
        "$suite" "$root" "$mirror" /usr/share/debootstrap/scripts/sid || return 1
    machine_apt_settings >"$root/etc/apt/apt.conf.d/00laplacian-lines"
}

# install_into_root CHECKOUT ROOT PACKAGES: what ./test would install there, MeshLab's headers included
install_into_root() {
    local checkout=$1 root=$2 packages=$3 binds=()
    local file
    for file in /etc/resolv.conf /etc/hosts /etc/ssl/certs /etc/apt/auth.conf.d; do
        [[ ! -e $file ]] || binds+=("ro:$(readlink -f "$file")=$file")
    done
    mkdir -p "$(cache_folder)/headers"
    # shellcheck disable=SC2016 # for the shell in the root
    in_root "$root" rw "${binds[@]}" "ro:$checkout" "rw:$(cache_folder)/headers" "rw:$packages=/var/cache/apt/archives" -- \
        bash -c 'source "$1/scripts/require.sh" environment/build && ensure_toolchain "${DISPLAY_PACKAGES[@]}" "${TEST_PACKAGES[@]}"' \
        bash "$checkout"
}

# build_root SUITE MIRROR CHECKOUT RECIPE FOLDER
build_root() {
    local packages
    packages=$(cache_folder)/packages/$1 # kept, so that a root made anew downloads only what is new
    mkdir -p "$packages/partial"
    make_bare_root "$1" "$2" "$5" "$packages" && install_into_root "$3" "$5" "$packages" || return 1
    printf '%s\n' "$4" >"$5/recipe"
}

can_make_roots() {
    ((EUID == 0)) || obstacle "making a root takes root's rights" || return 1
    (ensure_packages debootstrap) || obstacle "debootstrap could not be installed" || return 1
    unshare --mount --pid --fork --net --ipc true 2>/dev/null ||
        obstacle "this machine does not allow mounts of one's own (unshare)"
}

# ensure_root SUITE CHECKOUT: sets ROOT, locked against being replaced until the calling script ends
ensure_root() {
    local suite=$1 checkout=$2 mirror recipe
    ROOT=$(root_folder "$suite")
    can_make_roots || return 1
    mirror=$(debian_mirror) && [[ -n $mirror ]] ||
        obstacle "roots are made from this machine's Debian mirror, and its apt configuration names none" || return 1
    recipe=$(root_recipe "$suite" "$mirror")
    mkdir -p "$(dirname "$ROOT")"
    exec {ROOT_LOCK}>"$ROOT.lock"
    flock --shared "$ROOT_LOCK"
    root_is_made_from "$recipe" && return 0
    if ! flock --nonblock "$ROOT_LOCK"; then
        say "$ROOT has to be made anew: waiting until no other tests use it"
        flock "$ROOT_LOCK"
    fi
    root_is_made_from "$recipe" || make_root "$suite" "$mirror" "$checkout" "$recipe" || return 1
    flock --shared "$ROOT_LOCK"
}

root_is_made_from() {
    [[ $(cat "$ROOT/recipe" 2>/dev/null) == "$1" ]]
}

make_root() {
    say "making a root of Debian $1 in $ROOT: 1.3 GB, a few minutes"
    rm -rf "$ROOT".?????? # of a run that was killed
    quietly "$ROOT.log" publish_into "$ROOT" build_root "$@" ||
        obstacle "the root of Debian $1 could not be made; its log is $ROOT.log"
}
