#!/usr/bin/env bash
# Runs clang-tidy over the product's sources, or over those given. A build folder of its own, without precompiled
# headers (clang cannot read gcc's), also shows headers that were not included where they are needed.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset dev -B build/lint -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DHEDR_BUILD_TESTS=OFF
# Sources may include what moc makes of them.
cmake --build build/lint --target hedr_radio_autogen hedr_ui_autogen hedr_app_autogen
if [ $# -gt 0 ]; then
    files=("$@")
else
    mapfile -t files < <(find core radio ui app -name '*.cpp' | sort)
fi
# A file that was clean is not looked at again while it, all headers, the flags and the packages stay the same.
clean=${XDG_CACHE_HOME:-$HOME/.cache}/hedr-lint
mkdir -p "$clean"
surroundings() {
    find core radio ui app \( -name '*.h' -o -name CMakeLists.txt \) | sort | xargs sha256sum
    sha256sum .clang-tidy CMakeLists.txt CMakePresets.json cmake/*.cmake packaging/lint.sh
    dpkg-query -W
}
surroundings=$(surroundings | sha256sum)
keyOf() { { echo "$surroundings $1"; cat "$1"; } | sha256sum | cut -c 1-64; }
todo=()
for file in "${files[@]}"; do
    key=$(keyOf "$file")
    [ -e "$clean/$key" ] || todo+=("$file" "$clean/$key")
done
# It counts the warnings in system headers on stderr: they would bury the findings, which go to stdout.
if [ ${#todo[@]} -gt 0 ]; then
    printf '%s\0' "${todo[@]}" |
        xargs -0 -n 2 -P "$(nproc)" bash -c 'clang-tidy-14 -p build/lint --quiet "$0" && touch "$1"' \
            2> >(sed '/^[0-9]* warnings\{0,1\} generated\.$/d' >&2)
fi
echo "${#files[@]} files are clean, $((${#todo[@]} / 2)) of them were looked at."
