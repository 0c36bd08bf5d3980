#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "core/calibration/gyro/warmup_curve.h"
#include "core/robot/report.h"
#include "core/simulation/random.h"
#include "tests/core/calibration/gyro/warmup_blocks.h"

namespace hedr {

// A standing gyro since it was switched on, and what is done to it.
struct Stand {
    GyroDrift curve = kGyrostar;
    double minutes = 20.0;
    double rate_hz = 1.0 / 0.03;
    double noise_rad_s_sqrthz = kGyrostarNoise_rad_s_sqrthz;
    double begin_s = 0.0;                         // of the robot's clock
    double on_before_s = 0.0;                     // switched on so long before
    std::function<double(double t_s)> besides{};  // further rate
};

inline std::vector<SensorReport> reportsOf(const Stand& stand, Random& random) {
    std::vector<SensorReport> reports;
    const double deviation = stand.noise_rad_s_sqrthz * std::sqrt(stand.rate_hz);
    for (int i = 0; i / stand.rate_hz <= 60.0 * stand.minutes; ++i) {
        const double t_s = i / stand.rate_hz;
        double rate_rad_s = biasAt(stand.curve, stand.on_before_s + t_s);
        rate_rad_s += deviation * random.normal();
        if (stand.besides) rate_rad_s += stand.besides(t_s);
        reports.push_back({.robot_time_s = stand.begin_s + t_s, .gyro = GyroRate{rate_rad_s}});
    }
    return reports;
}

}  // namespace hedr
