#pragma once

#include <cstdint>
#include <vector>

#include "core/calibration/encoders/encoder_travel.h"

namespace hedr {

enum class DriveKind : std::uint8_t { kStand, kStraight, kTurn };

// A stretch of a drive that is looked at as one: a turn, a few seconds of going straight on, or of
// standing. What the wheels did is in metres by the believed diameters, the gyro's angle by the
// believed scale.
struct DrivePiece {
    DriveKind kind = DriveKind::kStraight;
    double begin_s = 0.0;
    double end_s = 0.0;
    double way_m = 0.0;         // mean of both wheels, signed
    double rolled_m = 0.0;      // the same, but every way counts
    double difference_m = 0.0;  // right less left
    double gyro_rad = 0.0;      // turned, less the bias as far as it was known

    double span_s() const { return end_s - begin_s; }
};

// The drive of one log, cut where it begins and ends to turn, to stand or to go, so that what slips
// in a turn is one piece's. Where no readings came for more than a second nothing is told of it.
std::vector<DrivePiece> piecesOf(const EncoderTravel& travel, double wheelbase_m);

}  // namespace hedr
