#pragma once

#include <filesystem>

#include "ui/fleet.h"

namespace hedr {

// Where missions go that were given no name: one file each, named after the moment it began, and
// after the robot where it is not the first of its window.
std::filesystem::path newMissionFile(RobotId robot = kFirstRobot);
std::filesystem::path missionsFolder();

}  // namespace hedr
