#pragma once

#include <vector>

#include "core/site/plan.h"

namespace hedr {

// A straight piece of an edge, in pixels of the picture it was found in, y up.
struct Segment {
    double angle_rad = 0.0;  // counter-clockwise from the right
    double length_px = 0.0;
    double middle_x_px = 0.0;
    double middle_y_px = 0.0;
};

// The straight edges of a picture that are longer than letters and symbols are.
std::vector<Segment> segmentsIn(const PlanLevel& picture);

// The segments without hatching, stairs and tiles: those that have many parallel ones beside them.
std::vector<Segment> withoutHatching(const std::vector<Segment>& segments, double picture_side_px);

// What runs along an angle, or nearly, put together where it lies in one line: a wall between its
// doors is several segments, but one line, whose angle is known far better. A line's length is that
// of a single segment of its accuracy; its middle is not set.
std::vector<Segment> linesAlong(const std::vector<Segment>& segments, double angle_rad);

}  // namespace hedr
