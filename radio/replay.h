#pragma once

#include <functional>
#include <vector>

#include "core/result.h"
#include "radio/faulty_radio.h"
#include "radio/robot_line.h"
#include "radio/simulated_robot.h"

namespace hedr {

struct ReplayScript {
    double speed = 1.0;  // times real time
    RadioFaults faults{};
    double restart_at_s = -1.0;  // the robot is switched off and on; negative: never
};

using StopRequested = std::function<bool()>;

// Lets the robot live through the reports in their own time and speak over the line. Blocks until
// the end of the reports, or soon after a stop was requested.
void replayReports(const std::vector<SensorReport>& reports, SimulatedRobot& robot, RobotLine& line,
                   const ReplayScript& script, const StopRequested& stop_requested);

// Sends the recorded bytes of a mission at their times. Errors: those of MissionReader.
Result<void> replayMission(const std::filesystem::path& mission, RobotLine& line,
                           const ReplayScript& script, const StopRequested& stop_requested);

// Until a program opens the pseudo-terminal. False if stopped before.
bool waitForListener(const RobotLine& line, const StopRequested& stop_requested);

}  // namespace hedr
