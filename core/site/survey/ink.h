#pragma once

#include "core/site/plan.h"

namespace cv {
class Mat;
}

namespace hedr {

// Pictures here are 8-bit grey; a mask is 255 and 0.

// The pixels themselves where they are grey already, and only to be read.
cv::Mat greyOf(const PlanLevel& level);

// A drawing with its paper at 255 and its ink towards 0: uneven light and the tints of rooms are
// levelled, white on black is turned round. Empty where the picture has no paper, such as a photo
// of land.
cv::Mat levelled(const cv::Mat& grey);

// What is as dark as the darker lines of the drawing.
cv::Mat inkOf(const cv::Mat& levelled);

// Every line, however pale, but no specks.
cv::Mat linesOf(const cv::Mat& levelled);

// The strokes of the ink that are walls, those between two lines filled.
cv::Mat wallsIn(const cv::Mat& ink);

// What is reached from beside the walls without crossing a line or a gap as narrow as a door, and
// what lies in it (texts, dimensions). Nothing where the drawing does not close a building.
cv::Mat outsideOf(const cv::Mat& lines, const cv::Mat& walls);

// The mask without connected parts whose bounding box has a shorter diagonal.
cv::Mat withoutSmallParts(const cv::Mat& mask, double least_extent_px);

// Closed gaps between lines that are long and nowhere wider, as between the two of a hollow wall.
cv::Mat narrowGaps(const cv::Mat& ink, double most_half_width_px);

// Distance from each pixel of the mask to the nearest one beside it: 1 at its rim.
cv::Mat depthIn(const cv::Mat& mask);

cv::Mat grownBy(const cv::Mat& mask, double radius_px);

}  // namespace hedr
