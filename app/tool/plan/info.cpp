#include <iostream>
#include <memory>

#include "app/tool/plan/verbs.h"
#include "core/site/image_hash.h"

namespace hedr::tool {

namespace {

struct Options {
    std::string image;
    bool json = false;
};

Result<void> runInfo(const Options& options) {
    const auto plan = loadPlanWatched(options.image);
    if (!plan) return tl::make_unexpected(plan.error());
    const auto hash = imageHash(plan->image_file);
    if (!hash) return tl::make_unexpected(hash.error());
    const PlanLevel& pixels = plan->levels.front();
    if (options.json) {
        const nlohmann::ordered_json object{
            {"image", plan->image_file.string()},   {"width_px", pixels.width_px},
            {"height_px", pixels.height_px},        {"colour", pixels.channels > 1},
            {"placement", toJson(plan->placement)}, {"sha256", *hash}};
        std::cout << object.dump() << '\n';
        return {};
    }
    const double resolution_m = plan->placement.resolution_m;
    std::cout << "image      " << plan->image_file.string() << "\nsize       " << pixels.width_px
              << " x " << pixels.height_px << " pixels, "
              << (pixels.channels > 1 ? "colour" : "grey") << ", " << resolution_m * pixels.width_px
              << " x " << resolution_m * pixels.height_px << " m\n";
    print(plan->placement);
    std::cout << "sha256     " << *hash << '\n';
    return {};
}

}  // namespace

Job addPlanInfo(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    addImageOption(app, options->image);
    addJsonFlag(app, options->json);
    return [options] { return runInfo(*options); };
}

}  // namespace hedr::tool
