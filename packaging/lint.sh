#!/usr/bin/env bash
# Runs clang-tidy over all of the product's sources, or over those given. Its build folders have no precompiled headers
# (clang cannot read gcc's); so those given are also shown to miss headers that they need.
set -euo pipefail
cd "$(dirname "$0")/.."
export clean=${XDG_CACHE_HOME:-$HOME/.cache}/hedr-lint
mkdir -p "$clean"

# What was clean is not looked at again while it, all headers, the flags and the packages stay the same.
surroundings() {
    find core radio ui app \( -name '*.h' -o -name CMakeLists.txt \) | sort | xargs sha256sum
    sha256sum .clang-tidy CMakeLists.txt CMakePresets.json cmake/*.cmake packaging/lint.sh
    dpkg-query -W
}
surroundings=$(surroundings | sha256sum)
export surroundings
keyOf() { { echo "$surroundings $*" && cat "$@"; } | sha256sum | cut -c 1-64; }
isClean() { [ -e "$clean/$(keyOf "$@")" ]; }
noteClean() { touch "$clean/$(keyOf "$@")"; }

configure() {
    cmake --preset dev -B "$1" -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DHEDR_BUILD_TESTS=OFF "${@:2}"
    # Sources may include what moc makes of them.
    cmake --build "$1" --target hedr_radio_autogen hedr_ui_autogen hedr_app_autogen
}
# The sources that a file of several includes.
membersOf() { sed -En "s,^#include \"$PWD/((core|radio|ui|app)/.*\.cpp)\",\1,p" "$1"; }

# clang-tidy's time goes into the headers, which are looked at once for several sources. Prints those that are not clean
# together, be it that they cannot be compiled as one: each alone decides. That one's name shadows another's means
# nothing where they only meet here.
lintTogether() {
    local members
    mapfile -t members < <(membersOf "$1")
    [ ${#members[@]} -gt 0 ] && ! isClean "${members[@]}" || return 0
    if clang-tidy-14 -p build/lint-together --quiet --checks=-bugprone-suspicious-include --extra-arg=-Wno-shadow \
        --header-filter='(core|ui|app|radio/wire)/.*\.(h|cpp)$|radio/[a-z_]*\.h$|radio/[a-z_/]*\.cpp$' "$1" &>/dev/null
    then
        noteClean "${members[@]}"
    else
        printf '%s\n' "${members[@]}"
    fi
}
# It counts the warnings in system headers on stderr: they would bury the findings, which go to stdout.
lintAlone() {
    isClean "$1" && return
    clang-tidy-14 -p build/lint --quiet "$1" 2> >(sed '/^[0-9]* warnings\{0,1\} generated\.$/d' >&2) && noteClean "$1"
}
export -f keyOf isClean noteClean membersOf lintTogether lintAlone

files=("$@")
if [ $# -eq 0 ]; then
    configure build/lint-together -DHEDR_UNITY_SIZE=32
    mapfile -t files < <(find build/lint-together -name 'unity_*.cxx' -print0 |
        xargs -0 -P "$(nproc)" -I{} bash -c 'lintTogether {}' | sort)
fi
[ ${#files[@]} -eq 0 ] || configure build/lint
printf '%s\0' "${files[@]}" | xargs -0 -r -P "$(nproc)" -I{} bash -c '[ -z "{}" ] || lintAlone {}'
echo "All is clean; ${#files[@]} files were looked at one by one."
