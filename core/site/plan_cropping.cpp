#include "core/site/plan_cropping.h"

#include <algorithm>
#include <cmath>

#include "core/site/mip_pyramid.h"

namespace hedr {
namespace {

int within(double value, int most) {
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(most)));
}

}  // namespace

PlanPart partOf(const PlanCrop& crop, const PlanLevel& size) {
    const int left = within(std::floor(crop.min.x), size.width_px - 1);
    const int top = within(std::floor(crop.min.y), size.height_px - 1);
    const int right = std::max(left + 1, within(std::ceil(crop.max.x), size.width_px));
    const int bottom = std::max(top + 1, within(std::ceil(crop.max.y), size.height_px));
    return {left, top, right - left, bottom - top};
}

Result<PlanImage> croppedPlan(const PlanImage& image, const PlanPart& part) {
    return readPart(image.levels.front(), part).map([&](const PlanLevel& level) {
        const Point<Plan> lower_left{static_cast<double>(part.left_px),
                                     static_cast<double>(part.top_px + part.height_px)};
        PlanPlacement placement = image.placement;
        placement.origin.position = image.worldFromPlan() * lower_left;
        return PlanImage{image.image_file, mipPyramid(level), placement};
    });
}

Result<PlanImage> shownPlan(const PlanImage& image, const std::optional<PlanCrop>& crop) {
    return crop ? croppedPlan(image, partOf(*crop, image.levels.front()))
                : Result<PlanImage>(image);
}

PlanPlacement placementOfWhole(const PlanPlacement& of_part, const PlanPart& part, int height_px) {
    const Point<Plan> lower_left{static_cast<double>(-part.left_px),
                                 static_cast<double>(height_px - part.top_px)};
    PlanPlacement whole = of_part;
    whole.origin.position = worldFromPlan(of_part, part.height_px) * lower_left;
    return whole;
}

}  // namespace hedr
