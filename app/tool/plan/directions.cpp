#include "core/site/survey/directions.h"

#include <iostream>
#include <memory>

#include "app/tool/json_line.h"
#include "app/tool/plan/verbs.h"
#include "core/geometry/angle.h"

namespace hedr::tool {

namespace {

struct Options {
    ImageOptions image;
    bool json = false;
};

nlohmann::ordered_json toJson(const PlanDirections& found) {
    nlohmann::ordered_json object{{"direction_deg", nullptr},
                                  {"sigma_deg", nullptr},
                                  {"confidence", found.confidence},
                                  {"share", found.share}};
    if (found.direction_rad) {
        object["direction_deg"] = degFromRad(*found.direction_rad);
        object["sigma_deg"] = degFromRad(found.sigma_rad);
    }
    return object;
}

void print(const PlanDirections& found) {
    std::cout << "direction  ";
    if (found.direction_rad) {
        std::cout << degFromRad(*found.direction_rad) << " deg +-" << degFromRad(found.sigma_rad)
                  << ", counter-clockwise from the image's right, and every 90 deg\n";
    } else {
        std::cout << "no dominant direction\n";
    }
    std::cout << "confidence " << found.confidence << "\nshare      " << 100.0 * found.share
              << " % of the lines' length\n";
}

Result<PlanDirections> directionsOf(const PlanImage& plan) {
    ProgressLine line("looking");
    return findDirections(plan, shownOn(line));
}

Result<void> runDirections(const Options& options) {
    const auto plan = loadPlanWatched(options.image);
    if (!plan) return tl::make_unexpected(plan.error());
    const auto found = directionsOf(*plan);
    if (!found) return tl::make_unexpected(found.error());
    if (options.json) {
        std::cout << jsonLine(toJson(*found));
    } else {
        print(*found);
    }
    return {};
}

}  // namespace

Job addPlanDirections(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    addImageOptions(app, options->image);
    addJsonFlag(app, options->json);
    return [options] { return runDirections(*options); };
}

}  // namespace hedr::tool
