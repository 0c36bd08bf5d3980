#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/robot/report.h"

namespace hedr {

// A gyro's readings in the sensor's own scale, bias included: what calibration looks at.
struct GyroSample {
    double t_s = 0.0;
    double dt_s = 0.0;        // since the one before
    double rate_rad_s = 0.0;  // mean over dt_s for an angle, momentary for a rate
};

struct GyroSamples {
    std::vector<GyroSample> samples{};
    double period_s = 0.0;   // median of dt_s
    std::size_t broken = 0;  // no finite numbers, or time that does not go on
    std::size_t gaps = 0;    // steps longer than three periods
    double longest_gap_s = 0.0;

    double duration_s() const {
        return samples.empty() ? 0.0 : samples.back().t_s - samples.front().t_s;
    }
    double mean_rad_s() const;
    std::vector<double> rates_rad_s() const;
};

// The same reports with a rate wherever they had an angle, for a log. The first angle has none.
std::vector<SensorReport> withGyroRates(std::vector<SensorReport> reports);

// That of a gyro of which more than a tenth was no use; empty: none.
std::string complaintAboutBroken(std::size_t good, std::size_t broken);

// Reports without a gyro reading are passed over. Angles may wrap, as on the wire. Errors: kNoData
// (no gyro, or fewer than two readings).
Result<GyroSamples> gyroSamplesOf(std::span<const SensorReport> reports);

}  // namespace hedr
