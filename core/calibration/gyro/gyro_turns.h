#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/calibration/gyro/gyro_stands.h"
#include "core/robot/vehicle.h"

namespace hedr {

// How far the wheels say that the robot had turned at that time.
struct WheelHeading {
    double t_s = 0.0;
    double heading_rad = 0.0;
};

// A log of standing and turning, read for its turns.
struct TurnLog {
    std::vector<GyroSample> samples{};  // of the gyro, without lone ones
    std::size_t broken = 0;             // readings that are no numbers or have no time
    double longest_gap_s = 0.0;         // a longer one loses what was turned in it
    GyroStands standing{};
    std::vector<WheelHeading> wheels{};  // empty where they tell no turning
};

// None where the log has no gyro readings.
std::optional<TurnLog> readTurnLog(std::span<const SensorReport> reports, const Vehicle& vehicle);

// From one stand of a log to a later one.
struct GyroTurn {
    std::size_t number = 0;  // as the operator counts, from 1 on over all logs
    std::size_t log = 0;
    std::size_t from = 0;  // stand of the log, the last before it moved
    std::size_t to = 0;
    double reported_rad = 0.0;           // by the gyro, its bias removed
    double duration_s = 0.0;             // from the end of a stand to the beginning of the other
    std::vector<double> bias_share_s{};  // by which the mean of each stand, from … to, counts
    double gap_s = 0.0;                  // the longest between two readings
    std::optional<double> wheels_rad{};
    int whole = 0;  // turns, counter-clockwise positive; 0: not a whole number, or not known
};

struct TurnOptions {
    std::optional<double> turns{};  // of each, where that is known
    bool closed = false;            // only the first and the last stand of a log are at the mark
    double gyro_scale = 1.0;        // right to a tenth
};

struct TurnsFound {
    std::vector<GyroTurn> whole{};
    std::vector<GyroTurn> others{};  // no whole number of turns, or a gap
    bool ambiguous = false;          // it could be one turn more or less: it has to be told
};

// The bias during a turn is that of the stands before, within and after it, on straight lines
// between their middles. A move of some degrees goes back to the mark and belongs to the turn
// before it. Pieces of a turn count where they make a whole number together.
TurnsFound turnsIn(std::span<const TurnLog> logs, const TurnOptions& options);

}  // namespace hedr
