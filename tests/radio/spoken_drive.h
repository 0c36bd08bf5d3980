#pragma once

#include <cstdint>
#include <vector>

#include "core/robot/report.h"
#include "radio/faulty_radio.h"
#include "radio/simulated_robot.h"

namespace hedr {

// A robot with wheels of a metre's circumference and a thousand ticks.
inline Vehicle spokenVehicle() {
    Vehicle vehicle;
    vehicle.name = "test";
    vehicle.geometry = {0.318310, 0.318310, 0.5, 1000.0};
    return vehicle;
}

// Stands two seconds, drives straight on at 0.5 m/s; a report every 20 ms.
inline std::vector<SensorReport> straightDrive(double seconds) {
    std::vector<SensorReport> reports;
    for (int i = 0; i * 0.02 <= seconds; ++i) {
        const double t_s = 0.02 * i;
        const auto ticks = static_cast<std::int64_t>(t_s > 2.0 ? 500.0 * (t_s - 2.0) : 0.0);
        reports.push_back(
            {.robot_time_s = t_s, .odometry = WheelTicks{ticks, ticks}, .gyro = GyroRate{0.001}});
    }
    return reports;
}

// What the robot says during the drive, after the radio has spoilt it.
inline std::vector<std::uint8_t> spoken(const std::vector<SensorReport>& reports,
                                        const RadioFaults& faults = {}, int restart_at = -1,
                                        const Pose<World>& start = {}) {
    std::vector<std::uint8_t> bytes;
    SimulatedRobot robot(spokenVehicle(), start);
    FaultyRadio radio(faults);
    const auto deliver = [&](std::span<const std::uint8_t> some) {
        bytes.insert(bytes.end(), some.begin(), some.end());
    };
    int index = 0;
    for (const SensorReport& report : reports) {
        if (index++ == restart_at) robot.restart();
        robot.sense(report,
                    [&](std::span<const std::uint8_t> frame) { radio.send(frame, deliver); });
    }
    radio.flush(deliver);
    return bytes;
}

}  // namespace hedr
