#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/calibration/history/calibration_record.h"
#include "core/calibration/sample_set.h"
#include "core/result.h"

namespace hedr {

// The history of a robot lies beside its vehicle file: "packbot.toml" has the folder
// "packbot.history" with one folder for each calibration, named by time and procedure, which holds
// "record.toml" and the samples.
std::filesystem::path historyFolderOf(const std::filesystem::path& vehicle_file);

struct HistoryEntry {
    std::string name;  // of its folder
    std::filesystem::path folder;
    Result<CalibrationRecord> record;  // or why it cannot be read
};

// Writes samples and record; the record comes last, so that a folder without one is what a crash
// left. Returns the entry's name. Errors: kFileUnwritable, kDiskFull; nothing is left then.
Result<std::string> keepCalibration(const std::filesystem::path& history, CalibrationRecord record,
                                    const std::vector<SampleSet>& samples);

// The same for a record that says "taken over": it says so only once `write_vehicle` has given the
// vehicle file its new text. All that needs room is on the disk before that. Errors: those of
// keepCalibration and of `write_vehicle`; where that fails, the entry stays and says that the
// values were not taken over.
Result<std::string> keepTakenOver(const std::filesystem::path& history,
                                  const CalibrationRecord& record,
                                  const std::vector<SampleSet>& samples,
                                  const std::function<Result<void>()>& write_vehicle);

// The earliest first; empty where there is no history. Errors: kFileUnreadable.
Result<std::vector<HistoryEntry>> loadHistory(const std::filesystem::path& history);

// The one of that name; a part of the name is enough where it fits one only. Errors: kUnknownName
// (lists what there is), those of the record.
Result<HistoryEntry> historyEntry(const std::filesystem::path& history, const std::string& name);

// Copies an entry with its samples, whose hashes are compared, to a new folder. Errors:
// kFileExists, kFileChanged (samples that are not as they were), kFileUnwritable, kDiskFull.
Result<void> exportEntry(const HistoryEntry& entry, const std::filesystem::path& folder);

}  // namespace hedr
