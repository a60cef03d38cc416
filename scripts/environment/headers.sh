# SPDX-License-Identifier: GPL-3.0-or-later
# MeshLab's headers. No distribution packages them: they come from the source package of the very version that is
# installed, because plugins share MeshLab's classes and a near match would crash.

require environment/apt_sources environment/cache environment/messages environment/packages

# source_apt_get FOLDER ARGS...: apt-get with its sources, lists and cache in FOLDER. The user's own stay untouched.
source_apt_get() {
    local folder=$1
    shift
    # -c is read after the system's configuration, the only place where its hooks can be cleared. Lists of a release in
    # the making run out while a mirror lags behind; source packages are none the worse.
    # Never without all of its lines, or it would be the machine's own lists that apt-get writes.
    cat >"$folder/apt.conf" <<-END || return 1
		#clear APT::Update::Post-Invoke;
		#clear APT::Update::Post-Invoke-Success;
		Dir::Etc::sourcelist "/dev/null";
		Dir::Etc::sourceparts "$folder/sources";
		Dir::State::lists "$folder/lists";
		Dir::Cache "$folder/cache";
		APT::Sandbox::User "";
		Acquire::Check-Valid-Until "false";
	END
    apt-get -qq -c "$folder/apt.conf" "$@"
}

# download_source_package PACKAGE FOLDER [SUITE]: the tarball only; some mirrors lack the other files of a source
# package. PACKAGE may be NAME=VERSION. From this machine's sources, or from another release of Debian.
download_source_package() {
    local package=$1 folder=$2 suite=${3:-}
    if [[ -n $suite ]]; then
        write_debian_source_list "$folder/sources" "$suite" || return 1
    else
        write_source_list "$folder/sources" || return 1
    fi
    mkdir -p "$folder/lists/partial" "$folder/cache"
    # Sources of other vendors often hold no source packages: that alone is no reason to stop.
    source_apt_get "$folder" update || say "not all package sources answered; going on with those that did"
    (cd "$folder" && source_apt_get "$folder" source --tar-only --download-only "$package")
}

# unpack_headers PACKAGE [SUITE] FOLDER
unpack_headers() {
    local package=$1 folder=${*: -1} suite=${3:+$2} apt code=0
    apt=$(mktemp -d) || return 1
    # Wildcards cover vcglib beside src/ (2020.09) and inside it (later).
    download_source_package "$package" "$apt" "$suite" &&
        tar -xf "$(find "$apt" -maxdepth 1 -name 'meshlab_*.orig.tar.*' -print -quit)" -C "$folder" \
            --strip-components=1 --wildcards '*/ML_VERSION' '*/src/common' '*/vcglib/vcg' '*/vcglib/wrap' || code=1
    rm -rf "$apt"
    return "$code"
}

# ensure_headers: sets MESHLAB_SOURCE_DIR.
ensure_headers() {
    local version
    version=$(meshlab_version)
    MESHLAB_SOURCE_DIR=$(cache_folder)/headers/$version
    [[ -d $MESHLAB_SOURCE_DIR/src/common ]] && return 0
    say "fetching the headers of MeshLab $version from the distribution's source package"
    publish_into "$MESHLAB_SOURCE_DIR" unpack_headers "meshlab=$version" ||
        fail "could not fetch the source package of meshlab $version; unpack it yourself and name its folder: cmake -DMESHLAB_SOURCE_DIR=FOLDER"
}
