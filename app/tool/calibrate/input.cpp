#include <filesystem>
#include <optional>

#include "app/tool/calibrate/verbs.h"
#include "app/tool/log_fusion.h"
#include "radio/recomputation.h"

namespace hedr::tool {

namespace {

Result<void> addMission(const CalibrateOptions& options, const std::string& file,
                        ProcedureInput& input) {
    std::optional<RobotKey> key;
    if (!options.key.empty()) {
        auto loaded = loadKeyNamed(options.key);
        if (!loaded) return tl::make_unexpected(loaded.error());
        key = std::move(*loaded);
    }
    auto sensors = sensorsIn(file, key);
    if (!sensors) return tl::make_unexpected(sensors.error());
    tellDamage(file, sensors->salvaged);
    for (SensorStretch& stretch : sensors->stretches)
        input.sets.push_back({file, std::move(stretch.reports)});
    if (options.vehicle.empty()) input.vehicle = sensors->vehicle;
    return {};
}

Result<void> addLog(const std::string& file, const std::string& gyro_column,
                    ProcedureInput& input) {
    auto log = loadSensorLog(file, gyro_column);
    if (!log) return tl::make_unexpected(log.error());
    warnOfIgnored(*log, file);
    input.sets.push_back({file, std::move(log->reports)});
    return {};
}

// A preset has no file of its own to be written.
void needFileToWrite(const CalibrateOptions& options) {
    std::error_code ignored;
    if (options.write && !std::filesystem::is_regular_file(options.vehicle, ignored))
        throw CLI::ValidationError("--write", "needs --vehicle with a file that can be written");
}

}  // namespace

void addCalibrateOptions(CLI::App& app, CalibrateOptions& options) {
    app.add_option("INPUT", options.inputs, "sensors.csv or mission files")->required();
    app.add_option("--vehicle", options.vehicle, vehicleHelp() + "; else a mission's own");
    app.add_option("--key", options.key,
                   "Name or file of the key of a robot that signs, for a mission");
    app.add_option("--operator", options.who, "Who calibrates, for the history")->check(aName());
    app.add_option("--surface", options.surface, "What the robot drives on, for the history")
        ->check(aName());
    app.add_flag("--write", options.write,
                 "Keep it in the history beside the vehicle file, and give the file the values if "
                 "they are accepted");
    app.add_flag("--json", options.json, "One JSON object instead of text");
    app.callback([&options] {
        for (const std::string& input : options.inputs) needVehicleForLog(input, options.vehicle);
        needFileToWrite(options);
    });
}

Result<ProcedureInput> loadCalibrationInput(const CalibrateOptions& options,
                                            const std::string& gyro_column) {
    ProcedureInput input;
    if (!options.vehicle.empty()) {
        const auto vehicle = loadVehicleOrPreset(options.vehicle);
        if (!vehicle) return tl::make_unexpected(vehicle.error());
        input.vehicle = *vehicle;
    }
    for (const std::string& file : options.inputs) {
        const auto added = looksLikeMission(file) ? addMission(options, file, input)
                                                  : addLog(file, gyro_column, input);
        if (!added) return tl::make_unexpected(added.error());
    }
    return input;
}

}  // namespace hedr::tool
