#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/calibration/gyro/warmup_curve.h"
#include "core/calibration/gyro_samples.h"
#include "core/robot/report.h"
#include "core/robot/vehicle.h"

namespace hedr {

// What ended the standing.
struct WarmupMotion {
    double since_s = 0.0;  // after the record began
    double span_s = 0.0;
    std::optional<double> turn_rad{};  // that the gyro says; none: the wheels counted
};

// "The robot turned by about 0.2° within 0.5 s."
std::string sentenceOf(const WarmupMotion& motion);

// What a gyro said from the beginning of a record on, as long as the robot stood.
struct WarmupRecord {
    std::vector<WarmupBlock> blocks{};  // rates after the vehicle's scale
    double stood_s = 0.0;
    std::optional<WarmupMotion> motion{};
};

// At most a hundred blocks. Readings that stand alone are left out, blocks that were mostly missed
// too. The robot moves where the rate of a quarter of a second to four stands out from the seconds
// before and after it, however the bias drifts, or where the wheels count.
// `on_before_s`: the gyro was switched on so long before the record.
WarmupRecord warmupRecordOf(const GyroSamples& gyro, std::span<const SensorReport> reports,
                            const Vehicle& vehicle, double on_before_s);

}  // namespace hedr
