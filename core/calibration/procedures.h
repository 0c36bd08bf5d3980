#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/calibration/calibration.h"
#include "core/calibration/sample_set.h"
#include "core/calibration/umbmark_ends.h"
#include "core/robot/vehicle.h"

namespace hedr {

// What the operator knows besides the samples.
struct ProcedureSettings {
    std::optional<double> turns{};       // whole ones, of each stretch of turning; none: counted
    bool closed = false;                 // each record ended heading as it began, drives also there
    std::optional<double> distance_m{};  // that it was pushed, or of each straight run
    double on_before_s = 0.0;            // the gyro was switched on so long before the record began
    std::vector<UmbmarkEnd> ends{};      // of square drives, by tape
};
enum class ProcedureSetting : std::uint8_t {
    kTurns,
    kClosed,
    kPushed,
    kSpun,
    kOnBefore,
    kEnds,
    kClosedDrives,
    kStraightRuns
};

struct ProcedureInput {
    std::vector<SampleSet> sets{};
    Vehicle vehicle{};  // as it is believed
    ProcedureSettings settings{};
};

// A calibration as the window and the command line offer it.
struct Procedure {
    std::string_view name;     // on the command line and in the history
    std::string_view title;    // "Gyro bias"
    std::string_view purpose;  // one short sentence
    // Any input; what is no good is refused with its reason.
    Calibration (*run)(const ProcedureInput& input);
    std::span<const ProcedureSetting> settings{};  // that count
};

// The one table of procedures.
std::span<const Procedure> procedures();
const Procedure* findProcedure(std::string_view name);  // nullptr: there is none

}  // namespace hedr
