#include "core/calibration/wheels/wheel_loops_evidence.h"

#include <algorithm>
#include <utility>

namespace hedr {

namespace {

constexpr std::size_t kEnoughLoops = 8;

bool turnsLeft(const DrivenLoop& loop) { return loop.turned_rad > 0.0; }

std::vector<CalibrationStep> loopSteps(const std::vector<DrivenLoop>& loops) {
    const auto left = std::ranges::count_if(loops, turnsLeft);
    const auto right = static_cast<std::ptrdiff_t>(loops.size()) - left;
    const std::string detail =
        "Start at a mark and end at it, heading as at the start. Four times or more.";
    return {{"Drive round counter-clockwise", detail, left >= 4},
            {"Drive round clockwise", detail, right >= 4}};
}

EvidencePlot endPlot(const std::vector<DrivenLoop>& loops) {
    EvidencePlot plot{"Where drives ended by the wheels", {"Ahead", "m"}, {"Left", "m"}, true};
    EvidenceSeries before{"Old wheels", EvidenceSeries::Shape::kDots};
    EvidenceSeries after{"New wheels", EvidenceSeries::Shape::kSquares};
    for (const DrivenLoop& loop : loops) {
        before.x.push_back(loop.before.position.x);
        before.y.push_back(loop.before.position.y);
        after.x.push_back(loop.after.position.x);
        after.y.push_back(loop.after.position.y);
    }
    plot.series = {std::move(before), std::move(after)};
    return plot;
}

}  // namespace

void addEvidence(WheelLoops& wheels) {
    Calibration& calibration = wheels.calibration;
    const auto count = static_cast<double>(wheels.loops.size());
    calibration.steps = loopSteps(wheels.loops);
    calibration.progress.share = std::min(1.0, count / static_cast<double>(kEnoughLoops));
    calibration.progress.known = std::to_string(wheels.loops.size()) + " closed drives";
    if (wheels.loops.size() < kEnoughLoops)
        calibration.progress.more = "Four each way are a good start";
    calibration.figures = {{"Closed drives used", count}};
    if (wheels.shape.wheelbase_m > 0.0) calibration.plots = {endPlot(wheels.loops)};
}

}  // namespace hedr
