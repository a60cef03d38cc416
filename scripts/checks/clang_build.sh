# SPDX-License-Identifier: GPL-3.0-or-later
# Builds by clang, with its warnings as errors and with sanitizers. Other checks run what is built.

require environment/build environment/messages environment/packages

CHECK_PACKAGES=(clang libclang-rt-dev llvm cppcheck shellcheck)
SANITIZERS=address,undefined,float-cast-overflow

checks_folder() {
    printf '%s/checks\n' "$(build_folder "$1")"
}

# build_with_clang CHECKOUT FOLDER SANITIZERS TARGETS... -- CMAKE_OPTIONS...: warnings are errors
build_with_clang() {
    local checkout=$1 LAPLACIAN_LINES_BUILD=$2 sanitizers=$3
    shift 3
    # for ccache, which would take the name of this file for a part of what is compiled: its contents are
    local -x CCACHE_IGNOREOPTIONS='-fsanitize-ignorelist=*' CCACHE_EXTRAFILES=$checkout/scripts/cmake/sanitizer_ignorelist.txt
    ensure_toolchain "${TEST_PACKAGES[@]}" "${CHECK_PACKAGES[@]}"
    say "building with clang and the sanitizers $sanitizers"
    build_targets "$checkout" "$@" -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=None \
        "-DCMAKE_CXX_FLAGS=-O1 -gline-tables-only" -DLAPLACIAN_LINES_BUILD_TESTS=ON -DLAPLACIAN_LINES_WERROR=ON \
        "-DLAPLACIAN_LINES_SANITIZE=$sanitizers" -DLAPLACIAN_LINES_PRECOMPILE=OFF # so that missing includes show
}

# build_checks CHECKOUT TARGETS...
build_checks() {
    build_with_clang "$1" "$(checks_folder "$1")" "$SANITIZERS" "${@:2}" -- -DLAPLACIAN_LINES_COUNTERS=ON
}
