#include <algorithm>
#include <array>
#include <vector>

#include "core/robot/sensor_csv.h"
#include "core/text/number.h"
#include "core/text/text_file.h"

namespace hedr {
namespace {

void cell(std::string& row, double value) { appendNumber(row += ',', value); }
void cell(std::string& row, std::int64_t value) { appendNumber(row += ',', value); }

// A group of columns that is written where one report has a value for it.
struct ColumnGroup {
    const char* header;
    int width;
    bool (*has)(const SensorReport&);
    void (*write)(std::string& row, const SensorReport&);
};

template <class Kind>
bool hasOdometry(const SensorReport& report) {
    return std::holds_alternative<Kind>(report.odometry);
}

const std::array kGroups = {
    ColumnGroup{",left_ticks,right_ticks", 2, hasOdometry<WheelTicks>,
                [](std::string& row, const SensorReport& report) {
                    const auto& ticks = std::get<WheelTicks>(report.odometry);
                    cell(row, ticks.left);
                    cell(row, ticks.right);
                }},
    ColumnGroup{",left_m,right_m", 2, hasOdometry<WheelTravel>,
                [](std::string& row, const SensorReport& report) {
                    const auto& travel = std::get<WheelTravel>(report.odometry);
                    cell(row, travel.left_m);
                    cell(row, travel.right_m);
                }},
    ColumnGroup{",odo_x_m,odo_y_m,odo_heading_rad", 3, hasOdometry<OdometryPose>,
                [](std::string& row, const SensorReport& report) {
                    const auto& pose = std::get<OdometryPose>(report.odometry);
                    cell(row, pose.x_m);
                    cell(row, pose.y_m);
                    cell(row, pose.heading_rad);
                }},
    ColumnGroup{",dist_m", 1, hasOdometry<PathTravel>,
                [](std::string& row, const SensorReport& report) {
                    cell(row, std::get<PathTravel>(report.odometry).distance_m);
                }},
    ColumnGroup{
        ",gyro_z_rad_s", 1,
        [](const SensorReport& report) { return std::holds_alternative<GyroRate>(report.gyro); },
        [](std::string& row, const SensorReport& report) {
            cell(row, std::get<GyroRate>(report.gyro).rad_s);
        }},
    ColumnGroup{
        ",temperature_c", 1,
        [](const SensorReport& report) { return report.temperature_c.has_value(); },
        [](std::string& row, const SensorReport& report) { cell(row, *report.temperature_c); }},
    ColumnGroup{",mag_x,mag_y,mag_z", 3,
                [](const SensorReport& report) { return report.magnetic_field.has_value(); },
                [](std::string& row, const SensorReport& report) {
                    cell(row, report.magnetic_field->x);
                    cell(row, report.magnetic_field->y);
                    cell(row, report.magnetic_field->z);
                }},
};

}  // namespace

Result<void> saveSensorLog(const std::filesystem::path& file,
                           const std::vector<SensorReport>& reports) {
    std::string text = "t_s";
    std::vector<const ColumnGroup*> used;
    for (const ColumnGroup& group : kGroups) {
        if (std::none_of(reports.begin(), reports.end(), group.has)) continue;
        used.push_back(&group);
        text += group.header;
    }
    text += '\n';
    for (const SensorReport& report : reports) {
        appendNumber(text, report.robot_time_s);
        for (const ColumnGroup* group : used) {
            if (group->has(report)) {
                group->write(text, report);
            } else {
                text.append(static_cast<std::size_t>(group->width), ',');
            }
        }
        text += '\n';
    }
    return writeTextFile(file, text);
}

}  // namespace hedr
