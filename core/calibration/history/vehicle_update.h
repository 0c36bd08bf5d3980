#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/calibration/history/vehicle_history.h"
#include "core/calibration/procedure_input.h"
#include "core/result.h"

// Changes of a vehicle file. What it had is kept in the robot's history first, so that nothing is
// ever lost; programs that change one file at once wait for each other.
namespace hedr {

// Who calibrates when, on what floor.
struct CalibrationContext {
    std::string time_utc{};  // ISO 8601
    std::string who{};
    std::string surface{};
    std::string program_version{};
    bool declined = false;  // what was accepted is not wanted: it is only kept
};

struct KeptCalibration {
    std::string entry{};      // its name in the history
    bool taken_over = false;  // the vehicle file has the new values
};

// Keeps a calibration and what it was made of in the history, and gives the vehicle file what was
// accepted, and nothing else; a file that is not there yet is made from the vehicle as it was
// believed. The record comes first, so that what the file had is never lost. Errors: those of
// files, kBadFormat (it is no UTF-8), kOtherWheels (wheels were found beside others than the file
// has: one without the other would be wrong; the calibration is kept); the vehicle file is as it
// was then.
Result<KeptCalibration> keepInHistory(const std::filesystem::path& vehicle_file,
                                      const Calibration& calibration, const ProcedureInput& input,
                                      const CalibrationContext& context);

// Why a vehicle file gets another text, for the history.
struct Replacement {
    std::string time_utc{};
    std::string who{};
    std::string surface{};
    std::string reason{};  // one sentence
};
// The new text of a vehicle file, from what it has now, or why that cannot be read.
using VehicleTextChange = std::function<Result<std::string>(const Result<std::string>& now)>;
// Gives the vehicle file another text; what it has now is kept as an entry "restore" of the
// history; one that is gone is made again. Errors: those of files and of `change`, kBadFormat (a
// text that says no vehicle); the vehicle file is as it was then.
Result<void> replaceVehicle(const std::filesystem::path& vehicle_file,
                            const VehicleTextChange& change, const Replacement& why);

// Writes the vehicle file as it was after that calibration or before it, as replaceVehicle does.
// Errors: those of it and of the record.
enum class RestoreTo : unsigned char { kBefore, kAfter };
Result<void> restoreVehicle(const std::filesystem::path& vehicle_file, const HistoryEntry& entry,
                            RestoreTo to, const std::string& time_utc, const std::string& who);

}  // namespace hedr
