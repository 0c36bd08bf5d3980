#pragma once

#include <optional>
#include <vector>

#include "core/site/plan.h"
#include "core/site/survey/perspective.h"
#include "core/site/survey/quad.h"
#include "core/site/survey/sheet_aspect.h"

namespace hedr {

struct Flat {};  // pixels of a rectified photo, x right, y down, (0, 0) the outer top left corner

// How a photo of a plan becomes a plan: known before a pixel is touched, so that a preview can
// follow the corners. What the photo shows around the quad is kept as a margin, as far as it is
// not stretched too much.
struct Rectification {
    Perspective<Flat, Plan> flat_from_photo{};
    int width_px = 0;  // of the rectified image
    int height_px = 0;
    SheetAspect aspect{};  // of the quad's rectangle
};

// `aspect` is the width / height of the rectangle where it is known (a sheet's format); else it is
// recovered from the perspective, with the focal length that the photo's file says. The longest
// side of the quad keeps its length in pixels. Errors, kBadValue: a quad that checkQuad refuses, an
// aspect that is no number within 1/50..50, a photo without pixels.
Result<Rectification> rectificationOf(int photo_width_px, int photo_height_px, const Quad& quad,
                                      std::optional<double> aspect = {},
                                      const std::optional<FocalLength>& focal_length = {});

// The rectified photo, white beyond its edges; grey stays grey.
// Errors: kImageTooLarge, kCanceled, those of readWhole.
Result<PlanLevel> rectified(const PlanLevel& photo, const Rectification& rectification,
                            const PlanProgress& progress = {});
Result<PlanLevel> rectified(const PlanLevel& photo, const Quad& quad,
                            std::optional<double> aspect = {}, const PlanProgress& progress = {});

// The same in small, at most `most_px` wide and high, from those levels of a pyramid that are in
// memory; empty where none is.
PlanLevel rectifiedPreview(const std::vector<PlanLevel>& photo_levels,
                           const Rectification& rectification, int most_px);

}  // namespace hedr
