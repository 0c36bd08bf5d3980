#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "core/calibration/compass/magnetic_log.h"
#include "core/calibration/compass/magnetic_turns.h"

namespace hedr {

// What is wrong with a magnetometer's readings as such, and what to do; empty: nothing.
std::string complaintAboutReadings(std::span<const MagneticLog> logs);

// The same of readings that stay at the end of the sensor's range.
std::string complaintAboutSaturation(const MagneticTurns& turns);

std::vector<Eigen::Vector3d> allFieldsOf(std::span<const MagneticLog> logs);

// "205°".
std::string wholeDegreesText(double angle_rad);

}  // namespace hedr
