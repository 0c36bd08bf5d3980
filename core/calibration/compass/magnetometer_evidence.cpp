#include "core/calibration/compass/magnetometer_evidence.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/calibration/compass/compass_errors.h"
#include "core/calibration/compass/magnetometer_plots.h"
#include "core/calibration/compass/magnetometer_readings.h"
#include "core/calibration/short_number.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr double kTurnsEachWayWanted = 2.0;
constexpr double kAlmost = 0.97;                      // nobody stops at the degree
constexpr double kWantedError_rad = radFromDeg(0.5);  // rms heading over the circle
constexpr double kInPercent = 100.0;

double turnsOf(double angle_rad) { return angle_rad / (2.0 * kPi); }

bool hasTurnedEnough(const MagnetometerCalibration& result, int way) {
    return result.level &&
           turnsOf(result.level->turns.turned_rad(way)) >= kAlmost * kTurnsEachWayWanted;
}

std::vector<CalibrationStep> magnetometerSteps(const MagnetometerCalibration& result,
                                               std::span<const MagneticLog> logs) {
    const bool hears = std::any_of(logs.begin(), logs.end(),
                                   [](const MagneticLog& log) { return !log.samples.empty(); });
    return {{"Put it on level ground", "Away from iron, electric lines and other robots.", hears},
            {"Turn on the spot, counter-clockwise", "By two whole turns, slowly and steadily.",
             hasTurnedEnough(result, 1)},
            {"Turn clockwise", "By two whole turns, slowly and steadily.",
             hasTurnedEnough(result, -1)}};
}

CalibrationProgress progressOfTurns(const MagnetometerTurns& level) {
    const double turned = turnsOf(level.turns.turned_rad());
    const double share = std::min(1.0, turned / (2.0 * kTurnsEachWayWanted));
    if (!level.fit || level.quality.gaps > FieldQuality::kMostGaps)
        return {.share = 0.5 * share, .more = "A whole turn is missing"};
    const double known_rad = level.expected_error_rad;
    const double exact = std::pow(kWantedError_rad / std::max(known_rad, kWantedError_rad), 2);
    CalibrationProgress progress{
        .share = std::min(share, exact),
        .known = "Heading known to ±" + wholeDegreesText(2.0 * known_rad) + " by the ellipse"};
    if (share < kAlmost) {
        progress.more = "About " + shortNumber(2.0 * kTurnsEachWayWanted - turned) +
                        " turns more, best the other way";
    } else if (exact < 1.0) {
        progress.more = "About " + shortNumber(std::ceil(turned / exact - turned)) +
                        " turns more give ±" + wholeDegreesText(2.0 * kWantedError_rad);
    }
    return progress;
}

void addGates(std::vector<EvidenceFigure>& figures, const FieldQuality& quality) {
    const auto add = [&figures](const char* name, double share, double most) {
        figures.push_back(
            {std::string(name) + " (at most " + shortNumber(kInPercent * most) + " %)",
             kInPercent * share, "%"});
    };
    add("Gaps", quality.gaps, FieldQuality::kMostGaps);
    add("Variance of the strength", quality.variance, FieldQuality::kMostVariance);
    if (quality.wobble) add("Wobble", *quality.wobble, FieldQuality::kMostWobble);
    add("Fit error", quality.fit_error, FieldQuality::kMostFitError);
    add("Readings left out", quality.outliers, FieldQuality::kMostOutliers);
}

void addLeastAndMost(std::vector<EvidenceFigure>& figures, const MagnetometerTurns& level) {
    const MagnetometerRange simple =
        withSignsOf(leastAndMost(level.turns.readings().field), level.range);
    figures.push_back({"Centre x by least and most", simple.centre_x});
    figures.push_back({"Centre y by least and most", simple.centre_y});
    figures.push_back({"Range x by least and most", simple.range_x});
    figures.push_back({"Range y by least and most", simple.range_y});
    if (level.turns.judge != HeadingJudge::kNone) {
        figures.push_back({"Heading error by least and most",
                           rmsOf(headingErrors_rad(level.counted, simple, level.range)), "rad"});
    }
    figures.push_back({"Spread of the strength by least and most",
                       kInPercent * rmsOf(strengthErrors(level.counted, simple)), "%"});
}

std::vector<EvidenceFigure> figuresOfTurns(const MagnetometerTurns& level,
                                           const MagnetometerRange& believed) {
    std::vector<EvidenceFigure> figures{
        {"Turned counter-clockwise", level.turns.turned_rad(1), "rad"},
        {"Turned clockwise", level.turns.turned_rad(-1), "rad"}};
    if (!level.fit) return figures;
    addGates(figures, level.quality);
    figures.push_back(
        {"Field turns differ from one another", kInPercent * level.disturbance.turns.size, "%"});
    if (level.turns.judge != HeadingJudge::kNone) {
        figures.push_back({"Heading error before",
                           rmsOf(headingErrors_rad(level.counted, believed, level.range)), "rad"});
        figures.push_back({"Heading error after",
                           rmsOf(headingErrors_rad(level.counted, level.range, level.range)),
                           "rad"});
    }
    figures.push_back({"Spread of the strength before",
                       kInPercent * rmsOf(strengthErrors(level.counted, believed)), "%"});
    figures.push_back({"Spread of the strength after",
                       kInPercent * rmsOf(strengthErrors(level.counted, level.range)), "%"});
    figures.push_back({"Compass before less after", level.difference_rad, "rad"});
    addLeastAndMost(figures, level);
    return figures;
}

std::vector<EvidenceFigure> figuresOfSphere(const EllipsoidFit& fit) {
    std::vector<EvidenceFigure> figures;
    const char* const centres[] = {"Hard iron x", "Hard iron y", "Hard iron z"};
    for (std::size_t axis = 0; axis < fit.centre.size(); ++axis) {
        figures.push_back({centres[axis], fit.centre[axis].value, "", fit.centre[axis].interval()});
    }
    const Eigen::Matrix3d& iron = fit.ellipsoid.iron;
    figures.push_back({"A xx of A (raw - b)", iron(0, 0)});
    figures.push_back({"A yy", iron(1, 1)});
    figures.push_back({"A zz", iron(2, 2)});
    figures.push_back({"A xy", iron(0, 1)});
    figures.push_back({"A xz", iron(0, 2)});
    figures.push_back({"A yz", iron(1, 2)});
    figures.push_back({"Strength of the field", fit.ellipsoid.strength});
    addGates(figures, fieldQualityOf(fit));
    return figures;
}

std::vector<std::string> remarksOnTurns(const MagnetometerTurns& level,
                                        const MagnetometerRange& believed) {
    std::vector<std::string> remarks;
    const MagneticTurns& turns = level.turns;
    if (turns.samples.empty()) return remarks;
    if (turns.judge == HeadingJudge::kNone) {
        remarks.emplace_back(
            "Neither gyro nor encoders tell the heading: the proof is that the field's strength is "
            "steady, and which way the axes are mounted is taken from the vehicle file.");
    }
    if (turns.turned_rad(1) == 0.0 || turns.turned_rad(-1) == 0.0) {
        remarks.emplace_back("It turned one way only; the other way too tells more.");
    }
    if (!level.fit) return remarks;
    const bool was_mirrored = believed.range_x * believed.range_y < 0.0;
    const bool is_mirrored = level.range.range_x * level.range.range_y < 0.0;
    if (was_mirrored != is_mirrored) {
        remarks.emplace_back("One axis is mounted the other way than was thought.");
    }
    if (level.quality.outliers > 0.0) {
        remarks.push_back(shortNumber(kInPercent * level.quality.outliers) +
                          " % of the readings are far from the ellipse and were left out.");
    }
    return remarks;
}

}  // namespace

void addEvidence(MagnetometerCalibration& result, std::span<const MagneticLog> logs,
                 const Vehicle& believed) {
    Calibration& calibration = result.calibration;
    calibration.steps = magnetometerSteps(result, logs);
    calibration.progress.more = "It has to turn first";
    const MagnetometerRange old = believed.magnetometer.value_or(MagnetometerRange{});
    if (result.level) {
        calibration.progress = progressOfTurns(*result.level);
        calibration.figures = figuresOfTurns(*result.level, old);
        calibration.remarks = remarksOnTurns(*result.level, old);
        calibration.plots = plotsOfTurns(*result.level, old);
    }
    if (result.sphere) {
        calibration.figures = figuresOfSphere(*result.sphere);
        calibration.plots = plotsOfSphere(*result.sphere, allFieldsOf(logs));
    }
}

}  // namespace hedr
