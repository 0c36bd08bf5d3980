#include "core/calibration/history/vehicle_update.h"

#include <fcntl.h>
#include <sys/file.h>

#include <optional>
#include <vector>

#include "core/file_descriptor.h"
#include "core/robot/vehicle_edit.h"
#include "core/text/clean_text.h"
#include "core/text/text_file.h"

namespace hedr {

namespace {

namespace fs = std::filesystem;

constexpr const char* kRestored = "restore";

std::optional<double> meanTemperature_c(const std::vector<SampleSet>& samples) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const SampleSet& set : samples) {
        for (const SensorReport& report : set.reports) {
            if (!report.temperature_c) continue;
            sum += *report.temperature_c;
            ++count;
        }
    }
    if (count == 0) return std::nullopt;
    return sum / static_cast<double>(count);
}

Result<std::string> vehicleText(const fs::path& file, const Vehicle& believed) {
    auto text = readTextFile(file);
    const bool missing = !text && text.error().code == ErrorCode::kFileMissing;
    if (missing) return formatVehicle(believed);
    if (text && !isUtf8(*text))
        return fail(ErrorCode::kBadFormat, file.string(), "it is no UTF-8: save it as that");
    return text;
}

// Only what was found changes: since the samples were read, the file may have got other numbers.
Result<std::string> calibratedText(const std::string& before, const Calibration& calibration,
                                   const std::string& name) {
    const auto after = parseVehicle(before, name).and_then([&](const Vehicle& vehicle) {
        return calibrated(vehicle, calibration);
    });
    if (!after) return tl::make_unexpected(after.error());
    return withNumbersOf(*after, before, name);
}

CalibrationRecord recordIn(const CalibrationContext& context, const Calibration& calibration,
                           const ProcedureInput& input) {
    CalibrationRecord record = recordOf(calibration);
    record.robot = input.vehicle.name;
    record.told = input.settings;
    record.time_utc = context.time_utc;
    record.who = context.who;
    record.surface = context.surface;
    record.program_version = context.program_version;
    record.temperature_c = meanTemperature_c(input.sets);
    record.taken_over = calibration.verdict == Verdict::kAccepted;
    return record;
}

// Held while a vehicle file is read, changed and written: two programs may calibrate one robot.
FileDescriptor lockedFolderOf(const fs::path& vehicle_file) {
    const fs::path folder = vehicle_file.has_parent_path() ? vehicle_file.parent_path() : ".";
    FileDescriptor lock(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (lock) (void)::flock(lock.get(), LOCK_EX);
    return lock;
}

// Keeps the record and gives the vehicle file its new text. The entry's name.
Result<std::string> takeOver(const fs::path& vehicle_file, const CalibrationRecord& record,
                             const std::vector<SampleSet>& samples) {
    return keepTakenOver(historyFolderOf(vehicle_file), record, samples,
                         [&] { return writeTextFile(vehicle_file, record.vehicle_after); });
}

}  // namespace

Result<KeptCalibration> keepInHistory(const fs::path& vehicle_file, const Calibration& calibration,
                                      const ProcedureInput& input,
                                      const CalibrationContext& context) {
    CalibrationRecord record = recordIn(context, calibration, input);
    const FileDescriptor lock = lockedFolderOf(vehicle_file);
    const auto before = vehicleText(vehicle_file, input.vehicle);
    if (!before) return tl::make_unexpected(before.error());
    record.vehicle_before = record.vehicle_after = *before;
    if (record.taken_over) {
        const auto after = calibratedText(*before, calibration, vehicle_file.string());
        if (!after) return tl::make_unexpected(after.error());
        record.vehicle_after = *after;
    }
    const auto entry = record.taken_over
                           ? takeOver(vehicle_file, record, input.sets)
                           : keepCalibration(historyFolderOf(vehicle_file), record, input.sets);
    if (!entry) return tl::make_unexpected(entry.error());
    return KeptCalibration{*entry, record.taken_over};
}

Result<void> replaceVehicle(const fs::path& vehicle_file, const std::string& text,
                            const Vehicle& vehicle, const Replacement& why) {
    const FileDescriptor lock = lockedFolderOf(vehicle_file);
    const auto now = vehicleText(vehicle_file, vehicle);
    if (!now) return tl::make_unexpected(now.error());
    const CalibrationRecord record{.procedure = kRestored,
                                   .time_utc = why.time_utc,
                                   .who = why.who,
                                   .robot = vehicle.name,
                                   .surface = why.surface,
                                   .verdict = Verdict::kAccepted,
                                   .reason = why.reason,
                                   .taken_over = true,
                                   .vehicle_before = *now,
                                   .vehicle_after = text};
    const auto kept = takeOver(vehicle_file, record, {});
    if (!kept) return tl::make_unexpected(kept.error());
    return {};
}

Result<void> restoreVehicle(const fs::path& vehicle_file, const HistoryEntry& entry, RestoreTo to,
                            const std::string& time_utc, const std::string& who) {
    if (!entry.record) return tl::make_unexpected(entry.record.error());
    const std::string& text =
        to == RestoreTo::kBefore ? entry.record->vehicle_before : entry.record->vehicle_after;
    const auto vehicle = parseVehicle(text, entry.name);
    if (!vehicle) return tl::make_unexpected(vehicle.error());
    return replaceVehicle(
        vehicle_file, text, *vehicle,
        {.time_utc = time_utc, .who = who, .reason = "Restored from " + entry.name + "."});
}

}  // namespace hedr
