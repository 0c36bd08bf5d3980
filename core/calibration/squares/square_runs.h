#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/calibration/sample_set.h"
#include "core/robot/report.h"
#include "core/robot/vehicle.h"

namespace hedr {

enum class Turning : unsigned char { kClockwise, kCounterClockwise };

std::string_view nameOf(Turning turning);  // "clockwise", "counter-clockwise"

// One square drive. What begins and ends it is standing still.
struct SquareRun {
    std::size_t number = 0;  // see squareRunsOf
    Turning turning = Turning::kClockwise;
    double side_m = 0.0;      // by the encoders, mean
    double corner_rad = 0.0;  // the same, of the turns, positive
    std::size_t set = 0;      // it goes from report `first` to report `last` of that set
    std::size_t first = 0;
    std::size_t last = 0;
    std::vector<WheelTravel> steps{};  // travel of each wheel, one step after the other
};

struct LeftOutRun {
    std::size_t number = 0;
    std::string reason;  // the end of "Run 3 …"
};

struct SquareRuns {
    std::vector<SquareRun> runs{};
    std::vector<LeftOutRun> left_out{};
    std::size_t moves = 0;          // with less than two corners: on the way to the start
    bool unfinished = false;        // the last one; live: it is being driven
    bool wheels_told_apart = true;  // or nothing is found
};

// Wheels that stand for longer end a run; it is more than anybody needs at a corner.
inline constexpr double kLongestCornerStop_s = 2.0;

// The square drives in logs of one robot, in their order. They are numbered from 1, those left out
// too; a log beside others that holds no square at all is one that is left out, so that where each
// drive has a log of its own a run's number is its log's. Which way they turned is told by the
// encoders.
SquareRuns squareRunsOf(std::span<const SampleSet> sets, const Vehicle& believed);

}  // namespace hedr
