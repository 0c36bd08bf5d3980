#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "core/calibration/squares/umbmark_calibration.h"
#include "core/reproduction/papers.h"
#include "core/reproduction/runs.h"
#include "core/simulation/umbmark_squares.h"

namespace hedr {

namespace {

constexpr std::uint64_t kOtherDrives = 1000;  // seeds of the drives after the correction

// The way from one pose to another in the first one's axes.
Vector<Robot> wayBetween(const Pose<World>& from, const Pose<World>& to) {
    const Vector<World> way = to.position - from.position;
    const double c = std::cos(from.heading_rad);
    const double s = std::sin(from.heading_rad);
    return {c * way.x + s * way.y, c * way.y - s * way.x};
}

// The squares of a mission and what a tape measure without a flaw would say of their ends.
struct Squares {
    std::array<SampleSet, 1> sets{};
    std::vector<UmbmarkEnd> ends{};
    UmbmarkReturns returns{};
};

Squares squaresOf(const SimulatedMission& mission) {
    Squares squares{.sets = {{{"simulated", mission.sensors}}}};
    for (const SquareRun& run : squareRunsOf(squares.sets, mission.vehicle).runs) {
        const Pose<World>& start = mission.truth[run.first].pose;
        const UmbmarkEnd end{run.number, wayBetween(start, mission.truth[run.last].pose), {}};
        squares.ends.push_back(end);
        const bool left = run.turning == Turning::kCounterClockwise;
        (left ? squares.returns.counter_clockwise : squares.returns.clockwise)
            .push_back(
                endEquation({&run, end}, mission.vehicle.geometry, UmbmarkRatios::Ones()).way());
    }
    return squares;
}

// E_max,syst of a mission with these wheels.
double largestError_m(SimulatedMission mission, const VehicleGeometry& wheels, double side_m) {
    mission.vehicle.geometry = wheels;
    return fitUmbmark(squaresOf(mission).returns, side_m, wheels)
        .value()
        .largest_systematic_error_m;
}

// With the wheels of the closed form, and with those of least squares.
struct Run {
    UmbmarkFit before{};
    UmbmarkEstimates least_squares{};
    double after_m = 0.0;
    double after_least_squares_m = 0.0;
};

Run runOf(const UmbmarkSquares& scenario, std::uint64_t seed) {
    const SimulatedMission mission = simulate(scenario, seed);
    const VehicleGeometry& believed = mission.vehicle.geometry;
    const Squares squares = squaresOf(mission);
    const SimulatedMission others = simulate(scenario, kOtherDrives + seed);
    Run run{.before = fitUmbmark(squares.returns, scenario.side_m, believed).value()};
    run.least_squares = calibrateUmbmark(squares.sets, squares.ends, mission.vehicle).ratios;
    const VehicleGeometry found = correctedGeometry(
        believed, run.least_squares.diameter_ratio.value, run.least_squares.wheelbase_ratio.value);
    run.after_m = largestError_m(others, run.before.corrected, scenario.side_m);
    run.after_least_squares_m = largestError_m(others, found, scenario.side_m);
    return run;
}

template <class Value>
double medianOf(std::span<const Run> runs, Value value) {
    std::vector<double> values;
    for (const Run& run : runs) values.push_back(value(run));
    return median(values);
}

double mm(double m) { return 1000.0 * m; }

std::vector<Figure> ratioFigures(std::span<const Run> runs) {
    return {
        {"E_d, found (1.002 was put in)", "", "",
         medianOf(runs, [](const Run& run) { return run.before.diameter_ratio; }), "",
         within(1.0018, 1.0022)},
        {"E_d, least squares", "", "",
         medianOf(runs, [](const Run& run) { return run.least_squares.diameter_ratio.value; }), "",
         within(1.0019, 1.0021)},
        {"E_b, found (1.005 was put in)", "", "",
         medianOf(runs, [](const Run& run) { return run.before.wheelbase_ratio; }), "",
         within(1.004, 1.006)},
        {"E_b, least squares", "", "",
         medianOf(runs, [](const Run& run) { return run.least_squares.wheelbase_ratio.value; }), "",
         within(1.0049, 1.0051)},
    };
}

std::vector<Figure> gainFigures(std::span<const Run> runs) {
    const auto before_m = [](const Run& run) { return run.before.largest_systematic_error_m; };
    return {
        {"E_max,syst before", "", "",
         medianOf(runs, [&](const Run& run) { return mm(before_m(run)); }), "mm"},
        {"E_max,syst after, on other drives", "", "",
         medianOf(runs, [](const Run& run) { return mm(run.after_m); }), "mm"},
        {"E_max,syst after, least squares", "", "",
         medianOf(runs, [](const Run& run) { return mm(run.after_least_squares_m); }), "mm"},
        {"before over after", "cited in \"Gyrodometry\", section 1.1", "one order of magnitude",
         medianOf(runs, [&](const Run& run) { return before_m(run) / run.after_m; }), "times",
         atLeast(10.0)},
        {"before over after, least squares", "cited in \"Gyrodometry\", section 1.1",
         "one order of magnitude",
         medianOf(runs, [&](const Run& run) { return before_m(run) / run.after_least_squares_m; }),
         "times", atLeast(10.0)},
    };
}

}  // namespace

Reproduction reproduceUmbmark(const ReproductionOptions& options) {
    std::vector<Run> runs;
    for (int seed = 1; seed <= options.seeds; ++seed) {
        runs.push_back(runOf({}, static_cast<std::uint64_t>(seed)));
        options.progress(seed, options.seeds);
    }
    std::vector<Figure> figures = ratioFigures(runs);
    const std::vector<Figure> gains = gainFigures(runs);
    figures.insert(figures.end(), gains.begin(), gains.end());
    return {
        .figures = std::move(figures),
        .remarks = {"\"Found\" is the paper's closed form, for small angles; least squares fits "
                    "the ten end points with every drive integrated again from its encoders.",
                    "Where beta is 0 the radius R of the paper is infinite; E_d is then 1."}};
}

}  // namespace hedr
