#include <charconv>
#include <cstdint>
#include <memory>
#include <optional>
#include <sstream>

#include "app/tool/command.h"
#include "core/simulation/scenario.h"

namespace hedr::tool {

namespace {

struct Options {
    std::string scenario;
    std::string seed;
    std::string out;
    std::vector<std::string> settings;
};

std::optional<std::uint64_t> seedOf(const std::string& text) {
    std::uint64_t seed = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return seed;
}

CLI::Validator aSeed() {
    return CLI::Validator(
        [](const std::string& text) {
            return seedOf(text) ? std::string()
                                : "is \"" + text + "\", must be a whole number from 0 to 2^64-1";
        },
        "", "seed");
}

// The scenario with every --set applied.
Result<Scenario> scenarioOf(const Options& options) {
    auto scenario = scenarioByName(options.scenario);
    for (const std::string& setting : options.settings) {
        if (!scenario) break;
        const auto pair = parseKeyValue(setting);
        if (!pair) return tl::make_unexpected(pair.error());
        const auto set = setScenarioValue(*scenario, pair->key, pair->value);
        if (!set) return tl::make_unexpected(set.error());
    }
    return scenario;
}

Result<void> runSimulate(const Options& options) {
    const auto scenario = scenarioOf(options);
    if (!scenario) return tl::make_unexpected(scenario.error());
    return writeMission(simulate(*scenario, seedOf(options.seed).value()), options.out);
}

std::string listOfScenarios() {
    std::string list;
    for (const ScenarioEntry& entry : scenarioTable()) {
        list += "\n  " + std::string(entry.name) + ": " + std::string(entry.meaning);
    }
    return list;
}

// The packbots' keys are listed once: they share them.
std::string listOfKeys() {
    std::ostringstream list;
    std::size_t kind_before = std::variant_npos;
    for (const ScenarioEntry& entry : scenarioTable()) {
        const Scenario scenario = entry.make();
        if (scenario.index() == kind_before) continue;
        kind_before = scenario.index();
        const bool packbot = std::holds_alternative<PackbotScenario>(scenario);
        list << "\n " << (packbot ? "packbot-..." : entry.name);
        for (const ScenarioKey& key : scenarioKeys(scenario)) {
            list << "\n  " << key.name << ": " << key.meaning << " (default " << key.value << ')';
        }
    }
    return list.str();
}

}  // namespace

Job addSimulate(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    app.add_option("SCENARIO", options->scenario, "One of" + listOfScenarios())
        ->required()
        ->check(aScenario());
    app.add_option("--seed", options->seed, "The same seed gives the same mission, 0 to 2^64-1")
        ->required()
        ->check(aSeed());
    app.add_option("--out", options->out, "Folder to write to")->required()->check(notEmpty());
    app.add_option("--set", options->settings, "KEY=VALUE, one of the scenario's" + listOfKeys())
        ->allow_extra_args(false);
    app.callback([options] {
        const auto scenario = scenarioOf(*options);
        if (!scenario) throw CLI::ValidationError("--set", complaintAbout(scenario.error()));
    });
    return [options] { return runSimulate(*options); };
}

}  // namespace hedr::tool
