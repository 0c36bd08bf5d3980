#pragma once

#include <cstddef>

#include "ui/theme.h"

namespace hedr {

enum class RobotShape { kArrow, kWedge, kHouse, kKite };

// Colour and shape by which a robot is told from the others, wherever it is shown.
struct RobotMark {
    RobotShape shape = RobotShape::kArrow;
    std::size_t colour = 0;  // of Theme::robots
    friend bool operator==(const RobotMark&, const RobotMark&) = default;
};

// For the robots in the order of their coming: twelve different ones.
RobotMark robotMark(std::size_t place);

QColor colourOf(const RobotMark& mark, const Theme& theme);
// A theme in which what is chosen has the robot's colour: for what is about that robot.
Theme inColourOf(const RobotMark& mark, Theme theme);

}  // namespace hedr
