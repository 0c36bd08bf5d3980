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
    const PlanLevel& whole = image.levels.front();
    return readPart(whole, part).map([&](const PlanLevel& level) {
        return PlanImage{image.image_file, mipPyramid(level),
                         placementOfPart(image.placement, part, whole.height_px)};
    });
}

Result<PlanImage> shownPlan(const PlanImage& image, const std::optional<PlanCrop>& crop) {
    return crop ? croppedPlan(image, partOf(*crop, image.levels.front()))
                : Result<PlanImage>(image);
}

PlanPlacement placementOfPart(const PlanPlacement& of_whole, const PlanPart& part, int height_px) {
    const Point<Plan> lower_left{static_cast<double>(part.left_px),
                                 static_cast<double>(part.top_px + part.height_px)};
    PlanPlacement placement = of_whole;
    placement.origin.position = worldFromPlan(of_whole, height_px) * lower_left;
    return placement;
}

PlanPlacement placementOfWhole(const PlanPlacement& of_part, const PlanPart& part, int height_px) {
    const Point<Plan> lower_left{static_cast<double>(-part.left_px),
                                 static_cast<double>(height_px - part.top_px)};
    PlanPlacement whole = of_part;
    whole.origin.position = worldFromPlan(of_part, part.height_px) * lower_left;
    return whole;
}

}  // namespace hedr
