#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/fusion/estimators.h"
#include "core/mission/mission_salvage.h"
#include "core/result.h"
#include "core/robot/sensor_csv.h"
#include "core/robot/vehicle.h"
#include "radio/wire/signing/key_text.h"

namespace hedr::tool {

// A subcommand registers its options and gives back what it does once they are parsed.
using Job = std::function<Result<void>()>;

// A word of the command line and what it does.
struct Verb {
    std::string name;
    std::string description;
    std::function<Job(CLI::App& app)> add;
};
// Adds them to `app`, of which one must be given; the job does what that one does.
Job addVerbs(CLI::App& app, const std::vector<Verb>& verbs);

Job addSimulate(CLI::App& app);
Job addFuse(CLI::App& app);
Job addEvaluate(CLI::App& app);
Job addReproduce(CLI::App& app);
Job addTune(CLI::App& app);
Job addReplay(CLI::App& app);
Job addRecord(CLI::App& app);
Job addInfo(CLI::App& app);
Job addRecover(CLI::App& app);
Job addPlan(CLI::App& app);
Job addKey(CLI::App& app);
Job addCalibrate(CLI::App& app);

// Wrong usage is found while the command line is parsed (exit code 2), everything else when the job
// runs (exit code 1).
CLI::Validator notEmpty();
CLI::Validator aName();  // one line of UTF-8, short, no option that went astray
CLI::Validator aFiniteNumber();
CLI::Validator aboveNought();  // a number
CLI::Validator aPose();
CLI::Validator oneOf(std::vector<std::string> names);
CLI::Validator aScenario();
// `check` says of each KEY=VALUE whether it can be used.
CLI::Validator aSetting(std::function<Result<void>(const std::string&, const std::string&)> check);

std::vector<std::string> estimatorNames();
std::string joined(const std::vector<std::string>& names);  // for help and complaints
std::string vehicleHelp();                                  // what --vehicle takes
// One sentence about a value that the command line names already.
std::string complaintAbout(const Error& error);

// "KEY=VALUE" as given with --set. Errors: kBadValue without an "=".
struct KeyValue {
    std::string key;
    std::string value;
};
Result<KeyValue> parseKeyValue(const std::string& text);

// "X,Y,HEADING_DEG". Errors: kBadValue.
Result<Pose<World>> parsePose(const std::string& text);

// A file where it looks like one, else the name of a key in the folder of keys. Errors: those of
// loadKey.
Result<RobotKey> loadKeyNamed(const std::string& name_or_file);

// On standard error: what the user has to know while the work goes on.
void warn(const Error& warning);

// A warning, where a mission is damaged and what is left of it is used.
void tellDamage(const std::string& mission, const std::optional<SalvageReport>& salvaged);

// True for what is called NAME.hedr, and for an SQLite file, which a mission is.
bool looksLikeMission(const std::string& file);

// Wrong usage (CLI::ParseError) where a sensor log is given without a vehicle: a log says nothing
// of its robot, a mission does.
void needVehicleForLog(const std::string& input, const std::string& vehicle);

// What log and vehicle give to the estimators.
EstimatorInputs inputsOf(const SensorLog& log, const Vehicle& vehicle);

template <class T>
struct FromFile {
    const std::string& file;
    const T& content;
};
// Errors: kNoData, kMissingKey: the first thing that the estimator needs and does not get.
Result<void> checkInputs(const EstimatorEntry& entry, const FromFile<SensorLog>& log,
                         const FromFile<Vehicle>& vehicle);

// The vehicle's preset with every --set applied.
Result<FusionConfig> fusionConfig(const Vehicle& vehicle, const std::vector<std::string>& settings);

}  // namespace hedr::tool
