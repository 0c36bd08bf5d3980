#include "core/robot/vehicle_edit.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

constexpr const char* kFile =
    "# our PackBot\n"
    "name = \"packbot\"\n"
    "left_wheel_diameter_m = 0.2   # measured in May\n"
    "right_wheel_diameter_m=0.2\n"
    "wheelbase_m = 0.4\n"
    "ticks_per_revolution = 1000\n"
    "\n"
    "[text]\n"
    "columns = [\"t_ms\", \"x_m\"]\n";

TEST(VehicleEdit, ChangesNumbersAndKeepsComments) {
    Vehicle changed = parseVehicle(kFile, "v").value();
    changed.geometry.left_wheel_diameter_m = 0.201;
    changed.geometry.right_wheel_diameter_m = 0.199;
    const std::string text = withNumbersOf(changed, kFile, "v").value();
    EXPECT_EQ(text,
              "# our PackBot\n"
              "name = \"packbot\"\n"
              "left_wheel_diameter_m = 0.201   # measured in May\n"
              "right_wheel_diameter_m = 0.199\n"
              "wheelbase_m = 0.4\n"
              "ticks_per_revolution = 1000\n"
              "\n"
              "[text]\n"
              "columns = [\"t_ms\", \"x_m\"]\n");
}

TEST(VehicleEdit, AddsNewKeysBeforeTheFirstSection) {
    Vehicle changed = parseVehicle(kFile, "v").value();
    changed.gyro_bias_rad_s = 0.001;
    changed.gyro_drift = {0.1, 0.2, 300.0};
    const std::string text = withNumbersOf(changed, kFile, "v").value();
    EXPECT_EQ(parseVehicle(text, "v").value(), changed);
    EXPECT_NE(text.find("# our PackBot"), std::string::npos);
    EXPECT_LT(text.find("gyro_bias_rad_s"), text.find("[text]"));
}

TEST(VehicleEdit, AddsToATextWithoutAnEndOfLine) {
    const std::string toml =
        "name = \"r\"\nleft_wheel_diameter_m = 0.2\nright_wheel_diameter_m = 0.2\n"
        "wheelbase_m = 0.4\nticks_per_revolution = 1000 # last";
    Vehicle changed = parseVehicle(toml, "v").value();
    changed.gyro_scale = 1.01;
    EXPECT_EQ(withNumbersOf(changed, toml, "v").value(), toml + "\ngyro_scale = 1.01\n");
}

TEST(VehicleEdit, EndsLinesAsTheFileDoes) {
    Vehicle vehicle;
    std::string text = formatVehicle(vehicle);
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
        text.insert(at, "\r");
    vehicle.geometry.wheelbase_m = 0.77;
    vehicle.gyro_bias_rad_s = 0.01;
    const std::string changed = withNumbersOf(vehicle, text, "v").value();
    EXPECT_NE(changed.find("wheelbase_m = 0.77\r\n"), std::string::npos) << changed;
    EXPECT_NE(changed.find("gyro_bias_rad_s = 0.01\r\n"), std::string::npos) << changed;
    EXPECT_EQ(std::count(changed.begin(), changed.end(), '\n'),
              std::count(changed.begin(), changed.end(), '\r'));
}

TEST(VehicleEdit, TakesOutTheLineOfAKeyThatIsToGo) {
    Vehicle vehicle = parseVehicle(kFile, "v").value();
    Vehicle with_bias = vehicle;
    with_bias.gyro_bias_rad_s = 0.001;
    const std::string text = withNumbersOf(with_bias, kFile, "v").value();
    ASSERT_NE(text, kFile);
    EXPECT_EQ(withNumbersOf(vehicle, text, "v").value(), kFile);
}

TEST(VehicleEdit, KnowsKeysInQuotes) {
    std::string text(kFile);
    text.replace(text.find("wheelbase_m"), 11, "\"wheelbase_m\"");
    Vehicle changed = parseVehicle(text, "v").value();
    changed.geometry.wheelbase_m = 0.41;
    std::string expected = text;
    expected.replace(expected.find("= 0.4\n"), 5, "= 0.41");
    EXPECT_EQ(withNumbersOf(changed, text, "v").value(), expected);
}

TEST(VehicleEdit, NamesTheNumbersThatDiffer) {
    const Vehicle before;
    Vehicle after = before;
    after.geometry.wheelbase_m = 0.41;
    after.gyro_bias_rad_s = 0.001;
    EXPECT_EQ(numberChanges(before, after),
              (std::vector<NumberChange>{{"wheelbase_m", 0.4, 0.41},
                                         {"gyro_bias_rad_s", std::nullopt, 0.001}}));
    EXPECT_TRUE(numberChanges(before, before).empty());
}

TEST(VehicleEdit, SetsNumbersByTheirKeys) {
    Vehicle vehicle;
    ASSERT_TRUE(setVehicleNumber(vehicle, "mag_range_x", 2.0));
    EXPECT_EQ(vehicleNumber(vehicle, "mag_range_x"), 2.0);
    EXPECT_EQ(vehicleNumber(vehicle, "gyro_bias_rad_s"), std::nullopt);
    const Vehicle before = vehicle;
    EXPECT_EQ(setVehicleNumber(vehicle, "wheelbase_m", -1.0).error().code, ErrorCode::kBadValue);
    EXPECT_EQ(setVehicleNumber(vehicle, "wheel_m", 1.0).error().code, ErrorCode::kUnknownName);
    EXPECT_EQ(vehicle, before);
}

}  // namespace
}  // namespace hedr
