#!/usr/bin/env bash
# Builds the fuzzers of all that comes over the radio and of mission files, and lets each run for so many seconds (30), from the seeds in the project and what earlier runs
# have found (build/fuzz/corpus). A finding is a file in build/fuzz/findings.
set -euo pipefail
cd "$(dirname "$0")/.."
export seconds=${1:-30}
cmake --preset fuzz
cmake --build --preset fuzz

seedsOf() {
    case $1 in
    frame_decoder_fuzz) echo tests/golden/wire ;;
    mavlink_fuzz) echo tests/golden/mavlink ;;
    esac
    [ ! -d "tests/fuzz/corpus/$1" ] || echo "tests/fuzz/corpus/$1"
}
runOne() {
    local name=$1
    mkdir -p "build/fuzz/corpus/$name" build/fuzz/findings
    # shellcheck disable=SC2046
    "build/fuzz/tests/fuzz/$name" -max_total_time="$seconds" -artifact_prefix="build/fuzz/findings/$name-" \
        -print_final_stats=1 "build/fuzz/corpus/$name" $(seedsOf "$name") >"build/fuzz/$name.log" 2>&1 ||
        {
            tail -n 40 "build/fuzz/$name.log"
            return 1
        }
    echo "$name: $(sed -n 's/^stat::number_of_executed_units: *//p' "build/fuzz/$name.log") inputs, nothing found"
}
export -f runOne seedsOf
# Those that the preset builds; plan_files_fuzz is left to those who name it.
basename -a -s .cpp tests/fuzz/*_fuzz.cpp | grep -v plan_files | xargs -P "$(nproc)" -I{} bash -c 'runOne {}'
