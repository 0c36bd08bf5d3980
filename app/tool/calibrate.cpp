#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/tool/calibrate/verbs.h"
#include "core/text/text_file.h"

namespace hedr::tool {

namespace {

struct ProcedureOptions {
    CalibrateOptions common{};
    ProcedureSettings settings{};
    std::string gyro_column = kGyroColumn;
    std::string ends{};
};

Result<std::vector<UmbmarkEnd>> loadEnds(const std::string& file) {
    return readTextFile(file).and_then(
        [&](const std::string& csv) { return parseUmbmarkEnds(csv, file); });
}

Result<void> runProcedure(const Procedure& procedure, const ProcedureOptions& options) {
    auto input = loadCalibrationInput(options.common, options.gyro_column);
    if (!input) return tl::make_unexpected(input.error());
    input->settings = options.settings;
    if (!options.ends.empty()) {
        auto ends = loadEnds(options.ends);
        if (!ends) return tl::make_unexpected(ends.error());
        input->settings.ends = std::move(*ends);
    }
    return finishCalibration(options.common, *input, procedure.run(*input));
}

void addSetting(CLI::App& app, ProcedureSetting setting, ProcedureOptions& options) {
    ProcedureSettings& settings = options.settings;
    switch (setting) {
        case ProcedureSetting::kTurns:
            app.add_option("--turns", settings.turns, "Whole turns of each stretch of turning")
                ->check(aboveNought());
            break;
        case ProcedureSetting::kClosed:
            app.add_flag("--closed", settings.closed, "Each record ended heading as it began");
            break;
        case ProcedureSetting::kPushed:
            app.add_option("--distance", settings.distance_m,
                           "Metres that it was pushed, negative: backwards; 1 if not told")
                ->check(aFiniteNumber());
            break;
        case ProcedureSetting::kOnBefore:
            app.add_option("--on-before-s", settings.on_before_s,
                           "Seconds from switching the gyro on to the first reading")
                ->check(aFiniteNumber())
                ->check(CLI::NonNegativeNumber);
            break;
        case ProcedureSetting::kRoomChanges:
            app.add_flag("--room-changes", settings.room_changes,
                         "The room's temperature may change meanwhile: takes about twice as long");
            break;
        case ProcedureSetting::kEnds:
            app.add_option(
                   "--ends", options.ends,
                   "Where the squares ended by tape: a CSV with run, x_m (along the first side), "
                   "y_m (to its left) and, if wanted, direction")
                ->required();
            break;
        case ProcedureSetting::kSpun:
            app.add_option("--turns", settings.turns,
                           "Turns that it was spun, negative: clockwise; 1 if not told")
                ->check(aFiniteNumber());
            break;
        case ProcedureSetting::kClosedDrives:
            app.add_flag("--closed", settings.closed,
                         "Each record is a drive that ended where it began, heading as it began");
            break;
        case ProcedureSetting::kStraightRuns:
            app.add_option("--distance", settings.distance_m,
                           "Each record is straight runs of so many metres: finds the wheels' size")
                ->check(aboveNought())
                ->excludes("--closed");
            break;
    }
}

Job addProcedure(CLI::App& app, const Procedure& procedure) {
    const auto options = std::make_shared<ProcedureOptions>();
    addCalibrateOptions(app, options->common);
    if (procedure.name == "allan") {
        app.add_option("--gyro-column", options->gyro_column,
                       "Of a sensors.csv: the rate about another axis")
            ->capture_default_str();
    }
    for (const ProcedureSetting setting : procedure.settings) {
        addSetting(app, setting, *options);
    }
    return [options, &procedure] { return runProcedure(procedure, *options); };
}

}  // namespace

Job addCalibrate(CLI::App& app) {
    std::vector<Verb> verbs;
    verbs.reserve(procedures().size());
    for (const Procedure& procedure : procedures()) {
        verbs.push_back({std::string(procedure.name), std::string(procedure.purpose),
                         [&procedure](CLI::App& sub) { return addProcedure(sub, procedure); }});
    }
    const std::vector<Verb> about_history{
        {"history", "List the calibrations of a robot", addCalibrateHistory},
        {"compare", "Say in which numbers two of them differ", addCalibrateCompare},
        {"restore", "Give the vehicle file the numbers of an earlier one", addCalibrateRestore},
        {"export", "Copy one of them with its samples", addCalibrateExport},
        {"surfaces", "List the wheels as they were found on each floor", addCalibrateSurfaces},
        {"use-surface", "Give the vehicle file the wheels of a floor", addCalibrateUseSurface}};
    verbs.insert(verbs.end(), about_history.begin(), about_history.end());
    return addVerbs(app, verbs);
}

}  // namespace hedr::tool
