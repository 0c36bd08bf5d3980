#pragma once

#include "core/site/plan.h"
#include "core/site/survey/rectification.h"

namespace hedr {

// Where the flat image of a photo lies on the ground, and the photo of a flat image: the quad keeps
// its middle and its area in the world, the image its rotation.
PlanPlacement rectifiedPlacement(const PlanPlacement& photo, int photo_height_px, const Quad& quad,
                                 const Rectification& rectification);
PlanPlacement photoPlacement(const PlanPlacement& rectified, int photo_height_px, const Quad& quad,
                             const Rectification& rectification);

}  // namespace hedr
