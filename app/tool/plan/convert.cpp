#include <array>
#include <iostream>
#include <memory>

#include "app/tool/json_line.h"
#include "app/tool/plan/verbs.h"
#include "core/site/placement_export.h"
#include "core/site/placement_file.h"
#include "core/site/plan_copy.h"

namespace hedr::tool {

namespace {

namespace fs = std::filesystem;

struct Options {
    ImageOptions image;
    std::string to;
    std::string out;
    std::string tie;
    bool json = false;
};

using Files = std::vector<fs::path>;  // that were written

Result<Files> toCopy(const PlanImage& plan, PlanCopyKind kind, const std::optional<GeoTie>& tie,
                     const Options& options) {
    ProgressLine line("writing");
    return writePlanCopy({.plan = plan, .geo_tie = tie, .kind = kind, .file = options.out},
                         shownOn(line));
}

Result<Files> toGeoTiff(const PlanImage& plan, const Options& options) {
    if (options.tie.empty() && !plan.geo_tie)
        return fail(ErrorCode::kBadValue, "--tie",
                    "is missing, and " + plan.image_file.string() +
                        " does not say where on the globe it is");
    const auto tie = options.tie.empty() ? Result<GeoTie>(*plan.geo_tie) : parseTie(options.tie);
    if (!tie) return tl::make_unexpected(tie.error());
    return toCopy(plan, PlanCopyKind::kGeoTiff, *tie, options);
}

Result<Files> toRos(const PlanImage& plan, const Options& options) {
    return toCopy(plan, PlanCopyKind::kRosMap, std::nullopt, options);
}

Result<Files> toWorldFile(const PlanImage& plan, const Options& options) {
    return exportWorldFile(plan.placement, plan.levels.front().height_px, options.out).map([&] {
        return Files{options.out};
    });
}

Result<Files> toToml(const PlanImage& plan, const Options& options) {
    return savePlacement({fs::absolute(plan.image_file), plan.placement}, options.out).map([&] {
        return Files{options.out};
    });
}

struct Format {
    const char* name;
    Result<Files> (*write)(const PlanImage& plan, const Options& options);
};

constexpr std::array kFormats{Format{"geotiff", toGeoTiff}, Format{"ros", toRos},
                              Format{"world", toWorldFile}, Format{"toml", toToml}};

std::vector<std::string> formatNames() {
    std::vector<std::string> names;
    names.reserve(kFormats.size());
    for (const Format& format : kFormats) names.emplace_back(format.name);
    return names;
}

Result<void> runConvert(const Options& options) {
    const auto plan = loadPlanWatched(options.image);
    if (!plan) return tl::make_unexpected(plan.error());
    for (const Format& format : kFormats) {
        if (options.to != format.name) continue;
        const auto files =
            refuseOverwriting({plan->image_file, options.image.file}, options.out).and_then([&] {
                return format.write(*plan, options);
            });
        if (!files) return tl::make_unexpected(files.error());
        auto names = nlohmann::ordered_json::array();
        for (const fs::path& file : *files) {
            if (!options.json) std::cout << "wrote      " << file.string() << '\n';
            names.push_back(file.string());
        }
        if (options.json)
            std::cout << jsonLine(
                nlohmann::ordered_json{{"format", format.name}, {"files", names}});
    }
    return {};
}

}  // namespace

Job addPlanConvert(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    addImageOptions(app, options->image);
    app.add_option("--to", options->to,
                   "What to write: " + joined(formatNames()) +
                       " (ros: a yaml and a pgm beside it; world: the six numbers; toml: ours)")
        ->required()
        ->check(oneOf(formatNames()));
    app.add_option("--out", options->out, "The file to write")->required()->check(notEmpty());
    addTieOption(app, options->tie);
    addJsonFlag(app, options->json);
    return [options] { return runConvert(*options); };
}

}  // namespace hedr::tool
