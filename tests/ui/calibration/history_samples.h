#pragma once

#include <string>

#include "ui/calibration/history_page.h"

// Histories of a robot, for tests of their page.
namespace hedr::test {

// The robot as it was at first, and after its wheels were found.
inline Vehicle asBuilt() { return {.name = "PackBot 3", .geometry = {.wheelbase_m = 0.41}}; }
inline Vehicle afterWheels() {
    Vehicle vehicle = asBuilt();
    vehicle.geometry.wheelbase_m = 0.5531;
    vehicle.geometry.right_wheel_diameter_m = 0.2004;
    return vehicle;
}

inline CalibrationRecord recordOf(const char* procedure, const char* time_utc,
                                  const Vehicle& before, const Vehicle& after) {
    return {.procedure = procedure,
            .time_utc = time_utc,
            .who = "Ada",
            .robot = "PackBot 3",
            .surface = "concrete",
            .temperature_c = 21.43,
            .program_version = "hedr-ocu 0.1.0",
            .verdict = Verdict::kAccepted,
            .reason = "The part of the data that was held out says that it is better.",
            .taken_over = true,
            .vehicle_before = formatVehicle(before),
            .vehicle_after = formatVehicle(after)};
}

inline CalibrationRecord wheelsRecord() {
    CalibrationRecord record = recordOf("wheels", "2026-11-12T12:30:05Z", asBuilt(), afterWheels());
    record.found = {{"wheelbase_m", 0.41, {0.5531, 0.00107}},
                    {"left_wheel_diameter_m", 0.2, {0.20001, 0.00005}, true},
                    {"right_wheel_diameter_m", 0.2, {0.2004, 0.00005}}};
    record.proof =
        Proof{"distance at the end", "m", 8, 0.205, 0.016, 12.8, {9.0, 17.0}, {8.0, 19.0}};
    record.remarks = {"The robot slipped on 5 % of the way; those samples count less."};
    record.raw = {{"samples-1.csv", "", "live"}, {"samples-2.csv", "", "live"}};
    return record;
}

inline CalibrationRecord declinedRecord() {
    CalibrationRecord record =
        recordOf("gyro-bias", "2026-11-20T08:00:00Z", afterWheels(), afterWheels());
    record.found = {{"gyro_bias_rad_s", std::nullopt, {0.0157, 0.00002, 400.0}}};
    record.taken_over = false;
    return record;
}

inline HistoryEntry entryOf(const char* name, Result<CalibrationRecord> record) {
    return {name, {}, std::move(record)};
}

inline HistoryEntry damagedEntry() {
    const std::string name = "2026-11-25T101500Z-warmup";
    const std::string file = "/home/ada/.local/share/hedr/vehicles/packbot_3.history/" + name;
    return {name, {}, fail(ErrorCode::kBadFormat, file + "/record.toml:14", "a value is missing")};
}

// The earliest first: wheels that were taken over, a bias that was not, a damaged one.
inline HistoryView someView() {
    return {.robot = "PackBot 3",
            .vehicle_file = "/home/ada/vehicles/packbot_3.toml",
            .entries = {entryOf("2026-11-12T123005Z-wheels", wheelsRecord()),
                        entryOf("2026-11-20T080000Z-gyro-bias", declinedRecord()), damagedEntry()},
            .now = afterWheels()};
}

// More of it than fits, in every state, with words that are longer than anybody should write.
inline HistoryView longView() {
    HistoryView view = someView();
    CalibrationRecord refused =
        recordOf("umbmark", "2026-11-26T09:00:00Z", afterWheels(), afterWheels());
    refused.verdict = Verdict::kRefused;
    refused.reason = "The part of the data that was held out says that it is worse.";
    refused.taken_over = false;
    refused.found = {{"a_number_of_a_robot_from_tomorrow_m", 1.0, {1.0000001, 1e-8}}};
    refused.remarks.assign(5, "The large blue robot with the new tracks has slipped all the time.");
    refused.who = "Ada-and-all-the-others-of-the-night-shift-of-the-northern-halls";
    refused.surface = "polished concrete with a little sand, in the hall behind the station";
    CalibrationRecord restored =
        recordOf("restore", "2026-11-27T09:00:00Z", afterWheels(), asBuilt());
    restored.reason = "Restored from 2026-11-12T123005Z-wheels.";
    view.entries.push_back(entryOf("2026-11-26T090000Z-umbmark", refused));
    view.entries.push_back(entryOf("2026-11-27T090000Z-restore", restored));
    for (const char* name : {"a", "b", "c", "d", "e", "f"})
        view.entries.push_back(entryOf(name, wheelsRecord()));
    CalibrationRecord declined = wheelsRecord();
    declined.taken_over = false;
    view.entries.push_back(entryOf("g", declined));
    return view;
}

}  // namespace hedr::test
