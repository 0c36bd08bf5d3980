#pragma once

#include <gtest/gtest.h>

#include <fstream>

#include "core/calibration/history/vehicle_history.h"
#include "core/robot/vehicle.h"
#include "tests/core/text/scratch_folder.h"

namespace hedr::test {

// With something in every field.
inline CalibrationRecord fullRecord() {
    CalibrationRecord record{.procedure = "bias",
                             .time_utc = "2026-11-28T12:30:05Z",
                             .who = "Ada \"the\" operator",
                             .robot = "packbot 3",
                             .surface = "concrete",
                             .temperature_c = 21.5,
                             .program_version = "0.1.0",
                             .verdict = Verdict::kAccepted,
                             .reason = "Better.",
                             .taken_over = true,
                             .remarks = {"One.", "It said \"two\"\nand three."},
                             .vehicle_before = "name = \"a\" # old\n",
                             .vehicle_after = "name = \"b\"\n"};
    record.found = {{"gyro_bias_rad_s", 0.001, {0.1 + 0.2, 1e-5, 23.0}},
                    {"wheelbase_m", std::nullopt, {0.4, 0.001}, false, true},
                    {"gyro_drift_time_s", std::nullopt, {338.0, 24.0, 97.0, 0.125}}};
    record.told = {.turns = 2.0,
                   .closed = true,
                   .distance_m = 1.0 / 3.0,
                   .on_before_s = 60.0,
                   .room_changes = true,
                   .ends = {{1, {0.12, -0.03}}, {7, {-0.1, 0.2}, Turning::kClockwise}}};
    record.track_widths = {{0.35, {0.41, 0.002, 9.0}, 10}, {0.8, {0.44, 0.003}, 11}};
    record.proof = Proof{"drift", "rad/s", 7, 0.1, 0.01, 10.0, {9.0, 11.0}, {8.0, 12.0}};
    record.raw = {{"samples-1.csv", std::string(64, 'a'), "/logs/a.csv"}};
    return record;
}

inline std::vector<SensorReport> someReports() {
    std::vector<SensorReport> reports;
    for (int i = 0; i < 5; ++i)
        reports.push_back({.robot_time_s = 0.1 * i,
                           .odometry = WheelTicks{i, 2 * i},
                           .gyro = GyroRate{0.01 * i}});
    return reports;
}

// A vehicle file that may get a history.
class VehicleWithHistory : public testing::Test {
  protected:
    VehicleWithHistory() { std::ofstream(vehicle_) << text_; }

    ScratchFolder folder_;
    std::filesystem::path vehicle_ = folder_.path() / "robot.toml";
    std::filesystem::path history_ = historyFolderOf(vehicle_);
    std::string text_ = formatVehicle({});
};

}  // namespace hedr::test
