#include "core/calibration/history/vehicle_update.h"

#include <fcntl.h>
#include <sys/file.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
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

// Wheels are found beside those that are believed: a wheelbase belongs to its diameters.
bool tellsWheels(const Calibration& calibration) {
    constexpr std::array<std::string_view, 4> kKeys{
        "wheelbase_m", "left_wheel_diameter_m", "right_wheel_diameter_m", "ticks_per_revolution"};
    return std::ranges::any_of(calibration.found, [&](const FoundParameter& found) {
        return std::ranges::find(kKeys, found.key) != kKeys.end();
    });
}

bool areSameWheels(const VehicleGeometry& a, const VehicleGeometry& b) {
    constexpr double kRounded = 1e-5;  // a robot says micrometres
    const auto same = [](double x, double y) { return std::abs(x - y) <= kRounded * std::abs(y); };
    return same(a.wheelbase_m, b.wheelbase_m) &&
           same(a.left_wheel_diameter_m, b.left_wheel_diameter_m) &&
           same(a.right_wheel_diameter_m, b.right_wheel_diameter_m) &&
           same(a.ticks_per_revolution, b.ticks_per_revolution);
}

// Only what was found changes: since the samples were read, the file may have got other numbers.
Result<std::string> calibratedText(const std::string& before, const Calibration& calibration,
                                   const Vehicle& believed, const std::string& name) {
    const auto in_file = parseVehicle(before, name);
    if (!in_file) return tl::make_unexpected(in_file.error());
    if (tellsWheels(calibration) && !areSameWheels(in_file->geometry, believed.geometry))
        return fail(ErrorCode::kOtherWheels, name);
    const auto after = calibrated(*in_file, calibration);
    if (!after) return tl::make_unexpected(after.error());
    return withNumbersOf(*after, before, name);
}

Error alsoSaying(Error error, const std::string& entry) {
    error.detail +=
        std::string(error.detail.empty() ? "" : "; ") + "the calibration is kept as " + entry;
    return error;
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
    record.taken_over = calibration.verdict == Verdict::kAccepted && !context.declined;
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
    const fs::path history = historyFolderOf(vehicle_file);
    const auto keep_only = [&] {
        record.taken_over = false;
        return keepCalibration(history, record, input.sets);
    };
    if (!record.taken_over) {
        return keep_only().map([](const std::string& entry) { return KeptCalibration{entry}; });
    }
    const auto after = calibratedText(*before, calibration, input.vehicle, vehicle_file.string());
    if (!after && after.error().code == ErrorCode::kOtherWheels) {
        const auto entry = keep_only();
        return tl::make_unexpected(entry ? alsoSaying(after.error(), *entry) : entry.error());
    }
    if (!after) return tl::make_unexpected(after.error());
    record.vehicle_after = *after;
    return takeOver(vehicle_file, record, input.sets).map([](const std::string& entry) {
        return KeptCalibration{entry, true};
    });
}

Result<void> replaceVehicle(const fs::path& vehicle_file, const VehicleTextChange& change,
                            const Replacement& why) {
    const FileDescriptor lock = lockedFolderOf(vehicle_file);
    const auto now = readTextFile(vehicle_file);
    const auto text = change(now);
    if (!text) return tl::make_unexpected(text.error());
    const auto vehicle = parseVehicle(*text, vehicle_file.string());
    if (!vehicle) return tl::make_unexpected(vehicle.error());
    const auto before = vehicleText(vehicle_file, *vehicle);
    if (!before) return tl::make_unexpected(before.error());
    const CalibrationRecord record{.procedure = kRestored,
                                   .time_utc = why.time_utc,
                                   .who = why.who,
                                   .robot = vehicle->name,
                                   .surface = why.surface,
                                   .verdict = Verdict::kAccepted,
                                   .reason = why.reason,
                                   .taken_over = true,
                                   .vehicle_before = *before,
                                   .vehicle_after = *text};
    const auto kept = takeOver(vehicle_file, record, {});
    if (!kept) return tl::make_unexpected(kept.error());
    return {};
}

Result<void> restoreVehicle(const fs::path& vehicle_file, const HistoryEntry& entry, RestoreTo to,
                            const std::string& time_utc, const std::string& who) {
    if (!entry.record) return tl::make_unexpected(entry.record.error());
    const std::string& text =
        to == RestoreTo::kBefore ? entry.record->vehicle_before : entry.record->vehicle_after;
    return replaceVehicle(
        vehicle_file, [&](const Result<std::string>&) { return Result<std::string>(text); },
        {.time_utc = time_utc, .who = who, .reason = "Restored from " + entry.name + "."});
}

}  // namespace hedr
