# SPDX-License-Identifier: GPL-3.0-or-later
# The machine's own apt sources: its mirror, and the same rewritten to source packages (deb-src). Reads them, never
# changes them.

# debian_mirror: the mirror that this machine's own release comes from
debian_mirror() {
    (
        # shellcheck source=/dev/null
        source /etc/os-release
        [[ ${ID:-} == debian ]] || exit 1
        # shellcheck disable=SC2016 # apt-get's own variables
        apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' |
            awk -v release="${VERSION_CODENAME:-none}" '$2 == release && $3 == "main" { print $1; exit }'
    )
}

# One-line style: "deb [options] uri suite components".
classic_source_entries() {
    local file
    for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
        [[ -r $file ]] || continue
        sed -nE '/cdrom:/d; s/^[[:space:]]*deb(-src)?[[:space:]]/deb-src /p' "$file"
    done | sort -u
}

# deb822 style: paragraphs of fields, where "Enabled: no" must keep its meaning.
deb822_source_entries() {
    local file
    for file in /etc/apt/sources.list.d/*.sources; do
        [[ -r $file ]] || continue
        sed -E 's/^Types:.*/Types: deb-src/I; /^#/d' "$file"
        printf '\n'
    done
}

# write_source_list FOLDER: entries for apt's sourceparts folder.
write_source_list() {
    mkdir -p "$1" && classic_source_entries >"$1/classic.list" && deb822_source_entries >"$1/deb822.sources"
}

# write_debian_source_list FOLDER SUITE: the same for another release of Debian, from the mirror of this machine's own.
write_debian_source_list() {
    local mirror keyring=/usr/share/keyrings/debian-archive-keyring.gpg options=
    mirror=$(debian_mirror) && [[ -n $mirror ]] || return 1
    [[ ! -r $keyring ]] || options="[signed-by=$keyring] "
    mkdir -p "$1"
    printf 'deb-src %s%s %s main\n' "$options" "$mirror" "$2" >"$1/debian.list"
}
