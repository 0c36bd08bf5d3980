#include "radio/replay.h"

#include <iostream>
#include <memory>

#include "app/stop_signals.h"
#include "app/tool/command.h"
#include "core/mission/mission_reader.h"
#include "core/robot/sensor_csv.h"
#include "core/text/number.h"

namespace hedr::tool {

namespace {

struct Options {
    std::string input;
    std::string vehicle;
    std::string port;
    std::string pty;
    int baud = 57600;
    double speed = 1.0;
    std::string initial;
    std::vector<std::string> settings;
};

Result<void> setScriptValue(ReplayScript& script, const std::string& key,
                            const std::string& value) {
    if (key != "restart_at_s") return setRadioFault(script.faults, key, value);
    const auto seconds = parseNumber(value);
    if (!seconds || !(*seconds >= 0.0)) {
        return fail(ErrorCode::kBadValue, key, "is \"" + value + "\", must be a time in seconds");
    }
    script.restart_at_s = *seconds;
    return {};
}

Result<ReplayScript> scriptFrom(const Options& options) {
    ReplayScript script{.speed = options.speed};
    for (const std::string& setting : options.settings) {
        const auto pair = parseKeyValue(setting);
        if (!pair) return tl::make_unexpected(pair.error());
        const auto set = setScriptValue(script, pair->key, pair->value);
        if (!set) return tl::make_unexpected(set.error());
    }
    return script;
}

Result<RobotLine> openLine(const Options& options) {
    return options.pty.empty() ? RobotLine::openPort(options.port, options.baud)
                               : RobotLine::openPseudoTerminal(options.pty);
}

void waitForCompany(const RobotLine& line, const std::string& name) {
    if (line.someoneListens()) return;
    std::cerr << "Waiting for a program to open " << name << "\n";
    waitForListener(line, stopSignalled);
}

Result<void> replayLog(const Options& options, const ReplayScript& script) {
    const auto log = loadSensorLog(options.input);
    if (!log) return tl::make_unexpected(log.error());
    const auto vehicle = loadVehicleOrPreset(options.vehicle);
    if (!vehicle) return tl::make_unexpected(vehicle.error());
    const auto start = options.initial.empty() ? Pose<World>{} : parsePose(options.initial);
    if (!start) return tl::make_unexpected(start.error());
    auto line = openLine(options);
    if (!line) return tl::make_unexpected(line.error());
    SimulatedRobot robot(*vehicle, *start);
    waitForCompany(*line, options.pty);
    replayReports(log->reports, robot, *line, script, stopSignalled);
    return {};
}

std::string validSpeed(const std::string& text) {
    const auto speed = parseNumber(text);
    const bool good = speed && *speed >= 0.01 && *speed <= 10000.0;
    return good ? std::string() : "\"" + text + "\" is not from 0.01 to 10000";
}

Result<void> replayRecording(const Options& options, const ReplayScript& script) {
    const auto readable = MissionReader::open(options.input);
    if (!readable) return tl::make_unexpected(readable.error());
    tellDamage(options.input, readable->salvaged());
    auto line = openLine(options);
    if (!line) return tl::make_unexpected(line.error());
    waitForCompany(*line, options.pty);
    return replayMission(options.input, *line, script, stopSignalled);
}

Result<void> runReplay(const Options& options) {
    const auto script = scriptFrom(options);
    if (!script) return tl::make_unexpected(script.error());
    holdStopSignals();
    return looksLikeMission(options.input) ? replayRecording(options, *script)
                                           : replayLog(options, *script);
}

}  // namespace

Job addReplay(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    app.add_option("INPUT", options->input, "sensors.csv or a mission file")->required();
    app.add_option("--vehicle", options->vehicle, vehicleHelp() + "; for a sensors.csv");
    auto* line = app.add_option_group("line", "Where the robot speaks");
    line->add_option("--port", options->port, "A serial device");
    line->add_option("--pty", options->pty, "A link to a new pseudo-terminal");
    line->require_option(1);
    app.add_option("--baud", options->baud, "Of the serial device")->capture_default_str();
    app.add_option("--speed", options->speed, "Times real time")
        ->check(CLI::Validator(validSpeed, "", "speed"))
        ->capture_default_str();
    app.add_option("--initial", options->initial, "X,Y,HEADING_DEG where the robot starts")
        ->check(aPose());
    app.add_option("--set", options->settings,
                   "KEY=VALUE: loss, corrupt, noise, duplicate, truncate, reorder (shares), lump "
                   "(bytes), delay_s, burst_at_s, burst_s, seed, restart_at_s")
        ->allow_extra_args(false)
        ->check(aSetting([](const std::string& key, const std::string& value) {
            ReplayScript script;
            return setScriptValue(script, key, value);
        }));
    app.callback([options] { needVehicleForLog(options->input, options->vehicle); });
    return [options] { return runReplay(*options); };
}

}  // namespace hedr::tool
