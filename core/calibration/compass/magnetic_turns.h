#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/calibration/compass/ellipse_fit.h"
#include "core/calibration/compass/magnetic_log.h"

namespace hedr {

// Readings first … last - 1, between which it turned on the spot one way.
struct MagneticStretch {
    std::size_t log = 0;
    std::size_t first = 0;
    std::size_t last = 0;
    double turned_rad = 0.0;  // counter-clockwise positive
};

// A piece of a stretch that can be held out: half a turn or a whole one.
struct MagneticPart {
    std::size_t stretch = 0;
    std::size_t first = 0;
    std::size_t last = 0;
};

struct MagneticTurns {
    HeadingJudge judge = HeadingJudge::kNone;  // of all of them
    std::vector<MagneticSample> samples{};     // of the stretches, in their order
    std::vector<MagneticStretch> stretches{};

    double turned_rad() const;         // both ways together
    double turned_rad(int way) const;  // counter-clockwise: 1, clockwise: -1
    FieldReadings readings() const;
};

struct MagneticTurnOptions {
    double wheelbase_m = 0.4;
    // Where there is no judge: whether the field of the believed vehicle goes round as its heading
    // does (1) or the other way (-1).
    int sense = 1;
};

// Turning on the spot, faster than 4 °/s and by a quarter of a turn at least, about a point within
// the robot. Where not every log has a judge, the angle of the field on its own ellipse says when
// and by how much it turned. More than 4,000 readings are averaged, neighbours together.
MagneticTurns magneticTurnsIn(std::span<const MagneticLog> logs,
                              const MagneticTurnOptions& options);

// Without the readings whose weight is 0, and without stretches of which nothing is left.
MagneticTurns withoutOutliers(const MagneticTurns& turns, const Eigen::VectorXd& weight);

// Each stretch in equal pieces of about so much turning.
std::vector<MagneticPart> partsOf(const MagneticTurns& turns, double part_rad);
// To hold out: whole turns, or half ones where it turned by less than eight.
std::vector<MagneticPart> heldOutPartsOf(const MagneticTurns& turns);

}  // namespace hedr
