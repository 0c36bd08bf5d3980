#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/calibration/calibration.h"
#include "core/calibration/gyro/gyro_turn_fit.h"
#include "core/calibration/gyro/gyro_turns.h"
#include "core/calibration/sample_set.h"
#include "core/geometry/angle.h"
#include "core/robot/vehicle.h"

namespace hedr {

struct GyroScaleOptions {
    std::optional<double> turns{};                  // of each stretch of turning
    bool closed = false;                            // each log ended heading as it began
    double usual_mark_error_rad = radFromDeg(1.5);  // of putting it to a mark by eye
    double wanted_standard_error = 0.001;           // a third of a degree in a turn
};

struct GyroScale {
    TurnsFound turns{};
    std::optional<TurnFit> fit{};          // none: no whole turn
    std::vector<HeldOutError> held_out{};  // of those turns that are no outliers
    Calibration calibration{};
};

// The scale of a gyro, "gyro_scale" of the vehicle file, from logs of standing at a mark, turning
// by whole turns and standing at the mark again, or of drives that end heading as they began. Its
// bias is measured at each stand. A bias and a warm-up that the file gives are those of the scaled
// rate, so they change with the scale and are found too.
// Refused, with the reason, are readings that are no numbers, a gyro at the end of its range, no
// whole turns, or more of them than can be counted without being told, and turns that the encoders
// tell the other way round. Not proven where it turned one way only.
GyroScale calibrateGyroScale(std::span<const SampleSet> sets, const Vehicle& believed,
                             const GyroScaleOptions& options = {});

}  // namespace hedr
