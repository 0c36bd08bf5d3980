#pragma once

#include "core/site/survey/quad.h"

namespace hedr {

// Width / height of the rectangle that a photo shows as a quad.
struct SheetAspect {
    double value = 1.0;
    double sigma = 0.0;  // one standard deviation, as a share of the value
};

// Recovers the rectangle's shape from the perspective alone, for a quad that passes checkQuad.
// Z. Zhang, L.-W. He, Whiteboard scanning and image enhancement (Digital Signal Processing 17,
// 2007): sides at right angles tell the focal length, and that the sides' true lengths.
// Differs from the paper: where the photo tells little of the focal length (seen frontally, or
// tilted about one side only), that of a phone is assumed, weighted by what is known.
SheetAspect sheetAspect(const Quad& quad, int photo_width_px, int photo_height_px);

}  // namespace hedr
