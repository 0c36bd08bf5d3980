#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/robot/report.h"

namespace hedr {

// The sides and corners of a drive, as its encoders tell them: good for telling squares from other
// drives even where the wheelbase is believed a third too small.
struct SquareShape {
    std::vector<double> sides_m{};      // signed, forward positive
    std::vector<double> corners_rad{};  // to the left positive
    double way_m = 0.0;

    double turn_rad() const;
    double side_m() const;      // mean
    double corner_rad() const;  // mean, positive
};

// `steps`: travel of each wheel, one step after the other.
SquareShape shapeOf(std::span<const WheelTravel> steps, double wheelbase_m);

// Why it is no square, as the end of "Run 3 …"; empty: it is one. The turn after the last side may
// be missing.
std::string complaintAbout(const SquareShape& shape);

}  // namespace hedr
