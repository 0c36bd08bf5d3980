#!/usr/bin/env bash
# Installs node-mavlink, the robot that the end-to-end tests talk to, into build/mavlink_peer. Does nothing, and needs no
# network, when it is there.
set -euo pipefail
cd "$(dirname "$0")/.."
source=tests/e2e/mavlink_peer
target=build/mavlink_peer

if [ -d "$target/node_modules/node-mavlink" ] && cmp -s "$source/package-lock.json" "$target/installed.json"; then
    exit 0
fi
if ! command -v npm >/dev/null; then
    echo "npm is missing: run packaging/install-deps.sh test" >&2
    exit 1
fi
mkdir -p "$target"
rm -f "$target/installed.json"
cp "$source/package.json" "$source/package-lock.json" "$target"
npm ci --prefix "$target" --ignore-scripts --no-audit --no-fund --fetch-retries=1 --fetch-timeout=20000
cp "$source/package-lock.json" "$target/installed.json"
