#!/usr/bin/env bash
# Shows the main job without a robot: builds the programs, drives a simulated PackBot through the sample building,
# plays its sensors over a pseudo-terminal and follows it on the map. With a screen the window stays until it is
# closed; without one a screenshot is left. Everything is kept in build/demo-runs.
set -uo pipefail
source "$(dirname "$0")/stage.sh"
stages 5

build=build/demo
out="$root/build/demo-runs/$(date +%Y-%m-%d-%H%M%S)"
mkdir -p "$out"
robot_pid=
cleanUp() {
    stopTicker
    [ -z "$robot_pid" ] || kill "$robot_pid" 2>/dev/null
}
trap cleanUp EXIT
trap 'exit 130' INT TERM

configureAndBuild() {
    cmake --preset release -B "$build" -DHEDR_BUILD_BENCHMARKS=OFF &&
        cmake --build "$build" --target hedr hedr-ocu
}

# The robot speaks on a pseudo-terminal as a real one does on a serial adapter, only faster.
startRobot() {
    local start
    start=$(awk -F, 'NR == 2 { printf "%.6f,%.6f,%.6f", $2, $3, $4 * 57.29577951308232 }' "$out/truth.csv")
    "$build/app/hedr" replay "$out/sensors.csv" --vehicle "$out/vehicle.toml" --pty "$out/robot" \
        --initial="$start" --speed "$speed" >"$out/robot.log" 2>&1 &
    robot_pid=$!
    for _ in $(seq 100); do
        [ -e "$out/robot" ] && return 0
        kill -0 "$robot_pid" 2>/dev/null || break
        sleep 0.1
    done
    cat "$out/robot.log"
    return 1
}

follow() {
    "$build/app/hedr-ocu" --port "$out/robot" --plan "$out/plan.toml" --vehicle "$out/vehicle.toml" \
        --out "$out/mission.hedr" "$@"
}

if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
    speed=10
    what="Following the robot; close the window to end"
    options=()
else
    export QT_QPA_PLATFORM=offscreen
    speed=40
    what="Following the robot without a screen"
fi

stage "Installing what is missing" packaging/install-deps.sh build
stage "Building the programs" configureAndBuild
stage "Simulating a drive through the sample building" \
    "$build/app/hedr" simulate packbot-corridors --seed 7 --out "$out"
stage "Starting the robot on a pseudo-terminal" startRobot
if [ "${QT_QPA_PLATFORM:-}" = offscreen ]; then
    # The picture late in the drive but while the robot still talks, the end after its last packet.
    seconds=$(awk -F, -v speed="$speed" 'END { printf "%d", $1 / speed }' "$out/truth.csv")
    options=(--screenshot "$out/screenshot.png" --after "$((seconds - 4))" --exit-after "$((seconds + 3))")
fi
stage "$what" follow "${options[@]}"

[ ! -e "$out/screenshot.png" ] || echo "Screenshot: $out/screenshot.png"
echo "Mission:    $out/mission.hedr"
echo "Truth:      $out/truth.csv"
