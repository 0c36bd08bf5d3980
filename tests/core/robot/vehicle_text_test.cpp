#include <gtest/gtest.h>

#include "core/robot/vehicle.h"

namespace hedr {
namespace {

constexpr const char* kWheels =
    "name = \"bot\"\n"
    "left_wheel_diameter_m = 0.2\n"
    "right_wheel_diameter_m = 0.21\n"
    "wheelbase_m = 0.4\n"
    "ticks_per_revolution = 36\n";

Result<Vehicle> parse(const std::string& section) {
    return parseVehicle(kWheels + section, "robot.toml");
}

TEST(VehicleText, NamesTheColumnsInOrder) {
    const auto vehicle = parse(
        "[text]\ncolumns = [\"t_ms\", \"left_ticks\", \"right_ticks\", \"-\", \"gyro_dps\"]\n");
    ASSERT_TRUE(vehicle);
    ASSERT_TRUE(vehicle->text);
    EXPECT_EQ(vehicle->text->columns,
              (std::vector<std::string>{"t_ms", "left_ticks", "right_ticks", "-", "gyro_dps"}));
    EXPECT_FALSE(vehicle->text->rate_hz);
}

TEST(VehicleText, IsAbsentWhereTheFileHasNoSection) {
    const auto vehicle = parse("");
    ASSERT_TRUE(vehicle);
    EXPECT_FALSE(vehicle->text);
    EXPECT_EQ(formatVehicle(*vehicle).find("[text]"), std::string::npos);
}

TEST(VehicleText, ReadsBackAsItWasWritten) {
    for (const char* section :
         {"[text]\n", "[text]\nrate_hz = 50\n", "[text]\ncolumns = [\"t [\u00B5s]\", \"gz\"]\n",
          "[text]\nrate_hz = 12.5\ncolumns = [\"left\", \"right\"]\n"}) {
        const auto vehicle = parse(section);
        ASSERT_TRUE(vehicle) << section;
        EXPECT_TRUE(vehicle->text);
        EXPECT_EQ(parseVehicle(formatVehicle(*vehicle), "again"), *vehicle) << section;
    }
}

struct BadSection {
    const char* section;
    const char* line;
    const char* detail;  // how it begins
};

class VehicleTextBad : public testing::TestWithParam<BadSection> {};

TEST_P(VehicleTextBad, IsRefusedWithLineAndReason) {
    const auto vehicle = parse(GetParam().section);
    ASSERT_FALSE(vehicle);
    EXPECT_EQ(vehicle.error().code, ErrorCode::kBadValue);
    EXPECT_EQ(vehicle.error().subject, std::string("robot.toml:") + GetParam().line);
    EXPECT_TRUE(vehicle.error().detail.starts_with(GetParam().detail)) << vehicle.error().detail;
}

INSTANTIATE_TEST_SUITE_P(
    Sections, VehicleTextBad,
    testing::Values(
        BadSection{"text = 3\n", "6", "text must be a section, [text]"},
        BadSection{"[text]\ncolumns = \"t_ms\"\n", "7", "columns must be a list of 1 to 32 names"},
        BadSection{"[text]\ncolumns = []\n", "7", "columns must be a list"},
        BadSection{"[text]\ncolumns = [\"t_ms\", 3]\n", "7", "a column must be a text"},
        BadSection{"[text]\ncolumns = [\"t_ms\", \"links\"]\n", "7",
                   "unknown column links; known are t_s, left_ticks, right_ticks, left_m, "},
        BadSection{"[text]\nrate_hz = 0\n", "7", "rate_hz must be a number from 0.1 to 10000"},
        BadSection{"[text]\nrate_hz = nan\n", "7", "rate_hz must be"},
        BadSection{"[text]\nrate_hz = \"50\"\n", "7", "rate_hz must be"},
        BadSection{"[text]\nunit = \"ms\"\n", "7", "unknown key unit in [text], which has"},
        BadSection{"[text]\ncolumns = [\"left\", \"right\"]\n", "6",
                   "no column of [text] is a time"}));

}  // namespace
}  // namespace hedr
