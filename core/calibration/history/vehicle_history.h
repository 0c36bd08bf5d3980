#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/calibration/history/calibration_record.h"
#include "core/calibration/procedure_input.h"
#include "core/result.h"

namespace hedr {

// The history of a robot lies beside its vehicle file: "packbot.toml" has the folder
// "packbot.history" with one folder for each calibration, named by time and procedure, which holds
// "record.toml" and the samples.
std::filesystem::path historyFolderOf(const std::filesystem::path& vehicle_file);

// Who calibrates when, on what floor.
struct CalibrationContext {
    std::string time_utc{};  // ISO 8601
    std::string who{};
    std::string surface{};
    std::string program_version{};
};

struct KeptCalibration {
    std::string entry{};      // its name in the history
    bool taken_over = false;  // the vehicle file has the new values
};

// Keeps a calibration and what it was made of in the history, and gives the vehicle file what was
// accepted, and nothing else; a file that is not there yet is made from the vehicle as it was
// believed. The record comes first, so that what the file had is never lost. Errors: those of
// files, kBadFormat (it is no UTF-8); the vehicle file is as it was then.
Result<KeptCalibration> keepInHistory(const std::filesystem::path& vehicle_file,
                                      const Calibration& calibration, const ProcedureInput& input,
                                      const CalibrationContext& context);

struct HistoryEntry {
    std::string name;  // of its folder
    std::filesystem::path folder;
    Result<CalibrationRecord> record;  // or why it cannot be read
};

// Writes samples and record; the record comes last, so that a folder without one is what a crash
// left. Returns the entry's name. Errors: kFileUnwritable, kDiskFull; nothing is left then.
Result<std::string> keepCalibration(const std::filesystem::path& history, CalibrationRecord record,
                                    const std::vector<SampleSet>& samples);

// The earliest first; empty where there is no history. Errors: kFileUnreadable.
Result<std::vector<HistoryEntry>> loadHistory(const std::filesystem::path& history);

// The one of that name; a part of the name is enough where it fits one only. Errors: kUnknownName
// (lists what there is), those of the record.
Result<HistoryEntry> historyEntry(const std::filesystem::path& history, const std::string& name);

// Why a vehicle file gets another text, for the history.
struct Replacement {
    std::string time_utc{};
    std::string who{};
    std::string surface{};
    std::string reason{};  // one sentence
};
// Gives the vehicle file that text, which says `vehicle`; what it has now is kept as an entry
// "restore" of the history; one that is gone is made again. Errors: those of files; the vehicle
// file is as it was then.
Result<void> replaceVehicle(const std::filesystem::path& vehicle_file, const std::string& text,
                            const Vehicle& vehicle, const Replacement& why);

// Writes the vehicle file as it was after that calibration or before it, as replaceVehicle does.
// Errors: those of it and of the record.
enum class RestoreTo : unsigned char { kBefore, kAfter };
Result<void> restoreVehicle(const std::filesystem::path& vehicle_file, const HistoryEntry& entry,
                            RestoreTo to, const std::string& time_utc, const std::string& who);

// Copies an entry with its samples, whose hashes are compared, to a new folder. Errors:
// kFileExists, kFileChanged (samples that are not as they were), kFileUnwritable, kDiskFull.
Result<void> exportEntry(const HistoryEntry& entry, const std::filesystem::path& folder);

}  // namespace hedr
