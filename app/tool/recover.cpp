#include <iostream>
#include <memory>

#include "app/tool/command.h"
#include "core/mission/mission_salvage.h"

namespace hedr::tool {

namespace {

struct Options {
    std::string damaged;
    std::string out;
};

std::string outFor(const Options& options) {
    if (!options.out.empty()) return options.out;
    return recoveredFile(options.damaged).string();
}

Result<void> runRecover(const Options& options) {
    const std::string out = outFor(options);
    const auto report = salvageMission(options.damaged, out);
    if (!report) return tl::make_unexpected(report.error());
    std::cout << out << ": " << describe(*report) << '\n';
    return {};
}

}  // namespace

Job addRecover(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    app.add_option("DAMAGED", options->damaged, "A mission file that cannot be read")->required();
    app.add_option("--out", options->out, "The new mission file; else DAMAGED.recovered.hedr")
        ->check(notEmpty());
    return [options] { return runRecover(*options); };
}

}  // namespace hedr::tool
