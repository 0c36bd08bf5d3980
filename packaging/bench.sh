#!/usr/bin/env bash
# Builds the release and runs all benchmarks: one table. Arguments go to Google Benchmark
# (--benchmark_filter=Decoder). Times differ between machines: read the ratios to the reference beside each.
set -uo pipefail
source "$(dirname "$0")/stage.sh"
stages 3

stage "Installing what is missing" packaging/install-deps.sh test
stage "Configuring the release" cmake --preset release
stage "Building the benchmarks" cmake --build --preset release --target hedr_bench
export QT_QPA_PLATFORM="${QT_QPA_PLATFORM:-offscreen}"
exec build/release/tests/bench/hedr_bench "$@"
