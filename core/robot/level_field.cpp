#include "core/robot/level_field.h"

#include <cmath>

namespace hedr {

double LevelField::strength() const { return std::hypot(ahead, left); }

double LevelField::heading_rad() const { return std::atan2(-left, ahead); }

LevelField withoutIron(const MagneticField& field, const MagnetometerRange& range) {
    LevelField level{(field.x - range.centre_x) / range.range_x,
                     (field.y - range.centre_y) / range.range_y};
    // Of all ways to undo the correlation, which differ by a rotation, the one that leaves x alone.
    if (range.correlation != 0.0) {
        level.left = (level.left - range.correlation * level.ahead) /
                     std::sqrt(1.0 - range.correlation * range.correlation);
    }
    return level;
}

}  // namespace hedr
