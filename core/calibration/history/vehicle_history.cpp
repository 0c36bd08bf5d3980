#include "core/calibration/history/vehicle_history.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "core/calibration/gyro_samples.h"
#include "core/robot/sensor_csv.h"
#include "core/text/clean_text.h"
#include "core/text/file_hash.h"
#include "core/text/text_file.h"
#include "core/text/trimmed.h"

namespace hedr {

namespace {

namespace fs = std::filesystem;

constexpr const char* kRecordFile = "record.toml";
constexpr const char* kTakenOver = "taken-over.toml";  // waits to become the record
constexpr std::size_t kLongestOrigin = 4096;           // bytes of a path

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
    std::error_code ignored;
    // A pipe may never bring anything, and the whole history would wait for it.
    if (fs::is_other(file, ignored))
        return fail(ErrorCode::kFileUnreadable, file.string(), "not a regular file");
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

}  // namespace

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

Result<std::string> keepTakenOver(const fs::path& history, const CalibrationRecord& record,
                                  const std::vector<SampleSet>& samples,
                                  const std::function<Result<void>()>& write_vehicle) {
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
    const auto written =
        writeTextFile(folder / kTakenOver, formatRecord(*taken)).and_then(write_vehicle);
    std::error_code ignored;
    if (written) {
        fs::rename(folder / kTakenOver, folder / kRecordFile, ignored);
        return entry;
    }
    fs::remove(folder / kTakenOver, ignored);
    return fail(written.error().code, written.error().subject,
                written.error().detail + "; the calibration is kept as " + *entry);
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
