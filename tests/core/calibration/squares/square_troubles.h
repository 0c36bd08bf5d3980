#pragma once

#include <string>
#include <vector>

#include "core/geometry/frames.h"
#include "tests/core/calibration/squares/square_drives.h"

namespace hedr {

struct TroubledSquares {
    DrivenSquares driven{};
    VehicleGeometry real{};
    std::string trouble;
};

// Squares of a robot whose wheels are a little wrong, very wrong, or right, with one of the things
// that go wrong when squares are driven and their ends are measured and written down.
TroubledSquares troubledSquares(Random& random);

bool isInside(const Vector<Robot>& point, const std::vector<double>& outline_x,
              const std::vector<double>& outline_y);

}  // namespace hedr
