#include "core/calibration/wheels/wheel_drive_evidence.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/calibration/short_number.h"
#include "core/calibration/wheels/turn_widths.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr double kEnoughStanding_s = 5.0;
constexpr double kEnoughWay_m = 100.0;
constexpr double kEnoughTurning_rad = 4.0 * kPi;  // each way
constexpr double kOneSided = 3.0;                 // times more one way than the other

std::vector<CalibrationStep> stepsOf(const DriveReadings& drives) {
    const double fewer_rad = std::min(drives.left_rad, drives.right_rad);
    return {{"Let it stand", "For 5 s at the start, and now and then on the way.",
             drives.stood_s >= kEnoughStanding_s},
            {"Drive as usual", "By 100 m of corridors or more, at the usual speed.",
             drives.straight_m >= kEnoughWay_m},
            {"Turn both ways", "Eight corners left and eight right, as they come.",
             fewer_rad >= kEnoughTurning_rad}};
}

// Of what is wanted to know of one value, how much is known: information goes with 1/error².
double knownShare(const Estimate& estimate, double wanted) {
    const double ratio = wanted / estimate.standard_error;
    return ratio < 1.0 ? ratio * ratio : 1.0;
}

CalibrationProgress progressOf(const WheelDrive& wheels, const WheelDriveOptions& options) {
    const DriveFit& fit = wheels.fit;
    if (fit.parts == 0) return {.more = "It has to drive and turn first"};
    const double known = std::min(knownShare(fit.wheelbase_m, options.wanted_wheelbase_share *
                                                                  std::abs(fit.wheelbase_m.value)),
                                  knownShare(fit.right_larger, options.wanted_right_larger));
    CalibrationProgress progress{
        .share = known,
        .known = "Wheelbase known to ±" +
                 percentText(fit.wheelbase_m.margin() / std::abs(fit.wheelbase_m.value)) +
                 ", the wheels' ratio to ±" + percentText(fit.right_larger.margin())};
    if (known < 1.0) {
        const double more_s = (1.0 / known - 1.0) * wheels.drives.moved_s;
        constexpr double kMinute_s = 60.0;
        progress.more = "About " + shortNumber(std::ceil(more_s / kMinute_s)) +
                        " min more of driving would be enough";
    }
    return progress;
}

std::size_t slippedPieces(const DriveFit& fit) {
    return static_cast<std::size_t>(std::count(fit.weights.begin(), fit.weights.end(), 0.0));
}

std::vector<EvidenceFigure> figuresOf(const WheelDrive& wheels) {
    std::vector<EvidenceFigure> figures{
        {"Driven", wheels.drives.rolled_m, "m"},
        {"Turned left", wheels.drives.left_rad, "rad"},
        {"Turned right", wheels.drives.right_rad, "rad"},
    };
    const DriveFit& fit = wheels.fit;
    if (fit.parts == 0) return figures;
    const Interval ratio = fit.right_larger.interval();
    figures.push_back({"Right over left wheel, against what was believed",
                       1.0 + fit.right_larger.value, "",
                       Interval{1.0 + ratio.low, 1.0 + ratio.high}});
    figures.push_back({"The sides slip against each other, on one metre", fit.slip_m_sqrtm, "m"});
    figures.push_back({"Wheelbase differs from turn to turn, as a share", fit.turn_slip_share});
    figures.push_back(
        {"Pieces left out, as a wheel slipped", static_cast<double>(slippedPieces(fit))});
    return figures;
}

bool dependsOnRate(std::span<const TrackWidth> widths) {
    if (widths.size() < 2) return false;
    const Estimate& slow = widths.front().wheelbase_m;
    const Estimate& fast = widths.back().wheelbase_m;
    const Estimate difference{fast.value - slow.value,
                              std::hypot(fast.standard_error, slow.standard_error),
                              std::min(fast.degrees_of_freedom, slow.degrees_of_freedom)};
    return !difference.interval(0.99).contains(0.0);
}

std::vector<std::string> remarksOn(const WheelDrive& wheels, double unsure_share) {
    std::vector<std::string> remarks;
    const DriveFit& fit = wheels.fit;
    if (fit.parts == 0) return remarks;
    if (fit.gyro_scale_may_explain) {
        remarks.push_back(
            "The wheelbase stays: the scale of a gyro that was never calibrated may "
            "be off by " +
            percentText(unsure_share) + ". Calibrate it first.");
    }
    const auto [fewer_rad, more_rad] = std::minmax(wheels.drives.left_rad, wheels.drives.right_rad);
    if (more_rad > kOneSided * fewer_rad)
        remarks.emplace_back("It turned one way nearly always. Turn the other way too.");
    if (dependsOnRate(wheels.calibration.track_widths)) {
        remarks.push_back(
            "In slow turns the wheelbase is " +
            shortNumber(wheels.calibration.track_widths.front().wheelbase_m.value, 3) +
            " m, in fast ones " +
            shortNumber(wheels.calibration.track_widths.back().wheelbase_m.value, 3) +
            " m: tracks slip more the faster they turn. The value found is for turns "
            "as these were, on this floor.");
    }
    return remarks;
}

EvidencePlot widthPlot(const WheelDrive& wheels) {
    EvidencePlot plot{std::string(kTrackWidthPlot), {"Rate of turn", "rad/s"}, {"Wheelbase", "m"}};
    EvidenceSeries turns{"One turn", EvidenceSeries::Shape::kDots};
    for (const TurnWidth& turn : turnWidths(wheels.drives.logs, wheels.fit)) {
        turns.x.push_back(turn.rate_rad_s);
        turns.y.push_back(turn.wheelbase_m);
    }
    EvidenceSeries band{"Mean of turns alike, 95 %", EvidenceSeries::Shape::kBand};
    for (const TrackWidth& width : wheels.calibration.track_widths) {
        const Interval interval = width.wheelbase_m.interval();
        band.x.push_back(width.rate_rad_s);
        band.y.push_back(interval.low);
        band.y_high.push_back(interval.high);
    }
    plot.series = {std::move(band), std::move(turns)};
    return plot;
}

// What the wheels' heading gains on the gyro's along the way, turns left out.
EvidencePlot driftPlot(const WheelDrive& wheels, const VehicleGeometry& believed) {
    EvidencePlot plot{"Drift going straight", {"Way", "m"}, {"Wheels less gyro", "rad"}};
    EvidenceSeries before{"Old wheels", EvidenceSeries::Shape::kDashes};
    EvidenceSeries after{"New wheels", EvidenceSeries::Shape::kLine};
    const DriveFit& fit = wheels.fit;
    double way_m = 0.0, old_rad = 0.0, new_rad = 0.0;
    std::size_t piece = 0;
    for (const DriveLog& log : wheels.drives.logs) {
        for (const DrivePiece& each : log.pieces) {
            const std::size_t at = piece++;
            if (each.kind != DriveKind::kStraight || fit.weights[at] == 0.0) continue;
            way_m += each.rolled_m;
            old_rad += each.difference_m / believed.wheelbase_m - fit.turned_rad[at];
            new_rad +=
                (each.difference_m + fit.right_larger.value * each.way_m) / fit.wheelbase_m.value -
                fit.turned_rad[at];
            before.x.push_back(way_m);
            before.y.push_back(old_rad);
            after.x.push_back(way_m);
            after.y.push_back(new_rad);
        }
    }
    plot.series = {std::move(before), std::move(after)};
    return plot;
}

}  // namespace

void addEvidence(WheelDrive& wheels, const VehicleGeometry& believed, double unsure_share,
                 const WheelDriveOptions& options) {
    Calibration& calibration = wheels.calibration;
    calibration.steps = stepsOf(wheels.drives);
    calibration.progress = progressOf(wheels, options);
    calibration.figures = figuresOf(wheels);
    calibration.remarks = remarksOn(wheels, unsure_share);
    if (wheels.fit.parts > 0) calibration.plots = {widthPlot(wheels), driftPlot(wheels, believed)};
}

}  // namespace hedr
