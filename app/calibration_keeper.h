#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/calibration/history/vehicle_update.h"
#include "ui/calibration/calibration_run.h"
#include "ui/calibration/procedure_list.h"

namespace hedr {

// The vehicle file of a robot that was connected without one: in the program's own folder, by the
// robot's name.
std::filesystem::path ownVehicleFile(const std::string& robot);

// How each procedure went the last time.
std::vector<ProcedureEntry> lastCalibrations(const std::vector<HistoryEntry>& history);

// Keeps what came of a calibration. Errors: those of keepInHistory.
Result<KeptCalibration> keepOutcome(const std::filesystem::path& vehicle_file,
                                    const CalibrationOutcome& outcome);

// Gives the vehicle file the values of an entry of its history, now and by this user. Errors: those
// of restoreVehicle.
Result<void> restoreCalibration(const std::filesystem::path& vehicle_file,
                                const HistoryEntry& entry, RestoreTo to);

}  // namespace hedr
