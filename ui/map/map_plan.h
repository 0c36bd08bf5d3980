#pragma once

#include <optional>
#include <vector>

#include "core/site/plan.h"
#include "core/site/site.h"

namespace hedr {

// One image below the trails and how it is drawn. Its pixels are shared, so it is cheap to copy.
struct MapPlan {
    PlanImage image;
    double opacity = 1.0;
    bool inverted_at_night = true;
    std::optional<PlanCrop> crop{};
};

}  // namespace hedr
