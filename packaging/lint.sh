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
# It counts the warnings in system headers on stderr: they would bury the findings, which go to stdout.
printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P "$(nproc)" clang-tidy-14 -p build/lint --quiet \
    2> >(sed '/^[0-9]* warnings\{0,1\} generated\.$/d' >&2)
echo "${#files[@]} files are clean."
