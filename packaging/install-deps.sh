#!/usr/bin/env bash
# Installs the Debian 12 packages that are missing; does nothing, and needs no network, when none is.
#   install-deps.sh build    what it takes to build and run the programs
#   install-deps.sh [test]   also what the tests, checks and benchmarks need
set -euo pipefail
export LC_ALL=C.UTF-8

packages=(
    g++ cmake ninja-build ccache pkg-config
    qt6-base-dev qt6-serialport-dev qt6-svg-dev
    libeigen3-dev libexpected-dev libtomlplusplus-dev libcli11-dev nlohmann-json3-dev
    libopencv-dev libgdal-dev librsvg2-dev libssl-dev libsodium-dev libsqlitecpp-dev libsqlite3-dev
    libboost-dev
)
test_packages=(
    libgtest-dev librapidcheck-dev libproj-dev libbenchmark-dev
    clang-format-14 clang-tidy-14 clang-14 libclang-rt-14-dev
    xvfb xauth
)

case "${1:-test}" in
build) ;;
test)
    packages+=("${test_packages[@]}")
    # Whose package it is does not matter: others than Debian's bring npm with node.
    command -v node >/dev/null || packages+=(nodejs)
    command -v npm >/dev/null || packages+=(npm)
    ;;
*)
    echo "usage: install-deps.sh [build|test]" >&2
    exit 2
    ;;
esac

if ! command -v dpkg-query >/dev/null; then
    echo "This is not Debian: please install these yourself (Debian 12 names): ${packages[*]}" >&2
    exit 1
fi

missing=()
for package in "${packages[@]}"; do
    status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$status" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
        echo "Packages are missing and there is no sudo. As root: apt-get install --no-install-recommends ${missing[*]}" >&2
        exit 1
    fi
    as_root=(sudo)
fi
echo "Installing ${missing[*]}"
options=(-y -q --no-install-recommends -o Dpkg::Use-Pty=0 -o DPkg::Lock::Timeout=120)
if ! { "${as_root[@]}" apt-get update -q &&
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install "${options[@]}" "${missing[@]}"; }; then
    echo "apt-get could not install: ${missing[*]}. See its message above; is this Debian 12, with a network?" >&2
    exit 1
fi
