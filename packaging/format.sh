#!/usr/bin/env bash
# Formats every source file; with --check only says which are not formatted.
set -euo pipefail
cd "$(dirname "$0")/.."
mapfile -t files < <(find core radio ui app tests -type f \( -name '*.h' -o -name '*.c' -o -name '*.cpp' \) | sort)
if [ "${1:-}" = --check ]; then
    clang-format-14 --dry-run --Werror "${files[@]}"
else
    clang-format-14 -i "${files[@]}"
fi
