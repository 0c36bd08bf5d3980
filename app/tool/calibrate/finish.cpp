#include <chrono>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/tool/calibrate/verbs.h"
#include "app/tool/json_line.h"
#include "core/calibration/history/vehicle_update.h"

namespace hedr::tool {

namespace {

void tell(const CalibrateOptions& options, const Calibration& calibration,
          const std::optional<KeptCalibration>& kept) {
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

Result<void> finishCalibration(const CalibrateOptions& options, const ProcedureInput& input,
                               const Calibration& calibration) {
    std::optional<KeptCalibration> kept;
    if (options.write) {
        auto done = keepInHistory(options.vehicle, calibration, input,
                                  {.time_utc = nowUtc(),
                                   .who = whoIsIt(options.who),
                                   .surface = options.surface,
                                   .program_version = HEDR_VERSION});
        if (!done) return tl::make_unexpected(done.error());
        kept = std::move(*done);
    }
    tell(options, calibration, kept);
    if (calibration.verdict != Verdict::kRefused) return {};
    return fail(ErrorCode::kCalibrationRefused, "The calibration", calibration.reason);
}

}  // namespace hedr::tool
