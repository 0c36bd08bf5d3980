#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/calibration/calibration.h"
#include "core/calibration/gyro/gyro_bias_fit.h"
#include "core/calibration/gyro/stillness.h"
#include "core/geometry/angle.h"
#include "core/robot/report.h"
#include "core/robot/vehicle.h"

namespace hedr {

struct GyroBiasOptions {
    double wanted_standard_error_rad_s = radFromDeg(0.005);  // 0.3° in a minute
};

struct GyroBias {
    Estimate bias_rad_s{};    // as in the vehicle file: after the scale
    Estimate drift_rad_s2{};  // of it, while it was measured
    Estimate noise_rad_s_sqrthz{};
    StandingTime standing{};                // where it was measured: the longest, or the end of it
    double left_out_s = 0.0;                // before it, as the bias changed too much for one mean
    double changed_rad_s2 = 0.0;            // then
    double needed_s = 0.0;                  // T_bias: so long it is worth to stand
    std::optional<double> temperature_c{};  // mean
    Stillness::State state = Stillness::State::kTooEarly;  // now
    std::vector<Disturbance> disturbances{};
    Calibration calibration{};
};

// The bias of a gyro from a robot that stands, "gyro_bias_rad_s" of the vehicle file. Any reports
// will do: the longest time of standing counts, and motion ends it (Stillness). Of a gyro that is
// warming up only the end counts. Refused, with the reason, are readings that are no numbers, all
// equal or clipped, too little standing, a bias of more than 20 °/s or one that changes quickly,
// and a rate that changed for good.
GyroBias calibrateGyroBias(std::span<const SensorReport> reports, const Vehicle& believed,
                           const GyroBiasOptions& options = {});

}  // namespace hedr
