#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/calibration/squares/square_runs.h"
#include "core/geometry/frames.h"
#include "core/result.h"

namespace hedr {

// Where a square drive really ended, measured from the mark of its start and in the axes of that
// mark: x along the first side, y to the left of it. Axes that are exchanged, or both the other way
// round, look like other wheels: nothing notices that.
struct UmbmarkEnd {
    std::size_t run = 0;  // SquareRun::number
    Vector<Robot> way{};
    std::optional<Turning> said{};  // which way it was driven, by the operator

    friend bool operator==(const UmbmarkEnd&, const UmbmarkEnd&) = default;
};

// Reads a table with the columns run, x_m, y_m and, if it is there, direction ("clockwise",
// "counter-clockwise"), which may be empty in a row. Rows in any order. Errors with path:line:
// kFileEmpty, kMissingColumn, kBadFormat (no number, a run twice, a direction unknown).
Result<std::vector<UmbmarkEnd>> parseUmbmarkEnds(std::string_view csv, const std::string& path);

}  // namespace hedr
