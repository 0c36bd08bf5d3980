#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/tool/command.h"
#include "app/tool/progress_line.h"
#include "core/site/geo_tie.h"
#include "core/site/plan.h"

namespace hedr::tool {

// The words after `hedr plan`.
Job addPlanInfo(CLI::App& app);
Job addPlanDirections(CLI::App& app);
Job addPlanAlign(CLI::App& app);
Job addPlanConvert(CLI::App& app);
Job addPlanRectify(CLI::App& app);

// The image that a verb works on.
struct ImageOptions {
    std::string file;
    PlanChoice choice{};
};
void addImageOptions(CLI::App& app, ImageOptions& image);
void addJsonFlag(CLI::App& app, bool& json);
// Numbers with a comma between them; none where it is anything else.
std::vector<double> parseNumbers(const std::string& text);

// --tie LATITUDE,LONGITUDE,BEARING_DEG: where the world's origin is on the globe.
CLI::Option* addTieOption(CLI::App& app, std::string& tie);

// Errors: kBadValue.
Result<GeoTie> parseTie(const std::string& text);

// Tells a line on the terminal how far a work is.
PlanProgress shownOn(ProgressLine& line);

// With such a line. Errors: those of loadPlan.
Result<PlanImage> loadPlanWatched(const ImageOptions& image);

nlohmann::ordered_json toJson(const PlanPlacement& placement);
nlohmann::ordered_json toJson(const std::optional<GeoTie>& tie);
void print(const PlanPlacement& placement);
void print(const GeoTie& tie);

// A number that is positive and finite, for options.
CLI::Validator positiveNumber();

// Writes a plan.toml for where that image was found to lie; nothing where `out` is empty. `read`
// are the files that told it. Errors: those of refuseOverwriting and savePlacement.
Result<void> saveFoundPlace(const PlanImage& plan, const PlanPlacement& found,
                            std::vector<std::filesystem::path> read, const std::string& out);

}  // namespace hedr::tool
