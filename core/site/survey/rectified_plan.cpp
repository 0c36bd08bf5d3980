#include "core/site/survey/rectified_plan.h"

#include "core/site/mip_pyramid.h"
#include "core/site/survey/rectification.h"
#include "core/site/survey/rectified_placement.h"

namespace hedr {

Result<PlanImage> rectifiedPlan(const PlanImage& photo, const Straightening& straightening,
                                const PlanProgress& progress) {
    const auto pixels = readWhole(photo.levels.front());
    if (!pixels) return tl::make_unexpected(pixels.error());
    const auto how = rectificationOf(pixels->width_px, pixels->height_px, straightening.quad,
                                     straightening.aspect, photo.focal_length);
    if (!how) return tl::make_unexpected(how.error());
    return rectified(*pixels, *how, progress).map([&](const PlanLevel& flat) {
        return PlanImage{.image_file = photo.image_file,
                         .levels = mipPyramid(flat),
                         .placement = rectifiedPlacement(photo.placement, pixels->height_px,
                                                         straightening.quad, *how),
                         .placement_is_guess = photo.placement_is_guess};
    });
}

}  // namespace hedr
