# shellcheck shell=bash
# Read by the other scripts (source): stages with one line each, their output in build/log.
#   stages 3                   how many there will be
#   stage "Doing it" cmd arg…  runs one; on failure shows the end of its log and stops the script
export LC_ALL=C.UTF-8
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root" || exit 1
stage_number=0
stage_count=0
ticker=

stages() { stage_count=$1; }

# On a terminal, shows how far a build or test run is, once a second, behind the stage's title. It ends by itself
# when its file is gone.
startTicker() {
    [ -t 1 ] || return 0
    local log=$1 title=$2
    ticker="$log.running"
    : >"$ticker"
    (while sleep 1 && kill -0 $$ 2>/dev/null && [ -e "$ticker" ]; do
        printf '\r\033[K%s %s' "$title" "$(grep -oE '^ *\[? *[0-9]+/[0-9]+' "$log" | tail -n 1 | tr -d ' [')"
    done) &
}

stopTicker() {
    [ -n "$ticker" ] || return 0
    rm -f "$ticker"
    ticker=
    printf '\r\033[K'
}
trap stopTicker EXIT

stage() {
    local name=$1 begin=$SECONDS status=0
    shift
    stage_number=$((stage_number + 1))
    local title="[$stage_number/$stage_count] $name …"
    local log
    mkdir -p build/log
    log="build/log/$(basename "$0" .sh)-$stage_number.log"
    : >"$log"
    printf '%s ' "$title"
    startTicker "$log" "$title"
    "$@" >"$log" 2>&1 || status=$?
    if [ -n "$ticker" ]; then
        stopTicker
        printf '%s ' "$title"
    fi
    if [ "$status" -eq 0 ]; then
        echo "done ($((SECONDS - begin)) s)"
        return 0
    fi
    echo "FAILED ($((SECONDS - begin)) s)"
    tail -n 60 "$log"
    echo "$name failed. The whole output is in $root/$log." >&2
    exit 1
}
