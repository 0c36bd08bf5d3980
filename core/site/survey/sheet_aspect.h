#pragma once

#include <optional>

#include "core/site/focal_length.h"
#include "core/site/survey/quad.h"

namespace hedr {

// Width / height of the rectangle that a photo shows as a quad.
struct SheetAspect {
    double value = 1.0;
    double sigma = 0.0;  // one standard deviation, as a share of the value
};

// Recovers the rectangle's shape from the perspective, for a quad that passes checkQuad.
// Z. Zhang, L.-W. He, Whiteboard scanning and image enhancement (Digital Signal Processing 17,
// 2007): sides at right angles tell the focal length, and that the sides' true lengths.
// Differs from the paper: the focal length is known beforehand, from the photo's file or as that of
// a phone, and both are weighted by how sure they are: tilted about one side of the sheet only, the
// photo itself tells nothing of it.
SheetAspect sheetAspect(const Quad& quad, int photo_width_px, int photo_height_px,
                        const std::optional<FocalLength>& focal_length = {});

}  // namespace hedr
