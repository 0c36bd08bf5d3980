#pragma once

#include <optional>
#include <vector>

namespace hedr {

// What two wheels that go the same way have turned at one time, by their encoders, forwards
// positive.
struct WheelPair {
    double t_s = 0.0;
    double left_revolutions = 0.0;
    double right_revolutions = 0.0;
    double gyro_rad = 0.0;  // of the robot; zero where there is no gyro
};

// A straight run.
struct WheelPairRun {
    std::vector<WheelPair> moments{};
    double ticks_per_revolution = 0.0;
};

// Counts that are missing at the same place of a wheel, revolution by revolution.
struct MissingCounts {
    bool left = false;      // of the left wheel's encoder, else of the right one's
    double share = 0.0;     // of a revolution
    double strength = 0.0;  // above 1: more than chance
};

double revolutionsOf(const WheelPairRun& run);
inline constexpr double kFewestRevolutions = 2.5;

// Steps back in the difference of the wheels, less what the gyro explains, at one angle of the
// wheel as the other one tells it: the lines at the harmonics of a revolution that such steps have,
// compared with what is half-way between them, as an unsteady speed or a robot that wanders has no
// lines. None where the run is too short or the counts are too coarse.
std::optional<MissingCounts> missingCountsIn(const WheelPairRun& run);

}  // namespace hedr
