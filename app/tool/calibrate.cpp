#include <algorithm>
#include <array>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "app/tool/calibrate/verbs.h"
#include "core/calibration/procedures.h"

namespace hedr::tool {

namespace {

struct ProcedureOptions {
    CalibrateOptions common{};
    ProcedureSettings settings{};
    std::string gyro_column = kGyroColumn;
};

Result<void> runProcedure(const Procedure& procedure, const ProcedureOptions& options) {
    auto input = loadCalibrationInput(options.common, options.gyro_column);
    if (!input) return tl::make_unexpected(input.error());
    const Calibration calibration = procedure.run(
        {.sets = input->logs, .vehicle = input->vehicle, .settings = options.settings});
    return finishCalibration(options.common, *input, calibration);
}

Job addProcedure(CLI::App& app, const Procedure& procedure) {
    const auto options = std::make_shared<ProcedureOptions>();
    addCalibrateOptions(app, options->common);
    if (procedure.name == "allan") {
        app.add_option("--gyro-column", options->gyro_column,
                       "Of a sensors.csv: the rate about another axis")
            ->capture_default_str();
    }
    return [options, &procedure] { return runProcedure(procedure, *options); };
}

struct HistoryVerb {
    const char* name;
    const char* description;
    Job (*add)(CLI::App& app);
};

constexpr std::array kHistoryVerbs{
    HistoryVerb{"history", "List the calibrations of a robot", addCalibrateHistory},
    HistoryVerb{"compare", "Say in which numbers two of them differ", addCalibrateCompare},
    HistoryVerb{"restore", "Give the vehicle file the numbers of an earlier one",
                addCalibrateRestore},
    HistoryVerb{"export", "Copy one of them with its samples", addCalibrateExport},
};

}  // namespace

Job addCalibrate(CLI::App& app) {
    app.require_subcommand(1);
    std::vector<std::pair<CLI::App*, Job>> jobs;
    for (const Procedure& procedure : procedures()) {
        CLI::App* sub =
            app.add_subcommand(std::string(procedure.name), std::string(procedure.purpose));
        jobs.emplace_back(sub, addProcedure(*sub, procedure));
    }
    for (const HistoryVerb& verb : kHistoryVerbs) {
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

}  // namespace hedr::tool
