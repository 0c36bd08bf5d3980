#pragma once

#include <vector>

#include "core/site/survey/photo_tones.h"

namespace hedr {

// A straight edge in a photo: points p with normal . p = offset. The normal has length 1 and points
// to the brighter side.
struct EdgeLine {
    Vector<Small> normal{};
    double offset = 0.0;
    double weight = 0.0;  // about the length of the edge, px
};

// The strongest edges, at most `most` of them, the strongest first. Votes for lines (R. Duda,
// P. Hart, Use of the Hough transformation, 1972) with the direction of the slope, then a fit.
std::vector<EdgeLine> edgeLines(const PhotoTones& tones, std::size_t most);

}  // namespace hedr
