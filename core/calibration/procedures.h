#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/calibration/calibration.h"
#include "core/calibration/procedure_input.h"

namespace hedr {

// Which of the settings a procedure takes, and how it is asked for.
enum class ProcedureSetting : std::uint8_t {
    kTurns,
    kClosed,
    kPushed,
    kSpun,
    kOnBefore,
    kRoomChanges,
    kEnds,
    kClosedDrives,
    kStraightRuns
};

// A calibration as the window and the command line offer it.
struct Procedure {
    std::string_view name;     // on the command line and in the history
    std::string_view title;    // "Gyro bias"
    std::string_view purpose;  // one short sentence
    // Any input; what is no good is refused with its reason.
    Calibration (*run)(const ProcedureInput& input);
    std::span<const ProcedureSetting> settings{};  // that count
    bool depends_on_floor = false;                 // what it finds
};

// The one table of procedures.
std::span<const Procedure> procedures();
const Procedure* findProcedure(std::string_view name);  // nullptr: there is none

}  // namespace hedr
