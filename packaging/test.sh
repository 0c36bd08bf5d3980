#!/usr/bin/env bash
# Everything that must hold: format, build with address and undefined behaviour sanitizers, clang-tidy, fuzzers, all
# tests.
set -uo pipefail
source "$(dirname "$0")/stage.sh"
stages 8

buildAll() { cmake --build --preset asan; }
# A machine that cannot reach npm goes without: the tests of that robot skip, and say so.
installRobot() { packaging/mavlink-peer.sh || true; }
# What failed and why stands at the end of a long output, where it is looked for.
runTests() {
    ctest --preset asan --parallel "$(nproc)" && return
    grep -E -A 8 ': Failure$|Sanitizer: |runtime error: ' build/asan/Testing/Temporary/LastTest.log | head -n 40
    return 1
}

stage "Installing what is missing" packaging/install-deps.sh test
stage "Installing a robot that speaks MAVLink" installRobot
stage "Checking the format" packaging/format.sh --check
stage "Configuring with sanitizers" cmake --preset asan
stage "Building" buildAll
stage "Checking with clang-tidy" packaging/lint.sh
stage "Fuzzing what reads untrusted bytes, 30 s each" packaging/fuzz.sh 30
stage "Running the tests" runTests

# What was left out comes first, so that ctest's verdict is the last thing on the screen.
log=build/log/test-8.log
sed -n '/^The following tests did not run/,/^$/p' "$log"
grep -E 'tests passed|^Total Test time' "$log"
