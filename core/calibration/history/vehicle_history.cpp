#include "core/calibration/history/vehicle_history.h"

#include <fcntl.h>
#include <sys/file.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "core/calibration/gyro_samples.h"
#include "core/file_descriptor.h"
#include "core/robot/sensor_csv.h"
#include "core/robot/vehicle_edit.h"
#include "core/text/clean_text.h"
#include "core/text/file_hash.h"
#include "core/text/text_file.h"
#include "core/text/trimmed.h"

namespace hedr {

namespace {

namespace fs = std::filesystem;

constexpr const char* kRecordFile = "record.toml";
constexpr const char* kTakenOver = "taken-over.toml";  // waits to become the record
constexpr const char* kRestored = "restore";
constexpr std::size_t kLongestOrigin = 4096;  // bytes of a path

// "2026-11-28T23:59:00Z" as a part of a file's name.
std::string inName(const std::string& time_utc) {
    std::string name = time_utc;
    std::erase_if(name, [](char c) { return c == ':' || c == '/' || c == '.'; });
    return name;
}

Error cannotWrite(const fs::path& path, const std::error_code& why) {
    const bool full = why == std::errc::no_space_on_device;
    return {full ? ErrorCode::kDiskFull : ErrorCode::kFileUnwritable, path.string(), why.message()};
}

Result<void> makeFolder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) return tl::make_unexpected(cannotWrite(folder, error));
    return {};
}

// A new folder of the history, which is nobody else's: two programs may be at work. Its name.
Result<std::string> newEntry(const fs::path& history, const CalibrationRecord& record) {
    auto made = makeFolder(history);
    if (!made) return tl::make_unexpected(made.error());
    const std::string wanted = inName(record.time_utc) + "-" + record.procedure;
    for (int n = 1;; ++n) {
        const std::string name = n == 1 ? wanted : wanted + "-" + std::to_string(n);
        std::error_code error;
        if (fs::create_directory(history / name, error)) return name;
        if (error && error != std::errc::file_exists)
            return tl::make_unexpected(cannotWrite(history / name, error));
    }
}

Result<RawSamples> keepSamples(const fs::path& folder, const SampleSet& samples,
                               std::size_t number) {
    RawSamples raw{.file = "samples-" + std::to_string(number) + ".csv",
                   .origin = cleanText(samples.origin, kLongestOrigin)};
    const auto saved = saveSensorLog(folder / raw.file, withGyroRates(samples.reports));
    if (!saved) return tl::make_unexpected(saved.error());
    const auto hash = fileHash(folder / raw.file);
    if (!hash) return tl::make_unexpected(hash.error());
    raw.sha256 = *hash;
    return raw;
}

// What could not be read again would be lost.
Result<void> writeRecord(const fs::path& folder, const CalibrationRecord& record) {
    const fs::path file = folder / kRecordFile;
    const std::string text = formatRecord(record);
    const auto again = parseRecord(text, file.string());
    if (!again) return tl::make_unexpected(again.error());
    return writeTextFile(file, text);
}

Result<void> fill(const fs::path& folder, CalibrationRecord& record,
                  const std::vector<SampleSet>& samples) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
        auto raw = keepSamples(folder, samples[i], i + 1);
        if (!raw) return tl::make_unexpected(raw.error());
        record.raw.push_back(std::move(*raw));
    }
    return writeRecord(folder, record);
}

Result<CalibrationRecord> readRecordIn(const fs::path& folder) {
    const fs::path file = folder / kRecordFile;
    return readTextFile(file).and_then(
        [&](const std::string& text) { return parseRecord(text, file.string()); });
}

// The latest ones.
std::string namesOf(const std::vector<HistoryEntry>& entries) {
    if (entries.empty()) return "the history is empty";
    constexpr std::size_t kMostNames = 10;
    const std::size_t earlier = entries.size() - std::min(entries.size(), kMostNames);
    std::string names;
    for (std::size_t i = earlier; i < entries.size(); ++i)
        names += (names.empty() ? "" : ", ") + entries[i].name;
    if (earlier > 0) names += " and " + std::to_string(earlier) + " earlier ones";
    return "known are " + names;
}

Result<void> compareHash(const fs::path& folder, const RawSamples& raw) {
    const auto hash = fileHash(folder / raw.file);
    if (!hash) return tl::make_unexpected(hash.error());
    if (*hash == raw.sha256) return {};
    return fail(ErrorCode::kFileChanged, (folder / raw.file).string(),
                "it is not as it was when the calibration was made");
}

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

// Keeps the record, writes the vehicle file, and then says that it was taken over: that record is
// on the disk before, so that no step after the vehicle file needs room. The entry's name.
Result<std::string> takeOver(const fs::path& vehicle_file, const CalibrationRecord& record,
                             const std::vector<SampleSet>& samples) {
    const fs::path history = historyFolderOf(vehicle_file);
    CalibrationRecord waiting = record;
    waiting.taken_over = false;
    waiting.vehicle_after = record.vehicle_before;
    auto entry = keepCalibration(history, waiting, samples);
    if (!entry) return entry;
    const fs::path folder = history / *entry;
    auto taken = readRecordIn(folder);
    if (!taken) return tl::make_unexpected(taken.error());
    taken->taken_over = true;
    taken->vehicle_after = record.vehicle_after;
    auto written = writeTextFile(folder / kTakenOver, formatRecord(*taken)).and_then([&] {
        return writeTextFile(vehicle_file, record.vehicle_after);
    });
    std::error_code ignored;
    if (written) {
        fs::rename(folder / kTakenOver, folder / kRecordFile, ignored);
        return entry;
    }
    fs::remove(folder / kTakenOver, ignored);
    return fail(written.error().code, written.error().subject,
                written.error().detail + "; the calibration is kept as " + *entry);
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

fs::path historyFolderOf(const fs::path& vehicle_file) {
    return vehicle_file.parent_path() / (vehicle_file.stem().string() + ".history");
}

Result<std::string> keepCalibration(const fs::path& history, CalibrationRecord record,
                                    const std::vector<SampleSet>& samples) {
    record.who = cleanText(record.who);
    record.robot = cleanText(record.robot);
    record.surface = trimmed(cleanText(record.surface));
    auto name = newEntry(history, record);
    if (!name) return name;
    auto filled = fill(history / *name, record, samples);
    if (filled) return name;
    std::error_code ignored;
    fs::remove_all(history / *name, ignored);
    return tl::make_unexpected(filled.error());
}

Result<std::vector<HistoryEntry>> loadHistory(const fs::path& history) {
    std::vector<HistoryEntry> entries;
    std::error_code error;
    if (!fs::exists(history, error)) return entries;
    for (const fs::directory_entry& each : fs::directory_iterator(history, error)) {
        std::error_code closed;  // to this user: then the entry says so
        if (!each.is_directory(closed)) continue;
        if (!fs::exists(each.path() / kRecordFile, closed) && !closed) continue;
        entries.push_back(
            {each.path().filename().string(), each.path(), readRecordIn(each.path())});
    }
    if (error) return fail(ErrorCode::kFileUnreadable, history.string(), error.message());
    std::ranges::sort(entries, {}, &HistoryEntry::name);
    return entries;
}

Result<HistoryEntry> historyEntry(const fs::path& history, const std::string& name) {
    auto entries = loadHistory(history);
    if (!entries) return tl::make_unexpected(entries.error());
    std::vector<HistoryEntry> found;
    for (const HistoryEntry& entry : *entries) {
        if (entry.name == name) return entry;
        if (entry.name.find(name) != std::string::npos) found.push_back(entry);
    }
    if (found.size() == 1) return found.front();
    return fail(ErrorCode::kUnknownName, name,
                found.empty() ? namesOf(*entries) : "it fits more than one; " + namesOf(found));
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

Result<void> exportEntry(const HistoryEntry& entry, const fs::path& folder) {
    if (!entry.record) return tl::make_unexpected(entry.record.error());
    for (const RawSamples& raw : entry.record->raw) {
        auto same = compareHash(entry.folder, raw);
        if (!same) return same;
    }
    std::error_code error;
    if (fs::exists(folder, error)) return fail(ErrorCode::kFileExists, folder.string());
    fs::copy(entry.folder, folder, error);
    if (error) return tl::make_unexpected(cannotWrite(folder, error));
    return {};
}

}  // namespace hedr
