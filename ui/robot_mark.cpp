#include "ui/robot_mark.h"

namespace hedr {

RobotMark robotMark(std::size_t place) {
    constexpr std::size_t kShapes = 4;
    return {static_cast<RobotShape>(place % kShapes), place % Theme{}.robots.size()};
}

QColor colourOf(const RobotMark& mark, const Theme& theme) { return theme.robots.at(mark.colour); }

Theme inColourOf(const RobotMark& mark, Theme theme) {
    theme.accent = colourOf(mark, theme);
    return theme;
}

}  // namespace hedr
