#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/robot/report.h"

namespace hedr {

struct SensorLog {
    std::vector<SensorReport> reports;
    std::vector<std::string> ignored_columns;  // for one warning
};

inline constexpr const char* kGyroColumn = "gyro_z_rad_s";

// Reads a sensors.csv (DESIGN: header row, free column order). Needs t_s and at least one of the
// odometry, gyro or magnetometer columns. `gyro_column`: another axis, to look at its noise. Where
// several kinds of odometry are given: ticks before metres before an odometry pose before dist_m.
// Errors: kFileMissing, kFileUnreadable, kFileEmpty, kMissingColumn, kBadFormat (path:line).
Result<SensorLog> loadSensorLog(const std::filesystem::path& file,
                                const std::string& gyro_column = kGyroColumn);

// Writes the columns that occur in the reports. GyroAngle is not written: a log has rates.
Result<void> saveSensorLog(const std::filesystem::path& file,
                           const std::vector<SensorReport>& reports);

}  // namespace hedr
