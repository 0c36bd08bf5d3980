#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/tool/command.h"
#include "core/calibration/history/vehicle_history.h"
#include "core/calibration/procedures.h"

namespace hedr::tool {

// The words after `hedr calibrate` besides the procedures: about the robot's history.
Job addCalibrateHistory(CLI::App& app);
Job addCalibrateCompare(CLI::App& app);
Job addCalibrateRestore(CLI::App& app);
Job addCalibrateExport(CLI::App& app);
Job addCalibrateSurfaces(CLI::App& app);
Job addCalibrateUseSurface(CLI::App& app);
// Errors: kFileMissing (neither the vehicle file nor a history is there), those of loadHistory.
Result<std::vector<HistoryEntry>> historyBeside(const std::string& vehicle_file);
std::string complaintAbout(const HistoryEntry& entry);  // that is damaged: "cannot be read: …"
// The vehicle.toml beside which the history lies.
void addVehicleFile(CLI::App& app, std::string& vehicle_file);

// What every procedure takes.
struct CalibrateOptions {
    std::vector<std::string> inputs{};
    std::string vehicle{};
    std::string key{};
    std::string who{};
    std::string surface{};
    bool write = false;
    bool json = false;
};
void addCalibrateOptions(CLI::App& app, CalibrateOptions& options);

// The samples of logs and missions, a set for each start of a mission's robot; the vehicle is the
// file's, or a mission's where none is given. Errors: those of the files.
Result<ProcedureInput> loadCalibrationInput(const CalibrateOptions& options,
                                            const std::string& gyro_column = kGyroColumn);

// Prints it, and with --write keeps it in the history and gives the vehicle file what was accepted.
// Errors: kCalibrationRefused, those of writing.
Result<void> finishCalibration(const CalibrateOptions& options, const ProcedureInput& input,
                               const Calibration& calibration);

std::string marginWords(const Estimate& estimate);  // "+- 0.12 (95 %)", "+0.14 -0.11 (95 %)"
void printCalibration(const Calibration& calibration);
nlohmann::ordered_json toJson(const Calibration& calibration);

std::string nowUtc();
std::string whoIsIt(const std::string& option);

}  // namespace hedr::tool
