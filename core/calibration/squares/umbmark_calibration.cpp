#include "core/calibration/squares/umbmark_calibration.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/calibration/squares/umbmark_evidence.h"
#include "core/calibration/squares/umbmark_pairing.h"
#include "core/calibration/squares/umbmark_text.h"

namespace hedr {

namespace {

constexpr std::size_t kFewestEachWay = 2;
constexpr double kWorstFitOfASide = 0.1;  // rms: ends scatter less, even where wheels slip
constexpr double kChanceOfDirections = 0.01;
constexpr double kSureOfNearer = 0.99;
constexpr std::string_view kDirectionsDisagree =
    "Clockwise and counter-clockwise squares do not want the same wheels. Check that x is along "
    "the first side and y to its left, that all ends are measured from the same mark, and that "
    "each is with its run.";

// Of a direction in which squares were driven, but not enough of them have their ends.
std::vector<std::size_t> runsThatWait(const UmbmarkCalibration& umbmark) {
    std::vector<std::size_t> numbers;
    for (const SquareRun& run : umbmark.drives.runs) {
        const bool measured = std::ranges::find(umbmark.squares, run.number,
                                                &UmbmarkSquare::number) != umbmark.squares.end();
        if (!measured && countOf(umbmark, run.turning) < kFewestEachWay)
            numbers.push_back(run.number);
    }
    return numbers;
}

std::string complaintAboutCounts(const UmbmarkCalibration& umbmark) {
    const SquareRuns& drives = umbmark.drives;
    if (!drives.wheels_told_apart) {
        return "Squares need encoders that tell the left wheel from the right one.";
    }
    if (drives.runs.empty() && drives.left_out.empty()) {
        return drives.moves == 0
                   ? "No square has been driven yet."
                   : "It moved, but drove no square. Drive each square in one go, and stand for "
                     "less than 2 s at its corners.";
    }
    if (drives.runs.empty()) {
        return "No drive is a square. " + sentenceOf(drives.left_out.front());
    }
    if (umbmark.squares.empty()) return "Where the squares ended has to be measured and entered.";
    const std::size_t clockwise = countOf(umbmark, Turning::kClockwise);
    const std::size_t counter_clockwise = countOf(umbmark, Turning::kCounterClockwise);
    if (std::min(clockwise, counter_clockwise) >= kFewestEachWay) return {};
    if (const auto waiting = runsThatWait(umbmark); !waiting.empty()) {
        return "Two squares each way are the least. Enter where " + runsText(waiting) + " ended.";
    }
    if (clockwise == 0 || counter_clockwise == 0) {
        const bool none_clockwise = clockwise == 0;
        return "All squares were driven " +
               std::string(
                   nameOf(none_clockwise ? Turning::kCounterClockwise : Turning::kClockwise)) +
               ". Drive as many the other way round, or a wrong wheelbase and unequal wheels can "
               "hide each other.";
    }
    return "Two squares each way are the least; " + std::to_string(clockwise) + " clockwise and " +
           std::to_string(counter_clockwise) + " counter-clockwise can be used so far.";
}

// Whoever types the same for all has not measured; a robot that was put back on its mark every time
// has ended there.
std::string complaintAboutEnds(const std::vector<MeasuredSquare>& squares) {
    for (const Turning turning : {Turning::kClockwise, Turning::kCounterClockwise}) {
        const MeasuredSquare* first = nullptr;
        bool all_equal = true;
        for (const MeasuredSquare& square : squares) {
            if (square.run->turning != turning) continue;
            if (!first) first = &square;
            all_equal &= square.end.way == first->end.way;
        }
        if (first && all_equal && first->end.way.length() > 0.0) {
            return "All " + std::string(nameOf(turning)) +
                   " squares have the same end: measure each to the millimetre.";
        }
    }
    return {};
}

void noteSquares(UmbmarkCalibration& umbmark, const std::vector<MeasuredSquare>& squares,
                 const Vehicle& believed) {
    double sides_m = 0.0;
    for (const MeasuredSquare& square : squares) {
        const Vector<Robot> before =
            endEquation(square, believed.geometry, UmbmarkRatios::Ones()).way();
        umbmark.squares.push_back({square.run->number, square.run->turning, before, before});
        sides_m += square.run->side_m;
    }
    if (!squares.empty()) umbmark.side_m = sides_m / static_cast<double>(squares.size());
}

void markFarOff(UmbmarkCalibration& umbmark, const std::vector<FarEnd>& far) {
    for (const FarEnd& end : far) {
        std::ranges::find(umbmark.squares, end.run->number, &UmbmarkSquare::number)->far_off_m =
            end.distance_m;
        umbmark.calibration.remarks.push_back("Run " + std::to_string(end.run->number) + " (" +
                                              std::string(nameOf(end.run->turning)) + ") ended " +
                                              readLength(end.distance_m) +
                                              " away from the others. It was left out.");
    }
}

double rmsError_m(const UmbmarkSolution& solution) {
    double squares_m2 = 0.0;
    for (const EndEquation& equation : solution.equations) {
        squares_m2 +=
            equation.error_m.squaredNorm() / static_cast<double>(solution.equations.size());
    }
    return std::sqrt(squares_m2);
}

// The wider of the two where the directions want different wheels.
void estimate(UmbmarkCalibration& umbmark, const NearEnds& near) {
    umbmark.ratios = estimatesOf(near.solution, near.squares);
    umbmark.metres_per_ratio = metresPerRatio(near.solution.equations);
    const DirectionsAgree directions = directionsAgree(near.solution, near.squares);
    umbmark.directions_agree = directions.chance > kChanceOfDirections ||
                               directions.variance_m2 < kReadingOfTape_m * kReadingOfTape_m;
    if (!umbmark.directions_agree) umbmark.ratios = estimatesOf(near.solution, directions);
}

// Every square is judged with wheels found without it.
Proof holdOut(UmbmarkCalibration& umbmark, const NearEnds& near, const Vehicle& believed) {
    const std::vector<UmbmarkRatios> ratios = ratiosWithoutEach(near.solution);
    std::vector<HeldOutError> errors;
    for (std::size_t i = 0; i < near.squares.size(); ++i) {
        const auto square =
            std::ranges::find(umbmark.squares, near.squares[i].run->number, &UmbmarkSquare::number);
        square->after = endEquation(near.squares[i], believed.geometry, ratios[i]).way();
        errors.push_back({square->before.length(), square->after.length()});
    }
    umbmark.largest_before_m = largestSystematicError_m(umbmark, &UmbmarkSquare::before);
    umbmark.largest_after_m = largestSystematicError_m(umbmark, &UmbmarkSquare::after);
    return proofOf(errors, "return position error", "m");
}

void addClosedForm(UmbmarkCalibration& umbmark, const Vehicle& believed) {
    UmbmarkReturns returns;
    for (const UmbmarkSquare& square : umbmark.squares) {
        if (square.far_off_m) continue;
        auto& way =
            square.turning == Turning::kClockwise ? returns.clockwise : returns.counter_clockwise;
        way.push_back(square.before);
    }
    const auto fit = fitUmbmark(returns, umbmark.side_m, believed.geometry);
    if (fit) umbmark.closed_form = *fit;
}

std::vector<FoundParameter> foundIn(const UmbmarkCalibration& umbmark, const Vehicle& believed) {
    const VehicleGeometry& was = believed.geometry;
    const Estimate& diameter = umbmark.ratios.diameter_ratio;
    const Estimate& wheelbase = umbmark.ratios.wheelbase_ratio;
    const VehicleGeometry now = correctedGeometry(was, diameter.value, wheelbase.value);
    // Both diameters change by as much, one up and one down, since their mean stays.
    const double sum_m = now.left_wheel_diameter_m + now.right_wheel_diameter_m;
    const double diameter_error_m = now.left_wheel_diameter_m * now.right_wheel_diameter_m / sum_m *
                                    diameter.standard_error / diameter.value;
    const auto found = [](std::string_view key, double was_m, double now_m, double error_m,
                          const Estimate& of) {
        return FoundParameter{key, was_m, {now_m, error_m, of.degrees_of_freedom}};
    };
    return {found("wheelbase_m", was.wheelbase_m, now.wheelbase_m,
                  was.wheelbase_m * wheelbase.standard_error, wheelbase),
            found("left_wheel_diameter_m", was.left_wheel_diameter_m, now.left_wheel_diameter_m,
                  diameter_error_m, diameter),
            found("right_wheel_diameter_m", was.right_wheel_diameter_m, now.right_wheel_diameter_m,
                  diameter_error_m, diameter)};
}

// Whether the new wheels are nearer to the truth than the old ones, not only different: the truth
// must be on their side of the middle between the two. In metres at the end of a square.
bool isSurelyNearer(const UmbmarkCalibration& umbmark) {
    const Eigen::Vector2d& m = umbmark.metres_per_ratio;
    const Estimate& diameter = umbmark.ratios.diameter_ratio;
    const Estimate& wheelbase = umbmark.ratios.wheelbase_ratio;
    const double change_m =
        std::hypot(m.x() * (diameter.value - 1.0), m.y() * (wheelbase.value - 1.0));
    const double margin_m =
        std::hypot(m.x() * diameter.margin(kSureOfNearer), m.y() * wheelbase.margin(kSureOfNearer));
    return 0.5 * change_m > margin_m;
}

// The one direction then ended as it did and the other one beside it, which wheels do as well:
// where both errors of theirs make up for each other in one direction.
bool markMayHaveMoved(const UmbmarkCalibration& umbmark) {
    int changes = 0;
    const UmbmarkSquare* last = nullptr;
    for (const UmbmarkSquare& square : umbmark.squares) {
        if (square.far_off_m) continue;
        if (last && last->turning != square.turning) ++changes;
        last = &square;
    }
    return changes < 2;
}

std::string oneMoreSquare(Turning first) {
    const std::string name(nameOf(first));
    return "All " + name +
           " squares came first, and a mark that was moved after them looks like other wheels. "
           "Drive one more " +
           name + " square.";
}

Calibration withVerdict(const UmbmarkCalibration& umbmark) {
    Calibration calibration = judged(umbmark.calibration);
    const bool accepted = calibration.verdict == Verdict::kAccepted && isSurelyNearer(umbmark);
    if (!accepted && !umbmark.directions_agree) {
        return refused(std::move(calibration), std::string(kDirectionsDisagree));
    }
    if (accepted && markMayHaveMoved(umbmark)) {
        calibration.verdict = Verdict::kNotProven;
        calibration.reason = oneMoreSquare(umbmark.squares.front().turning);
        return calibration;
    }
    if (accepted || calibration.verdict != Verdict::kAccepted) return calibration;
    calibration.verdict = Verdict::kUnchanged;
    calibration.reason = "The old values are as good as these squares can tell.";
    return calibration;
}

void calibrate(UmbmarkCalibration& umbmark, const std::vector<MeasuredSquare>& squares,
               const Vehicle& believed) {
    const NearEnds near = withoutFarEnds(squares, believed.geometry);
    markFarOff(umbmark, near.far);
    Calibration& calibration = umbmark.calibration;
    const double rms_m = rmsError_m(near.solution);
    if (rms_m > kWorstFitOfASide * umbmark.side_m) {
        calibration =
            refused(std::move(calibration),
                    "Whatever the wheels, ends are off by " + readLength(rms_m) +
                        ". Check that they are in metres, x along the first side and y to its "
                        "left, and that each is with its run.");
        return;
    }
    estimate(umbmark, near);
    calibration.proof = holdOut(umbmark, near, believed);
    calibration.found = foundIn(umbmark, believed);
    addClosedForm(umbmark, believed);
    addUmbmarkFigures(umbmark);
    calibration = withVerdict(umbmark);
    if (!umbmark.directions_agree && calibration.verdict == Verdict::kAccepted) {
        calibration.remarks.emplace_back(kDirectionsDisagree);
    }
}

}  // namespace

UmbmarkCalibration calibrateUmbmark(std::span<const SampleSet> sets,
                                    std::span<const UmbmarkEnd> ends, const Vehicle& believed) {
    UmbmarkCalibration umbmark{.drives = squareRunsOf(sets, believed)};
    umbmark.calibration.procedure = "umbmark";
    const PairedEnds paired = pairedEnds(umbmark.drives, ends, believed.geometry);
    umbmark.calibration.remarks = paired.remarks;
    noteSquares(umbmark, paired.squares, believed);
    std::string complaint = complaintAboutCounts(umbmark);
    if (complaint.empty()) complaint = complaintAboutEnds(paired.squares);
    if (complaint.empty()) {
        calibrate(umbmark, paired.squares, believed);
    } else {
        umbmark.calibration = refused(std::move(umbmark.calibration), complaint);
    }
    addUmbmarkSteps(umbmark);
    addUmbmarkPlot(umbmark);
    return umbmark;
}

}  // namespace hedr
