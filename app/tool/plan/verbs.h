#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/tool/command.h"
#include "core/site/geo_tie.h"
#include "core/site/plan.h"

namespace hedr::tool {

// The words after `hedr plan`.
Job addPlanInfo(CLI::App& app);
Job addPlanAlign(CLI::App& app);
Job addPlanConvert(CLI::App& app);

void addImageOption(CLI::App& app, std::string& image);
void addJsonFlag(CLI::App& app, bool& json);
// --tie LATITUDE,LONGITUDE,BEARING_DEG: where the world's origin is on the globe.
void addTieOption(CLI::App& app, std::string& tie);

// Errors: kBadValue.
Result<GeoTie> parseTie(const std::string& text);

// With a line on the terminal that says how far it is. Errors: those of loadPlan.
Result<PlanImage> loadPlanWatched(const std::string& file);

nlohmann::ordered_json toJson(const PlanPlacement& placement);
nlohmann::ordered_json toJson(const std::optional<GeoTie>& tie);
void print(const PlanPlacement& placement);
void print(const GeoTie& tie);

// Errors, kFileUnwritable: what is read must not be written over.
Result<void> refuseOverwriting(const std::filesystem::path& read,
                               const std::filesystem::path& written);

}  // namespace hedr::tool
