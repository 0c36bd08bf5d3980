#include "app/tool/command.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/geometry/angle.h"
#include "core/simulation/scenario.h"
#include "core/text/clean_text.h"
#include "core/text/number.h"
#include "radio/robot_key.h"
#include "ui/error_text.h"

namespace hedr::tool {

Job addVerbs(CLI::App& app, const std::vector<Verb>& verbs) {
    app.require_subcommand(1);
    std::vector<std::pair<CLI::App*, Job>> jobs;
    for (const Verb& verb : verbs) {
        CLI::App* sub = app.add_subcommand(verb.name, verb.description);
        jobs.emplace_back(sub, verb.add(*sub));
    }
    return [jobs = std::move(jobs)]() -> Result<void> {
        for (const auto& [sub, job] : jobs) {
            if (sub->parsed()) return job();
        }
        return {};
    };
}

Result<KeyValue> parseKeyValue(const std::string& text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
        return fail(ErrorCode::kBadValue, "--set", "is \"" + text + "\", must be KEY=VALUE");
    }
    return KeyValue{text.substr(0, equals), text.substr(equals + 1)};
}

Result<Pose<World>> parsePose(const std::string& text) {
    std::array<double, 3> numbers{};
    const char* at = text.data();
    const char* const end = text.data() + text.size();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto parsed = std::from_chars(at, end, numbers[i]);
        const bool last = i + 1 == numbers.size();
        const bool ended_well = last ? parsed.ptr == end : parsed.ptr != end && *parsed.ptr == ',';
        if (parsed.ec != std::errc{} || !ended_well || !std::isfinite(numbers[i])) {
            return fail(ErrorCode::kBadValue, "--initial",
                        "is \"" + text + "\", must be X,Y,HEADING_DEG, for example 1.5,2,90");
        }
        at = parsed.ptr + 1;
    }
    return Pose<World>{{numbers[0], numbers[1]}, radFromDeg(numbers[2])};
}

void warn(const Error& warning) {
    std::cerr << "hedr: " << errorText(warning).toStdString() << '\n';
}

void tellDamage(const std::string& mission, const std::optional<SalvageReport>& salvaged) {
    if (salvaged) warn({ErrorCode::kMissionIncomplete, mission, describe(*salvaged)});
}

bool looksLikeMission(const std::string& file) {
    constexpr std::string_view kMagic{"SQLite format 3"};
    std::error_code ignored;
    // Whether it is one indeed is its reader's to tell.
    if (file.ends_with(".hedr") && std::filesystem::exists(file, ignored)) return true;
    // What has been read from a pipe is gone.
    if (!std::filesystem::is_regular_file(file, ignored)) return false;
    std::array<char, kMagic.size()> head{};
    std::ifstream stream(file, std::ios::binary);
    stream.read(head.data(), head.size());
    return stream && std::string_view(head.data(), head.size()) == kMagic;
}

namespace {

// CLI11 wants an empty text for a good value.
template <class T>
std::string complaint(const Result<T>& result) {
    return result ? std::string() : complaintAbout(result.error());
}

}  // namespace

CLI::Validator notEmpty() {
    return CLI::Validator(
        [](const std::string& text) { return std::string(text.empty() ? "is empty" : ""); }, "",
        "not empty");
}

CLI::Validator aName() {
    return CLI::Validator(
        [](const std::string& text) {
            constexpr std::size_t kLongest = 60;
            if (text.empty()) return std::string("is empty");
            if (text.starts_with("--")) return "looks like an option: " + text;
            if (text.size() > kLongest) return std::string("is longer than 60 letters");
            return std::string(cleanText(text) == text ? "" : "must be one line of UTF-8");
        },
        "", "name");
}

CLI::Validator aFiniteNumber() {
    return CLI::Validator(
        [](const std::string& text) {
            const auto value = parseNumber(text);
            return std::string(value && std::isfinite(*value) ? "" : "must be a number");
        },
        "", "finite");
}

CLI::Validator aboveNought() {
    return CLI::Validator(
        [](const std::string& text) {
            const auto value = parseNumber(text);
            const bool above = value && std::isfinite(*value) && *value > 0.0;
            return std::string(above ? "" : "must be a number above 0");
        },
        "", "above 0");
}

CLI::Validator aPose() {
    return CLI::Validator([](const std::string& text) { return complaint(parsePose(text)); }, "",
                          "pose");
}

CLI::Validator oneOf(std::vector<std::string> names) {
    return CLI::Validator(
        [names = std::move(names)](const std::string& name) {
            const bool known = std::find(names.begin(), names.end(), name) != names.end();
            return known ? std::string() : "\"" + name + "\" is none of " + joined(names);
        },
        "", "one of them");
}

CLI::Validator aScenario() {
    return CLI::Validator([](const std::string& name) { return complaint(scenarioByName(name)); },
                          "", "scenario");
}

CLI::Validator aSetting(std::function<Result<void>(const std::string&, const std::string&)> check) {
    return CLI::Validator(
        [check = std::move(check)](const std::string& text) {
            const auto pair = parseKeyValue(text);
            return pair ? complaint(check(pair->key, pair->value)) : complaint(pair);
        },
        "", "setting");
}

std::vector<std::string> estimatorNames() {
    std::vector<std::string> names;
    for (const EstimatorEntry& entry : estimatorTable()) names.emplace_back(entry.name);
    return names;
}

std::string joined(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    return list;
}

std::string vehicleHelp() {
    std::vector<std::string> presets;
    for (const Vehicle& preset : vehiclePresets()) presets.push_back(preset.name);
    return "vehicle.toml, or a preset: " + joined(presets);
}

std::string complaintAbout(const Error& error) {
    if (error.code != ErrorCode::kBadValue) return errorText(error).toStdString();
    const bool option = error.subject.starts_with("--");
    return option ? error.detail : error.subject + " " + error.detail;
}

void needVehicleForLog(const std::string& input, const std::string& vehicle) {
    std::error_code ignored;
    // What is not there is the work's to tell.
    if (!std::filesystem::exists(input, ignored)) return;
    if (vehicle.empty() && !looksLikeMission(input)) throw CLI::RequiredError("--vehicle");
}

Result<RobotKey> loadKeyNamed(const std::string& name_or_file) {
    const bool is_file =
        name_or_file.ends_with(".key") || name_or_file.find('/') != std::string::npos;
    return loadKey(is_file ? std::filesystem::path(name_or_file)
                           : keyFileOf(defaultKeyFolder(), name_or_file));
}

EstimatorInputs inputsOf(const SensorLog& log, const Vehicle& vehicle) {
    EstimatorInputs given = hedr::inputsOf(vehicle);
    // A value need not come with every row.
    for (const SensorReport& report : log.reports) {
        given.gyro = given.gyro || !std::holds_alternative<std::monostate>(report.gyro);
        given.both_wheels =
            given.both_wheels || (!std::holds_alternative<std::monostate>(report.odometry) &&
                                  !std::holds_alternative<PathTravel>(report.odometry));
        given.magnetometer = given.magnetometer || report.magnetic_field.has_value();
    }
    return given;
}

Result<void> checkInputs(const EstimatorEntry& entry, const FromFile<SensorLog>& log,
                         const FromFile<Vehicle>& vehicle) {
    const auto missing = missingInput(entry.needs, inputsOf(log.content, vehicle.content));
    if (!missing) return {};
    const std::string what =
        std::string(missing->what) + ", which " + std::string(entry.name) + " needs";
    if (missing->in_vehicle) return fail(ErrorCode::kMissingKey, vehicle.file, what);
    return fail(ErrorCode::kNoData, log.file, "it has " + what);
}

Result<FusionConfig> fusionConfig(const Vehicle& vehicle,
                                  const std::vector<std::string>& settings) {
    FusionConfig config = fusionPreset(vehicle);
    for (const std::string& setting : settings) {
        const auto pair = parseKeyValue(setting);
        if (!pair) return tl::make_unexpected(pair.error());
        const auto set = setFusionValue(config, pair->key, pair->value);
        if (!set) return tl::make_unexpected(set.error());
    }
    return config;
}

}  // namespace hedr::tool
