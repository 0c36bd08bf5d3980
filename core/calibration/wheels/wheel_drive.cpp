#include "core/calibration/wheels/wheel_drive.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/calibration/short_number.h"
#include "core/calibration/wheels/turn_widths.h"
#include "core/calibration/wheels/wheel_drive_evidence.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr double kMostBrokenDriveShare = 0.1;
constexpr double kFewestWheelbases = 15.0;  // of way: shorter drives tell nothing
constexpr double kLeastTurning_rad = 2.0 * kPi;
constexpr double kMostUnlike = 0.2;
constexpr double kMostTurnSlip = 0.5;  // the wheels do not turn as the gyro does at all

// Of the readings as such; empty: none.
std::string complaintAbout(const DriveReadings& drives) {
    if (!drives.has_encoders) return "No encoder counts came. Check that the robot sends them.";
    if (!drives.has_gyro) {
        return "No gyro readings came. Without a gyro, drive back to the start each time and say "
               "that the drives are closed, or drive squares.";
    }
    if (!drives.has_sides) return "The encoders do not tell the left side from the right one.";
    if (static_cast<double>(drives.broken) >
        kMostBrokenDriveShare * static_cast<double>(drives.readings)) {
        return std::to_string(drives.broken) + " of " + std::to_string(drives.readings) +
               " readings are no numbers, have no time or are impossible. Check the sensors and "
               "their wiring.";
    }
    if (drives.beyond_range)
        return "The gyro was at the end of its range while it turned. Turn slower.";
    return {};
}

// Of the drives; empty: none.
std::string complaintAbout(const DriveReadings& drives, const DriveFit& fit,
                           const VehicleGeometry& believed) {
    if (drives.rolled_m < kFewestWheelbases * believed.wheelbase_m) {
        return "It was driven by " + shortNumber(drives.rolled_m) +
               " m only. Drive it about as usual, for some minutes.";
    }
    if (drives.left_rad + drives.right_rad < kLeastTurning_rad || fit.parts == 0) {
        return "It has hardly turned. Drive some corners, as many left as right.";
    }
    if (!(fit.wheelbase_m.value > 0.0)) {
        return "By the wheels it turns the other way round than by the gyro. Run the encoder check "
               "first.";
    }
    if (fit.turn_slip_share > kMostTurnSlip) {
        return "The wheels do not turn it as the gyro says. Run the encoder check first.";
    }
    if (std::abs(fit.right_larger.value) > kMostUnlike) {
        return "One wheel counts " + percentText(std::abs(fit.right_larger.value)) +
               " more way than the other one. Run the encoder check first.";
    }
    return {};
}

Estimate diameterFrom(const Estimate& estimate, double factor, double offset) {
    return {offset + factor * estimate.value, std::abs(factor) * estimate.standard_error,
            estimate.degrees_of_freedom};
}

std::vector<FoundParameter> foundIn(const DriveFit& fit, const VehicleGeometry& was) {
    const double left_m = was.left_wheel_diameter_m;
    const double right_m = was.right_wheel_diameter_m;
    const bool alike = !fit.right_larger_changes;
    return {{"wheelbase_m", was.wheelbase_m, fit.wheelbase_m, !fit.wheelbase_changes},
            {"left_wheel_diameter_m", left_m, diameterFrom(fit.right_larger, -0.5 * left_m, left_m),
             alike},
            {"right_wheel_diameter_m", right_m,
             diameterFrom(fit.right_larger, 0.5 * right_m, right_m), alike}};
}

// The scale of a gyro that was never calibrated is exactly one in the vehicle file.
double unsureShare(const Vehicle& believed, const WheelDriveOptions& options) {
    return believed.gyro_scale == 1.0 ? options.unsure_gyro_scale : 0.0;
}

// What cannot be proven is not as good as the old.
Calibration judgedWithGyro(const WheelDrive& wheels) {
    Calibration calibration = judged(wheels.calibration);
    const bool open =
        calibration.verdict == Verdict::kUnchanged || calibration.verdict == Verdict::kNotProven;
    if (open && wheels.fit.gyro_scale_may_explain) {
        calibration.verdict = Verdict::kNotProven;
        calibration.reason =
            "The wheelbase is another one, or the scale of the gyro, which was "
            "never calibrated, is. Calibrate that first.";
    }
    return calibration;
}

}  // namespace

WheelDrive calibrateByDriving(std::span<const SampleSet> sets, const Vehicle& believed,
                              const WheelDriveOptions& options) {
    WheelDrive wheels;
    wheels.calibration.procedure = "wheels";
    wheels.drives = readDrives(sets, believed);
    const VehicleGeometry& geometry = believed.geometry;
    const double unsure_share = unsureShare(believed, options);
    wheels.fit = fitDrive(wheels.drives.logs, {geometry.wheelbase_m, unsure_share});
    wheels.calibration.track_widths = trackWidths(wheels.drives.logs, wheels.fit);
    if (wheels.fit.parts > 0) wheels.calibration.found = foundIn(wheels.fit, geometry);
    addEvidence(wheels, geometry, unsure_share, options);
    for (std::string complaint :
         {complaintAbout(wheels.drives), complaintAbout(wheels.drives, wheels.fit, geometry)}) {
        if (complaint.empty()) continue;
        wheels.calibration = refused(std::move(wheels.calibration), std::move(complaint));
        return wheels;
    }
    wheels.calibration.proof = proofOf(
        wheels.fit.held_out, "heading that the wheels miss in each part of the drive", "rad");
    wheels.calibration = judgedWithGyro(wheels);
    return wheels;
}

}  // namespace hedr
