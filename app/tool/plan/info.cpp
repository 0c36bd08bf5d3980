#include <iostream>
#include <memory>

#include "app/tool/json_line.h"
#include "app/tool/plan/verbs.h"
#include "core/text/file_hash.h"

namespace hedr::tool {

namespace {

struct Options {
    ImageOptions image;
    bool json = false;
};

struct Content {
    PlanDescription file{};
    PlanImage plan{};
    std::string hash{};
};

Result<Content> read(const ImageOptions& image) {
    const auto file = describePlan(image.file, image.choice);
    if (!file) return tl::make_unexpected(file.error());
    const auto plan = loadPlanWatched(image);
    if (!plan) return tl::make_unexpected(plan.error());
    return fileHash(plan->image_file).map([&](const std::string& hash) {
        return Content{*file, *plan, hash};
    });
}

nlohmann::ordered_json toJson(const Content& content) {
    const auto& [file, plan, hash] = content;
    const PlanLevel& pixels = plan.levels.front();
    return {{"image", plan.image_file.string()},
            {"format", file.format},
            {"pages", file.pages.size()},
            {"width_px", pixels.width_px},
            {"height_px", pixels.height_px},
            {"colour", pixels.channels > 1},
            {"placement", tool::toJson(plan.placement)},
            {"geo_tie", tool::toJson(plan.geo_tie)},
            {"sha256", hash}};
}

void print(const Content& content) {
    const auto& [file, plan, hash] = content;
    const PlanLevel& pixels = plan.levels.front();
    const double resolution_m = plan.placement.resolution_m;
    std::cout << "image      " << plan.image_file.string() << "\nformat     " << file.format;
    if (file.pages.size() > 1) std::cout << ", " << file.pages.size() << " pages";
    std::cout << "\nsize       " << pixels.width_px << " x " << pixels.height_px << " pixels, "
              << (pixels.channels > 1 ? "colour" : "grey") << ", " << resolution_m * pixels.width_px
              << " x " << resolution_m * pixels.height_px << " m\n";
    tool::print(plan.placement);
    if (plan.geo_tie) tool::print(*plan.geo_tie);
    std::cout << "sha256     " << hash << '\n';
}

Result<void> runInfo(const Options& options) {
    const auto content = read(options.image);
    if (!content) return tl::make_unexpected(content.error());
    if (options.json) {
        std::cout << jsonLine(toJson(*content));
    } else {
        print(*content);
    }
    return {};
}

}  // namespace

Job addPlanInfo(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    addImageOptions(app, options->image);
    addJsonFlag(app, options->json);
    return [options] { return runInfo(*options); };
}

}  // namespace hedr::tool
