#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/geometry/frames.h"
#include "core/site/plan.h"

namespace hedr {

// The part of a plan image that is shown, in plan pixels.
struct PlanCrop {
    Point<Plan> min{};
    Point<Plan> max{};
    friend bool operator==(const PlanCrop&, const PlanCrop&) = default;
};

// One image of a place and how it is shown.
struct SitePlan {
    std::filesystem::path image_file;
    PlanPlacement placement{};
    double opacity = 1.0;
    bool visible = true;
    bool inverted_at_night = true;  // its lightness; off for aerial photos
    std::optional<PlanCrop> crop{};
    friend bool operator==(const SitePlan&, const SitePlan&) = default;
};

// What is known of a place: a value, so that undo keeps old ones.
struct Site {
    std::vector<SitePlan> plans{};  // the lowest first
    friend bool operator==(const Site&, const Site&) = default;
};

}  // namespace hedr
