#include "core/calibration/wheels/drive_logs.h"

#include <algorithm>
#include <cmath>

#include "core/calibration/gyro/gyro_range.h"
#include "core/calibration/gyro/gyro_stands.h"
#include "core/calibration/gyro_samples.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr double kUsualBiasWalk_rad_s_sqrts = radFromDeg(0.004);  // of a cheap gyro
constexpr double kLeastBiasWalk_rad_s_sqrts = radFromDeg(0.0001);
constexpr double kUsualBiasSlope_rad_s2 = radFromDeg(0.03) / 60.0;  // it warms up
constexpr double kLeastGyroNoise_rad_s_sqrthz = radFromDeg(0.002);
constexpr double kKnownBias_rad_s = radFromDeg(0.3);  // how far it may be from what stands say
constexpr double kUnknownBias_rad_s = radFromDeg(2.0);
constexpr double kUsualCount_m = 1e-4;

double countOf(std::span<const SensorReport> reports, const Vehicle& vehicle) {
    const bool has_ticks = std::any_of(reports.begin(), reports.end(), [](const auto& report) {
        return std::holds_alternative<WheelTicks>(report.odometry);
    });
    const VehicleGeometry& wheels = vehicle.geometry;
    const double diameter_m = 0.5 * (wheels.left_wheel_diameter_m + wheels.right_wheel_diameter_m);
    return has_ticks ? kPi * diameter_m / wheels.ticks_per_revolution : kUsualCount_m;
}

DriveNoise noiseOf(const GyroStands& standing, const EncoderTravel& travel, const Vehicle& vehicle,
                   std::span<const SensorReport> reports) {
    const double walk_rad_s_sqrts = vehicle.gyro_bias_walk_rad_s_sqrts > 0.0
                                        ? vehicle.gyro_bias_walk_rad_s_sqrts
                                        : kUsualBiasWalk_rad_s_sqrts;
    return {.count_m = countOf(reports, vehicle),
            .gyro_rad_s_sqrthz =
                std::max({vehicle.gyro_scale * standing.noise_rad_s_sqrthz,
                          vehicle.gyro_noise_rad_s_sqrthz, kLeastGyroNoise_rad_s_sqrthz}),
            .rounding_rad_s = vehicle.gyro_scale * standing.rounding_rad_s,
            .bias_rad_s = travel.knows_gyro_bias ? kKnownBias_rad_s : kUnknownBias_rad_s,
            .bias_walk_rad_s_sqrts = std::max(walk_rad_s_sqrts, kLeastBiasWalk_rad_s_sqrts),
            .bias_slope_rad_s2 = kUsualBiasSlope_rad_s2};
}

void sumUp(DriveReadings& drives, std::span<const DrivePiece> pieces) {
    for (const DrivePiece& piece : pieces) {
        const bool stands = piece.kind == DriveKind::kStand;
        (stands ? drives.stood_s : drives.moved_s) += piece.span_s();
        drives.rolled_m += piece.rolled_m;
        if (piece.kind == DriveKind::kStraight) drives.straight_m += piece.rolled_m;
        if (piece.kind != DriveKind::kTurn) continue;
        (piece.gyro_rad > 0.0 ? drives.left_rad : drives.right_rad) += std::abs(piece.gyro_rad);
    }
}

void addDrive(DriveReadings& drives, std::span<const SensorReport> reports,
              const Vehicle& vehicle) {
    const EncoderTravel travel = readEncoderTravel(reports, vehicle);
    drives.readings += travel.moments.size() + travel.broken;
    drives.broken += travel.broken;
    drives.has_encoders |= std::any_of(reports.begin(), reports.end(), [](const auto& report) {
        return !std::holds_alternative<std::monostate>(report.odometry);
    });
    drives.has_sides |= travel.has_sides && travel.moments.size() > 1;
    const auto gyro = gyroSamplesOf(reports);
    drives.has_gyro |= gyro.has_value();
    if (!gyro || travel.moments.size() < 2) return;
    if (!travel.has_sides) return;
    drives.readings += gyro->samples.size() + gyro->broken;
    drives.broken += gyro->broken;
    const auto samples = withoutLoneReadings(gyro->samples);
    const GyroStands standing = standsIn(samples, reports, vehicle);
    drives.beyond_range |= isBeyondRange(samples, standing);
    DriveLog log{piecesOf(travel, vehicle.geometry.wheelbase_m),
                 noiseOf(standing, travel, vehicle, reports)};
    sumUp(drives, log.pieces);
    if (!log.pieces.empty()) drives.logs.push_back(std::move(log));
}

}  // namespace

DriveReadings readDrives(std::span<const SampleSet> sets, const Vehicle& vehicle) {
    DriveReadings drives;
    for (const SampleSet& set : sets) addDrive(drives, set.reports, vehicle);
    return drives;
}

}  // namespace hedr
