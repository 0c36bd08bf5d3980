#include <chrono>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/tool/calibrate/verbs.h"
#include "app/tool/json_line.h"
#include "core/robot/vehicle_edit.h"
#include "core/text/text_file.h"

namespace hedr::tool {

namespace {

std::optional<double> meanTemperature_c(const std::vector<SampleSet>& logs) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const SampleSet& log : logs) {
        for (const SensorReport& report : log.reports) {
            if (!report.temperature_c) continue;
            sum += *report.temperature_c;
            ++count;
        }
    }
    if (count == 0) return std::nullopt;
    return sum / static_cast<double>(count);
}

struct Kept {
    std::string entry{};
    bool taken_over = false;
};

// The record first: what the file had before must not be lost.
Result<Kept> keep(const CalibrateOptions& options, const CalibrationInput& input,
                  const Calibration& calibration) {
    const auto before = readTextFile(options.vehicle);
    if (!before) return tl::make_unexpected(before.error());
    CalibrationRecord record = recordOf(calibration);
    record.time_utc = nowUtc();
    record.who = whoIsIt(options.who);
    record.robot = input.vehicle.name;
    record.surface = options.surface;
    record.temperature_c = meanTemperature_c(input.logs);
    record.program_version = HEDR_VERSION;
    record.vehicle_before = record.vehicle_after = *before;
    record.taken_over = calibration.verdict == Verdict::kAccepted;
    if (record.taken_over) {
        const auto text = calibrated(input.vehicle, calibration).and_then([&](const Vehicle& v) {
            return withNumbersOf(v, *before, options.vehicle);
        });
        if (!text) return tl::make_unexpected(text.error());
        record.vehicle_after = *text;
    }
    const auto entry = keepCalibration(historyFolderOf(options.vehicle), record, input.logs);
    if (!entry) return tl::make_unexpected(entry.error());
    if (!record.taken_over) return Kept{*entry};
    const auto written = writeTextFile(options.vehicle, record.vehicle_after);
    if (!written) return tl::make_unexpected(written.error());
    return Kept{*entry, true};
}

void tell(const CalibrateOptions& options, const Calibration& calibration,
          const std::optional<Kept>& kept) {
    if (options.json) {
        auto object = toJson(calibration);
        object["written"] = kept && kept->taken_over;
        object["history"] = kept ? nlohmann::ordered_json(kept->entry) : nullptr;
        std::cout << jsonLine(object);
        return;
    }
    printCalibration(calibration);
    if (kept && kept->taken_over) std::cout << options.vehicle << " has the new values\n";
    if (kept) std::cout << "kept in the history as " << kept->entry << '\n';
}

}  // namespace

std::string nowUtc() {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    std::tm utc{};
    gmtime_r(&now, &utc);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
    return text.data();
}

std::string whoIsIt(const std::string& option) {
    if (!option.empty()) return option;
    const char* user = std::getenv("USER");
    return user ? user : "";
}

Result<void> finishCalibration(const CalibrateOptions& options, const CalibrationInput& input,
                               const Calibration& calibration) {
    std::optional<Kept> kept;
    if (options.write) {
        auto done = keep(options, input, calibration);
        if (!done) return tl::make_unexpected(done.error());
        kept = std::move(*done);
    }
    tell(options, calibration, kept);
    if (calibration.verdict != Verdict::kRefused) return {};
    return fail(ErrorCode::kBadValue, "The calibration", "is refused: " + calibration.reason);
}

}  // namespace hedr::tool
