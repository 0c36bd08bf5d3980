#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/calibration/umbmark.h"
#include "core/reproduction/papers.h"
#include "core/reproduction/runs.h"
#include "core/simulation/umbmark_squares.h"

namespace hedr {

namespace {

constexpr std::uint64_t kOtherDrives = 1000;  // seeds of the drives after the correction

// Samples at which one square begins and ends.
struct Square {
    std::size_t begin = 0;
    std::size_t end = 0;
};

// The wheels stand for longer than at a corner before, between and after the squares.
std::vector<Square> squaresOf(const SimulatedMission& mission) {
    std::vector<Square> squares;
    std::size_t moved = 0;  // last sample whose counts differ from the one before
    std::size_t begin = 0;
    for (std::size_t i = 1; i < mission.sensors.size(); ++i) {
        const bool last = i + 1 == mission.sensors.size();
        const bool moves = mission.sensors[i].odometry != mission.sensors[i - 1].odometry;
        if (!moves && !last) continue;
        const bool paused = mission.truth[i].t_s - mission.truth[moved].t_s > kUmbmarkCornerStop_s;
        if (paused && moved > begin) squares.push_back({begin, moved});
        if (paused) begin = i - 1;
        moved = i;
    }
    return squares;
}

// The way from one pose to another in the first one's axes.
Vector<Robot> wayBetween(const Pose<World>& from, const Pose<World>& to) {
    const Vector<World> way = to.position - from.position;
    const double c = std::cos(from.heading_rad);
    const double s = std::sin(from.heading_rad);
    return {c * way.x + s * way.y, c * way.y - s * way.x};
}

UmbmarkReturns returnsOf(const SimulatedMission& mission) {
    const std::array<std::string_view, 1> names{"odometry"};
    const std::vector<TrackPoint> odometry = tracksOf(mission, names).front();
    UmbmarkReturns returns;
    for (const Square& square : squaresOf(mission)) {
        const auto way = [&square](const std::vector<TrackPoint>& track) {
            return wayBetween(track[square.begin].pose, track[square.end].pose);
        };
        const bool left =
            odometry[square.end].pose.heading_rad > odometry[square.begin].pose.heading_rad;
        auto& errors = left ? returns.counter_clockwise : returns.clockwise;
        errors.push_back(way(mission.truth) - way(odometry));
    }
    return returns;
}

struct Run {
    UmbmarkFit before{};
    UmbmarkFit after{};
};

Run runOf(const UmbmarkSquares& scenario, std::uint64_t seed) {
    Run run;
    const SimulatedMission mission = simulate(scenario, seed);
    const VehicleGeometry believed = mission.vehicle.geometry;
    run.before = fitUmbmark(returnsOf(mission), scenario.side_m, believed).value();
    SimulatedMission again = simulate(scenario, kOtherDrives + seed);
    again.vehicle.geometry = run.before.corrected;
    run.after = fitUmbmark(returnsOf(again), scenario.side_m, run.before.corrected).value();
    return run;
}

template <class Value>
double medianOf(std::span<const Run> runs, Value value) {
    std::vector<double> values;
    for (const Run& run : runs) values.push_back(value(run));
    return median(values);
}

std::vector<Figure> figuresOf(std::span<const Run> runs) {
    const auto mm = [](const UmbmarkFit& fit) { return 1000.0 * fit.largest_systematic_error_m; };
    return {
        {"E_d, found (1.002 was put in)", "", "",
         medianOf(runs, [](const Run& run) { return run.before.diameter_ratio; }), "",
         within(1.0018, 1.0022)},
        {"E_b, found (1.005 was put in)", "", "",
         medianOf(runs, [](const Run& run) { return run.before.wheelbase_ratio; }), "",
         within(1.004, 1.006)},
        {"E_max,syst before", "", "",
         medianOf(runs, [&](const Run& run) { return mm(run.before); }), "mm"},
        {"E_max,syst after, on other drives", "", "",
         medianOf(runs, [&](const Run& run) { return mm(run.after); }), "mm"},
        {"before over after", "cited in \"Gyrodometry\", section 1.1", "one order of magnitude",
         medianOf(runs, [&](const Run& run) { return mm(run.before) / mm(run.after); }), "times",
         atLeast(10.0)},
    };
}

}  // namespace

Reproduction reproduceUmbmark(const ReproductionOptions& options) {
    std::vector<Run> runs;
    for (int seed = 1; seed <= options.seeds; ++seed) {
        runs.push_back(runOf({}, static_cast<std::uint64_t>(seed)));
        options.progress(seed, options.seeds);
    }
    return {.figures = figuresOf(runs),
            .remarks = {"The small-angle form loses accuracy for large errors; a least-squares "
                        "refinement on the ten end points is not here yet.",
                        "Where beta is 0 the radius R of the paper is infinite; E_d is then 1."}};
}

}  // namespace hedr
