#include "core/calibration/procedures.h"

#include <array>

#include "core/calibration/gyro_noise.h"

namespace hedr {

namespace {

// What is measured on one standing robot goes by what came last.
std::span<const SensorReport> lastReports(const ProcedureInput& input) {
    if (input.sets.empty()) return {};
    return input.sets.back().reports;
}

Calibration runGyroNoise(const ProcedureInput& input) {
    Calibration calibration = calibrateGyroNoise(lastReports(input), input.vehicle).calibration;
    if (input.sets.size() > 1)
        calibration.remarks.emplace_back("Of several records only the last one was looked at.");
    return calibration;
}

constexpr std::array kProcedures{
    Procedure{"allan", "Gyro noise", "How good the gyro is; sets the filters.", runGyroNoise},
};

}  // namespace

std::span<const Procedure> procedures() { return kProcedures; }

}  // namespace hedr
