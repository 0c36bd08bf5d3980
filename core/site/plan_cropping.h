#pragma once

#include <optional>

#include "core/site/plan.h"
#include "core/site/site.h"

namespace hedr {

// The whole pixels of a crop, within an image of that size.
PlanPart partOf(const PlanCrop& crop, const PlanLevel& size);

// A part of an image as an image of its own, where that part lies. Errors: those of readPart.
Result<PlanImage> croppedPlan(const PlanImage& image, const PlanPart& part);

// What is seen of an image: all of it without a crop. Beside it there may be a table, or a legend.
Result<PlanImage> shownPlan(const PlanImage& image, const std::optional<PlanCrop>& crop);

// Where the part of an image of that height lies.
PlanPlacement placementOfPart(const PlanPlacement& of_whole, const PlanPart& part, int height_px);

// Where the whole image of that height lies, if its part lies there.
PlanPlacement placementOfWhole(const PlanPlacement& of_part, const PlanPart& part, int height_px);

}  // namespace hedr
