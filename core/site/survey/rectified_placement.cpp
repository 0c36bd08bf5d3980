#include "core/site/survey/rectified_placement.h"

#include <array>
#include <cmath>

#include "core/site/placement_moves.h"

namespace hedr {
namespace {

// The quad in an image.
struct Patch {
    Point<Plan> middle{};
    double area_px2 = 0.0;
    int image_height_px = 0;
};

double area(const std::array<Point<Plan>, 4>& corners) {
    double twice = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        const Point<Plan> a = corners[i];
        const Point<Plan> b = corners[(i + 1) % 4];
        twice += a.x * b.y - b.x * a.y;
    }
    return std::abs(twice) / 2.0;
}

Patch inPhoto(const Quad& quad, int height_px) {
    return {photoFromUnitSquare(quad) * Point<UnitSquare>{0.5, 0.5}, area(quad.corners), height_px};
}

Patch inRectified(const Quad& quad, const Rectification& rectification) {
    // The flat image is a plan's image in its turn.
    const auto flat = [&](Point<Plan> p) {
        const Point<Flat> at = rectification.flat_from_photo * p;
        return Point<Plan>{at.x, at.y};
    };
    std::array<Point<Plan>, 4> corners{};
    for (std::size_t i = 0; i < 4; ++i) corners[i] = flat(quad.corners[i]);
    const Point<Plan> middle = photoFromUnitSquare(quad) * Point<UnitSquare>{0.5, 0.5};
    return {flat(middle), area(corners), rectification.height_px};
}

PlanPlacement replaced(PlanPlacement placement, const Patch& from, const Patch& to) {
    const Point<World> middle = worldFromPlan(placement, from.image_height_px) * from.middle;
    placement.resolution_m *= std::sqrt(from.area_px2 / to.area_px2);
    return movedBy(placement, middle - worldFromPlan(placement, to.image_height_px) * to.middle);
}

}  // namespace

PlanPlacement rectifiedPlacement(const PlanPlacement& photo, int photo_height_px, const Quad& quad,
                                 const Rectification& rectification) {
    return replaced(photo, inPhoto(quad, photo_height_px), inRectified(quad, rectification));
}

PlanPlacement photoPlacement(const PlanPlacement& rectified, int photo_height_px, const Quad& quad,
                             const Rectification& rectification) {
    return replaced(rectified, inRectified(quad, rectification), inPhoto(quad, photo_height_px));
}

}  // namespace hedr
