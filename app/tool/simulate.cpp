#include <cstdint>
#include <memory>

#include "app/tool/command.h"
#include "core/simulation/scenario.h"

namespace hedr::tool {

namespace {

struct Options {
    std::string scenario;
    std::uint64_t seed = 1;
    std::string out;
    std::vector<std::string> settings;
};

Result<void> runSimulate(const Options& options) {
    auto scenario = scenarioByName(options.scenario);
    if (!scenario) return tl::make_unexpected(scenario.error());
    for (const std::string& setting : options.settings) {
        const auto pair = parseKeyValue(setting);
        if (!pair) return tl::make_unexpected(pair.error());
        const auto set = setScenarioValue(*scenario, pair->key, pair->value);
        if (!set) return tl::make_unexpected(set.error());
    }
    return writeMission(simulate(*scenario, options.seed), options.out);
}

}  // namespace

Job addSimulate(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    app.add_option("SCENARIO", options->scenario, "For example packbot-corridors")
        ->required()
        ->check(aScenario());
    app.add_option("--seed", options->seed, "The same seed gives the same mission")->required();
    app.add_option("--out", options->out, "Folder to write to")->required()->check(notEmpty());
    app.add_option("--set", options->settings, "KEY=VALUE, changes the scenario")
        ->allow_extra_args(false)
        ->check(aSetting([](const std::string& key, const std::string& value) {
            Scenario scenario;
            return setScenarioValue(scenario, key, value);
        }));
    return [options] { return runSimulate(*options); };
}

}  // namespace hedr::tool
