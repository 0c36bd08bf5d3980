#include "core/calibration/procedures.h"

#include <algorithm>
#include <array>

#include "core/calibration/compass/magnetometer.h"
#include "core/calibration/encoders/encoder_check.h"
#include "core/calibration/gyro/gyro_bias.h"
#include "core/calibration/gyro/gyro_noise.h"
#include "core/calibration/gyro/gyro_scale.h"
#include "core/calibration/gyro/warmup.h"
#include "core/calibration/squares/umbmark_calibration.h"
#include "core/calibration/wheels/straight_runs.h"
#include "core/calibration/wheels/wheel_drive.h"
#include "core/calibration/wheels/wheel_loops.h"

namespace hedr {

namespace {

// What is measured on one standing robot goes by what came last.
std::span<const SensorReport> lastReports(const ProcedureInput& input) {
    if (input.sets.empty()) return {};
    return input.sets.back().reports;
}

Calibration ofLastRecord(const ProcedureInput& input, Calibration calibration) {
    if (input.sets.size() > 1)
        calibration.remarks.emplace_back("Of several records only the last one was looked at.");
    return calibration;
}

Calibration runGyroBias(const ProcedureInput& input) {
    return ofLastRecord(input, calibrateGyroBias(lastReports(input), input.vehicle).calibration);
}

Calibration runWarmup(const ProcedureInput& input) {
    const ProcedureSettings& told = input.settings;
    const WarmupOptions options{
        .on_before_s = told.on_before_s,
        .room = told.room_changes ? RoomTemperature::kMayChange : RoomTemperature::kSteady};
    return ofLastRecord(input,
                        calibrateWarmup(lastReports(input), input.vehicle, options).calibration);
}

Calibration runGyroNoise(const ProcedureInput& input) {
    return ofLastRecord(input, calibrateGyroNoise(lastReports(input), input.vehicle).calibration);
}

Calibration runGyroScale(const ProcedureInput& input) {
    return calibrateGyroScale(input.sets, input.vehicle,
                              {.turns = input.settings.turns, .closed = input.settings.closed})
        .calibration;
}

Calibration runEncoderCheck(const ProcedureInput& input) {
    const ProcedureSettings& told = input.settings;
    return checkEncoders(
               input.sets, input.vehicle,
               {.distance_m = told.distance_m.value_or(1.0), .turns = told.turns.value_or(1.0)})
        .calibration;
}

Calibration runMagnetometer(const ProcedureInput& input) {
    return calibrateMagnetometer(input.sets, input.vehicle).calibration;
}

Calibration runUmbmark(const ProcedureInput& input) {
    return calibrateUmbmark(input.sets, input.settings.ends, input.vehicle).calibration;
}

Calibration runWheels(const ProcedureInput& input) {
    const ProcedureSettings& told = input.settings;
    if (told.distance_m)
        return calibrateByStraightRuns(input.sets, input.vehicle, *told.distance_m).calibration;
    if (told.closed) return calibrateByLoops(input.sets, input.vehicle).calibration;
    return calibrateByDriving(input.sets, input.vehicle).calibration;
}

constexpr std::array kGyroScaleSettings{ProcedureSetting::kTurns, ProcedureSetting::kClosed};

constexpr std::array kEncoderCheckSettings{ProcedureSetting::kPushed, ProcedureSetting::kSpun};

constexpr std::array kWarmupSettings{ProcedureSetting::kOnBefore, ProcedureSetting::kRoomChanges};

constexpr std::array kUmbmarkSettings{ProcedureSetting::kEnds};

constexpr std::array kWheelsSettings{ProcedureSetting::kClosedDrives,
                                     ProcedureSetting::kStraightRuns};

constexpr std::array kProcedures{
    Procedure{"gyro-bias", "Gyro bias", "What the gyro says while the robot stands.", runGyroBias},
    Procedure{"warmup", "Gyro warm-up", "How the gyro drifts after it was switched on.", runWarmup,
              kWarmupSettings},
    Procedure{"allan", "Gyro noise", "How good the gyro is; sets the filters.", runGyroNoise},
    Procedure{"gyro-scale", "Gyro scale", "Whether a full turn reads as a full turn.", runGyroScale,
              kGyroScaleSettings},
    Procedure{"wheels", "Wheels by driving", "Wheelbase and wheels, from any drive with a gyro.",
              runWheels, kWheelsSettings, true},
    Procedure{"umbmark", "Wheels by squares", "Wheelbase and wheels that are not alike.",
              runUmbmark, kUmbmarkSettings, true},
    Procedure{"magnetometer", "Compass", "Takes the robot's own iron out of its compass.",
              runMagnetometer},
    Procedure{"encoder-check", "Encoder check",
              "Finds swapped sides, wrong signs, missing magnets.", runEncoderCheck,
              kEncoderCheckSettings},
};

}  // namespace

std::span<const Procedure> procedures() { return kProcedures; }

const Procedure* findProcedure(std::string_view name) {
    const auto found = std::ranges::find(kProcedures, name, &Procedure::name);
    return found == kProcedures.end() ? nullptr : &*found;
}

}  // namespace hedr
