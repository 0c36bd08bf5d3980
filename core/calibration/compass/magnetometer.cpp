#include "core/calibration/compass/magnetometer.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/calibration/compass/compass_errors.h"
#include "core/calibration/compass/magnetometer_evidence.h"
#include "core/calibration/compass/magnetometer_readings.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr double kRoundSphere = 0.3;  // a plane has less
constexpr double kSureErrors = 2.5;   // standard deviations of the heading error that is expected
// What bends a field without showing, rms heading: without a judge it may be much.
constexpr double kUnseenByJudge_rad = radFromDeg(0.3);
constexpr double kUnseenByField_rad = radFromDeg(4.0);

bool isMirrored(const MagnetometerRange& range) { return range.range_x * range.range_y < 0.0; }

MagnetometerRange believedRange(const Vehicle& vehicle) {
    return vehicle.magnetometer.value_or(MagnetometerRange{});
}

// Whether the field goes round the other way than it does on a sensor that is mounted x ahead and
// y left; as believed where no judge tells.
bool isMountedMirrored(const MagneticTurns& turns, const Ellipse& ellipse, bool believed) {
    if (turns.judge == HeadingJudge::kNone) return believed;
    double together = 0.0;
    for (const MagneticStretch& stretch : turns.stretches) {
        for (std::size_t i = stretch.first + 1; i < stretch.last; ++i) {
            const double before_rad = ellipse.angleOf(turns.samples[i - 1].field.head<2>());
            const double now_rad = ellipse.angleOf(turns.samples[i].field.head<2>());
            together += wrapAngle(now_rad - before_rad) * stretch.turned_rad;
        }
    }
    return together > 0.0;
}

// Both ranges mirrored are half a turn of the compass, which the start of a track takes off: only
// where the sense is another one, y changes.
MagnetometerRange signsOf(const MagnetometerRange& believed, bool mirrored) {
    MagnetometerRange signs = believed;
    if (isMirrored(believed) != mirrored) signs.range_y = -signs.range_y;
    return signs;
}

MagnetometerTurns lookAtTurns(MagneticTurns turns, const Vehicle& believed) {
    MagnetometerTurns level{.turns = std::move(turns)};
    if (level.turns.samples.empty()) return level;
    level.fit = fitEllipse(level.turns.readings());
    if (!level.fit) return level;
    level.counted = withoutOutliers(level.turns, level.fit->weight);
    const MagnetometerRange old = believedRange(believed);
    const bool mirrored = isMountedMirrored(level.turns, level.fit->ellipse, isMirrored(old));
    const MagnetometerRange signs = signsOf(old, mirrored);
    level.range = withSignsOf(rangeOf(level.fit->ellipse), signs);
    level.quality = fieldQualityOf(level.turns, *level.fit);
    level.disturbance = disturbanceIn(level.turns, *level.fit, level.range);
    level.expected_error_rad = expectedHeadingError_rad(*level.fit);
    level.difference_rad = headingErrorOverCircle_rad(old, level.range);
    level.held_out = compassHeldOut(level.counted, level.fit->ellipse, old, signs);
    return level;
}

std::vector<FoundParameter> foundNumbers(const MagnetometerTurns& level, const Vehicle& believed) {
    constexpr std::array<std::string_view, 5> kKeys{"mag_centre_x", "mag_centre_y", "mag_range_x",
                                                    "mag_range_y", "mag_correlation"};
    const double values[] = {level.range.centre_x, level.range.centre_y, level.range.range_x,
                             level.range.range_y, level.range.correlation};
    std::vector<FoundParameter> found;
    found.reserve(kKeys.size());
    for (std::size_t i = 0; i < kKeys.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        found.push_back({kKeys[i], vehicleNumber(believed, kKeys[i]),
                         Estimate{values[i], std::sqrt(level.fit->covariance(row, row)),
                                  level.fit->degrees_of_freedom}});
    }
    return found;
}

// Of the turns; empty: none.
std::string complaintAboutTurns(const MagnetometerTurns& level) {
    const double turned_rad = level.turns.turned_rad();
    if (turned_rad == 0.0) {
        return "It has not turned on the spot. Turn it by two whole turns, then back by two.";
    }
    if (turned_rad < 2.0 * kPi) {
        return "It turned by " + wholeDegreesText(turned_rad) +
               " only. Turn it on the spot by two whole turns or more.";
    }
    std::string saturated = complaintAboutSaturation(level.turns);
    if (!saturated.empty()) return saturated;
    if (!level.fit) {
        return "The field does not go round as the robot turns. Move away from iron and electric "
               "lines, and turn again.";
    }
    std::string quality = level.quality.complaint();
    if (!quality.empty()) return quality;
    if (level.disturbance.isDisturbed()) {
        return "The field is not the same in each turn and place. Move away from iron and electric "
               "lines, and turn again.";
    }
    return {};
}

// The new range may itself be off by so much; the old one is surely worse if it differs by twice
// that.
double possibleError_rad(const MagnetometerTurns& level) {
    const double unseen_rad = level.disturbance.heading
                                  ? kUnseenByJudge_rad + level.disturbance.heading->size
                                  : kUnseenByField_rad;
    return kSureErrors * level.expected_error_rad + unseen_rad;
}

Calibration judgedByDifference(const MagnetometerTurns& level, const Vehicle& believed,
                               Calibration calibration) {
    calibration = judged(std::move(calibration));
    if (calibration.verdict != Verdict::kAccepted) return calibration;
    if (level.turns.judge == HeadingJudge::kNone && !believed.magnetometer) {
        calibration.verdict = Verdict::kNotProven;
        calibration.reason =
            "Without gyro and encoders nothing tells which way the axes are mounted. Turn it by "
            "its wheels, or write the mag_ values into the vehicle file, one range negative if "
            "the axes are mirrored.";
        return calibration;
    }
    const double least_rad = 2.0 * possibleError_rad(level);
    if (level.difference_rad < least_rad) {
        calibration.verdict = Verdict::kNotProven;
        calibration.reason = "The compass would change by " +
                             wholeDegreesText(level.difference_rad) + " (rms); less than " +
                             wholeDegreesText(least_rad) + " cannot be proven by these turns.";
    }
    return calibration;
}

Proof proofOfTurns(const MagnetometerTurns& level) {
    if (level.turns.judge == HeadingJudge::kNone)
        return proofOf(level.held_out, "unsteadiness of the field's strength", "");
    return proofOf(level.held_out, "magnetic heading less that of gyro or encoders", "rad");
}

void judgeTurns(MagnetometerCalibration& result, const Vehicle& believed) {
    const MagnetometerTurns& level = *result.level;
    if (level.fit) {
        result.calibration.found = foundNumbers(level, believed);
        result.calibration.proof = proofOfTurns(level);
    }
    std::string complaint = complaintAboutTurns(level);
    result.calibration = complaint.empty()
                             ? judgedByDifference(level, believed, std::move(result.calibration))
                             : refused(std::move(result.calibration), std::move(complaint));
}

void judgeSphere(Calibration& calibration, const EllipsoidFit& sphere) {
    const FieldQuality quality = fieldQualityOf(sphere);
    const std::string complaint = quality.complaint();
    calibration.verdict = Verdict::kNotProven;
    calibration.reason =
        complaint.empty()
            ? "It was turned through all directions, which tells the ellipsoid. For the vehicle "
              "file turn it on the spot, on level ground."
            : complaint;
}

}  // namespace

MagnetometerCalibration calibrateMagnetometer(std::span<const SampleSet> sets,
                                              const Vehicle& believed) {
    MagnetometerCalibration result;
    result.calibration.procedure = "magnetometer";
    std::vector<MagneticLog> logs;
    logs.reserve(sets.size());
    for (const SampleSet& set : sets) logs.push_back(readMagneticLog(set.reports, believed));
    std::string complaint = complaintAboutReadings(logs);
    if (complaint.empty()) {
        const std::vector<Eigen::Vector3d> all = allFieldsOf(logs);
        if (roundness(all) > kRoundSphere) result.sphere = fitEllipsoid(all);
        if (!result.sphere) {
            const int sense = isMirrored(believedRange(believed)) ? -1 : 1;
            result.level = lookAtTurns(
                magneticTurnsIn(logs,
                                {.wheelbase_m = believed.geometry.wheelbase_m, .sense = sense}),
                believed);
        }
    }
    addEvidence(result, logs, believed);
    if (!complaint.empty()) {
        result.calibration = refused(std::move(result.calibration), std::move(complaint));
    } else if (result.sphere) {
        judgeSphere(result.calibration, *result.sphere);
    } else {
        judgeTurns(result, believed);
    }
    return result;
}

MagnetometerRange leastAndMost(std::span<const Eigen::Vector2d> field) {
    Eigen::Vector2d least = field.front();
    Eigen::Vector2d most = field.front();
    for (const Eigen::Vector2d& reading : field) {
        least = least.cwiseMin(reading);
        most = most.cwiseMax(reading);
    }
    const Eigen::Vector2d middle = 0.5 * (least + most);
    const Eigen::Vector2d half = 0.5 * (most - least);
    return {middle.x(), middle.y(), half.x(), half.y()};
}

}  // namespace hedr
