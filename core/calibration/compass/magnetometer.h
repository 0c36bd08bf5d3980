#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/calibration/calibration.h"
#include "core/calibration/compass/ellipse_fit.h"
#include "core/calibration/compass/ellipsoid_fit.h"
#include "core/calibration/compass/field_disturbance.h"
#include "core/calibration/compass/field_quality.h"
#include "core/calibration/compass/magnetic_log.h"
#include "core/calibration/compass/magnetic_turns.h"
#include "core/calibration/sample_set.h"
#include "core/robot/vehicle.h"

namespace hedr {

// What turning on the spot tells of a magnetometer.
struct MagnetometerTurns {
    MagneticTurns turns{};
    MagneticTurns counted{};          // without the readings that are outliers of the fit
    std::optional<EllipseFit> fit{};  // none: the readings are no ellipse
    MagnetometerRange range{};        // of the fit, with the signs of the mounting
    FieldQuality quality{};
    FieldDisturbance disturbance{};
    double expected_error_rad = 0.0;  // rms heading error over the circle by the errors of the fit
    double difference_rad = 0.0;      // rms heading over the circle, old range less new one
    std::vector<HeldOutError> held_out{};
};

struct MagnetometerCalibration {
    std::optional<MagnetometerTurns> level{};  // none: no turning that could be used
    std::optional<EllipsoidFit> sphere{};      // of a sensor that was turned through all directions
    Calibration calibration{};
};

// Hard and soft iron of a magnetometer, "mag_centre_x" … "mag_correlation" of the vehicle file,
// from turns on the spot, two or more, best both ways; or its ellipsoid, as evidence only, from
// being turned through all directions. Gyro or encoders judge the heading and tell which way the
// axes are mounted; without them the steadiness of the field's strength is the proof, and only a
// change of the heading of more than 8° can be accepted, and only of a file that has these numbers,
// as it alone says then which way the axes are mounted.
// Refused, with the reason, are no, few, broken, equal or saturated readings, less than a full
// turn, more than the gates of FieldQuality allow, and surroundings that are not the same field.
MagnetometerCalibration calibrateMagnetometer(std::span<const SampleSet> sets,
                                              const Vehicle& believed);

// The middle of the least and the largest readings, and half their difference: the calibration of
// the GH paper (2019, section VI-D), for comparison. The readings are not none.
MagnetometerRange leastAndMost(std::span<const Eigen::Vector2d> field);

}  // namespace hedr
