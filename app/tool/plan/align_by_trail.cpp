#include "app/tool/plan/align_by_trail.h"

#include <cmath>
#include <iomanip>
#include <iostream>
#include <vector>

#include "app/tool/json_line.h"
#include "core/geometry/angle.h"
#include "core/site/survey/trail_placement.h"
#include "core/site/survey/walls.h"
#include "core/track/track_file.h"

namespace hedr::tool {

namespace {

Result<std::vector<Point<World>>> loadTrail(const std::string& file) {
    return loadTrack(file).map([](const std::vector<TrackPoint>& track) {
        std::vector<Point<World>> trail;
        trail.reserve(track.size());
        for (const TrackPoint& point : track) trail.push_back(point.pose.position);
        return trail;
    });
}

Result<PlanImage> loadScaled(const ImageOptions& image, const TrailOptions& options) {
    return loadPlanWatched(image).map([&](PlanImage plan) {
        plan.placement.resolution_m = options.resolution_m.value_or(plan.placement.resolution_m);
        return plan;
    });
}

Result<TrailPlacements> placementsOf(const PlanImage& plan,
                                     const std::vector<Point<World>>& trail) {
    ProgressLine line("placing");
    constexpr double kShareOfWalls = 0.2;  // of the time
    const PlanProgress shown = shownOn(line);
    const auto space =
        freeSpaceOf(plan, [&](double share) { return shown(kShareOfWalls * share); });
    if (!space) return tl::make_unexpected(space.error());
    return placeByTrail(
        *space, plan.placement, plan.levels.front().height_px, trail,
        [&](double share) { return shown(kShareOfWalls + (1.0 - kShareOfWalls) * share); });
}

// The complaint is about one of the two files; the engine knows neither.
Error inFile(Error error, const std::string& plan, const std::string& trail) {
    if (error.subject == "trail") error.subject = trail;
    if (error.subject == "plan") error.subject = plan;
    return error;
}

nlohmann::ordered_json toJson(const TrailPlacements& found, std::size_t pick) {
    auto all = nlohmann::ordered_json::array();
    for (const TrailPlacement& each : found.best)
        all.push_back({{"score", each.score}, {"placement", tool::toJson(each.placement)}});
    return {{"placement", tool::toJson(found.best[pick - 1].placement)},
            {"score", found.best[pick - 1].score},
            {"picked", pick},
            {"ambiguous", found.ambiguous},
            {"placements", all}};
}

void print(const TrailPlacements& found, std::size_t pick) {
    tool::print(found.best[pick - 1].placement);
    std::cout << std::fixed << std::setprecision(2);
    for (std::size_t i = 0; i < found.best.size(); ++i) {
        const auto& [placement, score] = found.best[i];
        const auto& [corner, heading_rad] = placement.origin;
        std::cout << "fit " << i + 1 << "      score " << score << ", corner at " << corner.x
                  << ", " << corner.y << " m, turned " << degFromRad(heading_rad) << " deg"
                  << (i + 1 == pick ? ", picked\n" : "\n");
    }
    if (!found.ambiguous) return;
    std::cout << "ambiguous  several fit about equally well: look at each on the map and take it "
                 "with --pick N, or drive on to where the building differs\n";
}

}  // namespace

CLI::Option* addTrailOptions(CLI::App& app, TrailOptions& options) {
    auto* trail = app.add_option("--trail", options.file,
                                 "Instead of points: the path that was driven on this plan, CSV or "
                                 "TUM; some 20 m with a turn at least");
    app.add_option("--resolution", options.resolution_m,
                   "Metres per pixel, for --trail on a plan that does not say it")
        ->check(positiveNumber())
        ->needs(trail);
    app.add_option("--pick", options.pick,
                   "Which of the placements found by --trail to take; 1, the best, unless told")
        ->check(positiveNumber())
        ->needs(trail);
    return trail;
}

Result<void> alignByTrail(const ImageOptions& image, const TrailOptions& options,
                          const std::string& out, bool json) {
    const auto trail = loadTrail(options.file);
    if (!trail) return tl::make_unexpected(trail.error());
    const auto plan = loadScaled(image, options);
    if (!plan) return tl::make_unexpected(plan.error());
    const auto found = placementsOf(*plan, *trail);
    if (!found) return tl::make_unexpected(inFile(found.error(), image.file, options.file));
    if (options.pick > found->best.size()) {
        return fail(ErrorCode::kBadValue, "--pick",
                    "is " + std::to_string(options.pick) + ", but only " +
                        std::to_string(found->best.size()) + " places were found");
    }
    auto saved = saveFoundPlace(*plan, found->best[options.pick - 1].placement,
                                {image.file, options.file}, out);
    if (!saved) return saved;
    if (json) {
        std::cout << jsonLine(toJson(*found, options.pick));
    } else {
        print(*found, options.pick);
    }
    return {};
}

}  // namespace hedr::tool
