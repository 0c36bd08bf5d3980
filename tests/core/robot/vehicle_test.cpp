#include "core/robot/vehicle.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

namespace hedr {
namespace {

const std::filesystem::path kRecordings = HEDR_SOURCE_DIR "/../shared/data";

constexpr const char* kGood =
    "name = \"bot\"\n"
    "left_wheel_diameter_m = 0.2\n"
    "right_wheel_diameter_m = 0.21\n"
    "wheelbase_m = 0.4\n"
    "ticks_per_revolution = 36\n";

Error errorOf(const std::string& toml) {
    const auto vehicle = parseVehicle(toml, "robot.toml");
    EXPECT_FALSE(vehicle);
    return vehicle ? Error{} : vehicle.error();
}

TEST(Vehicle, NeedsOnlyItsWheels) {
    const auto vehicle = parseVehicle(kGood, "robot.toml");
    ASSERT_TRUE(vehicle);
    Vehicle expected;
    expected.name = "bot";
    expected.geometry = {0.2, 0.21, 0.4, 36.0};
    EXPECT_EQ(*vehicle, expected);
}

TEST(Vehicle, ReadsEveryOptionalKey) {
    const auto vehicle = parseVehicle(std::string(kGood) +
                                          "heading_source = \"encoders\"\n"
                                          "encoder_counter_bits = 16\n"
                                          "gyro_scale = 1.01\n"
                                          "gyro_bias_rad_s = -0.002\n"
                                          "gyro_noise_rad_s_sqrthz = 1e-4\n"
                                          "gyro_bias_walk_rad_s_sqrts = 7e-5\n"
                                          "max_speed_m_s = 3\n",
                                      "robot.toml");
    ASSERT_TRUE(vehicle);
    EXPECT_EQ(vehicle->heading_source, HeadingSource::kEncoders);
    EXPECT_EQ(vehicle->encoder_counter_bits, 16);
    EXPECT_EQ(vehicle->gyro_scale, 1.01);
    EXPECT_EQ(vehicle->gyro_bias_rad_s, -0.002);
    EXPECT_EQ(vehicle->gyro_noise_rad_s_sqrthz, 1e-4);
    EXPECT_EQ(vehicle->gyro_bias_walk_rad_s_sqrts, 7e-5);
    EXPECT_EQ(vehicle->max_speed_m_s, 3.0);
}

TEST(Vehicle, ReadsTheDriftOfAGyroAndTheRangeOfAMagnetometer) {
    const auto vehicle = parseVehicle(std::string(kGood) +
                                          "gyro_drift_c1_rad_s = 0.00267\n"
                                          "gyro_drift_c2_rad_s = -0.0046\n"
                                          "gyro_drift_time_s = 338\n"
                                          "mag_centre_x = 3.5\n"
                                          "mag_centre_y = -1\n"
                                          "mag_range_x = 20\n"
                                          "mag_range_y = -21\n"
                                          "mag_correlation = -0.25\n",
                                      "robot.toml");
    ASSERT_TRUE(vehicle);
    EXPECT_EQ(vehicle->gyro_drift, (GyroDrift{0.00267, -0.0046, 338.0}));
    EXPECT_EQ(vehicle->magnetometer, (MagnetometerRange{3.5, -1.0, 20.0, -21.0, -0.25}));
    EXPECT_EQ(parseVehicle(formatVehicle(*vehicle), "again"), *vehicle);
}

TEST(Vehicle, NamesTheOneThatIsMissingOfKeysThatBelongTogether) {
    const Error drift = errorOf(std::string(kGood) + "gyro_drift_time_s = 338\n");
    EXPECT_EQ(drift.code, ErrorCode::kMissingKey);
    EXPECT_EQ(drift.detail, "gyro_drift_c1_rad_s");
    const Error magnetometer =
        errorOf(std::string(kGood) + "mag_centre_x = 1\nmag_centre_y = 1\nmag_range_x = 3\n");
    EXPECT_EQ(magnetometer.detail, "mag_range_y");
}

TEST(Vehicle, NamesTheLineOfASyntaxError) {
    const Error error = errorOf("name = \"bot\"\nwheelbase_m = = 3\n");
    EXPECT_EQ(error.code, ErrorCode::kBadFormat);
    EXPECT_EQ(error.subject, "robot.toml:2");
}

TEST(Vehicle, NamesTheMissingKey) {
    const Error error = errorOf("name = \"bot\"\nleft_wheel_diameter_m = 0.2\n");
    EXPECT_EQ(error.code, ErrorCode::kMissingKey);
    EXPECT_EQ(error.subject, "robot.toml");
    EXPECT_EQ(error.detail, "right_wheel_diameter_m");
    EXPECT_EQ(errorOf("").detail, "name");
}

TEST(Vehicle, HintsAtTheKeyThatAMisspeltOneMeant) {
    const Error error = errorOf(std::string(kGood) + "gyro_skale = 1.0\n");
    EXPECT_EQ(error.code, ErrorCode::kBadValue);
    EXPECT_EQ(error.subject, "robot.toml:6");
    EXPECT_EQ(error.detail, "unknown key gyro_skale, did you mean gyro_scale?");
}

TEST(Vehicle, GivesNoHintWhereNoKeyIsNear) {
    EXPECT_EQ(errorOf(std::string(kGood) + "colour = \"red\"\n").detail, "unknown key colour");
}

struct BadLine {
    const char* line;
    const char* detail;
};

class VehicleBadLine : public testing::TestWithParam<BadLine> {};

TEST_P(VehicleBadLine, IsRefusedWithLineAndReason) {
    std::string text = kGood;
    const std::string line = GetParam().line;
    const std::string key = line.substr(0, line.find(' '));
    const auto old = text.find(key + " =");
    if (old != std::string::npos) text.erase(old, text.find('\n', old) + 1 - old);
    const Error error = errorOf(line + '\n' + text);
    EXPECT_EQ(error.code, ErrorCode::kBadValue);
    EXPECT_EQ(error.subject, "robot.toml:1");
    EXPECT_EQ(error.detail, GetParam().detail);
}

INSTANTIATE_TEST_SUITE_P(
    Vehicle, VehicleBadLine,
    testing::Values(
        BadLine{"wheelbase_m = -0.4", "wheelbase_m is -0.4, must be positive"},
        BadLine{"left_wheel_diameter_m = 0", "left_wheel_diameter_m is 0, must be positive"},
        BadLine{"wheelbase_m = 1e-300", "wheelbase_m is 1e-300, nothing is so small in SI units"},
        BadLine{"gyro_scale = 1e155", "gyro_scale is 1e+155, nothing is so large in SI units"},
        BadLine{"gyro_noise_rad_s_sqrthz = 10.5",
                "gyro_noise_rad_s_sqrthz is 10.5, no gyro has more than 10"},
        BadLine{"gyro_bias_walk_rad_s_sqrts = 1e155",
                "gyro_bias_walk_rad_s_sqrts is 1e+155, no gyro has more than 10"},
        BadLine{"wheelbase_m = nan", "wheelbase_m is nan, must be a finite number"},
        BadLine{"wheelbase_m = inf", "wheelbase_m is inf, must be a finite number"},
        BadLine{"wheelbase_m = \"0.4\"", "wheelbase_m must be a number"},
        BadLine{"wheelbase_m = true", "wheelbase_m must be a number"},
        BadLine{"wheelbase_m = [0.4]", "wheelbase_m must be a number"},
        BadLine{"name = 7", "name must be a text"},
        BadLine{"gyro_noise_rad_s_sqrthz = -1",
                "gyro_noise_rad_s_sqrthz is -1, must not be negative"},
        BadLine{"mag_range_x = 0\nmag_centre_x = 0\nmag_centre_y = 0",
                "mag_range_x is 0, must not be zero"},
        BadLine{"mag_correlation = 1\nmag_centre_x = 0\nmag_centre_y = 0\nmag_range_x = 1\n"
                "mag_range_y = 1",
                "mag_correlation is 1, must be between -1 and 1"},
        BadLine{"gyro_drift_time_s = 0\ngyro_drift_c1_rad_s = 0\ngyro_drift_c2_rad_s = 0",
                "gyro_drift_time_s is 0, must be positive"},
        BadLine{"gyro_bias_rad_s = nan", "gyro_bias_rad_s is nan, must be a finite number"},
        BadLine{"heading_source = \"compass\"", "heading_source must be \"gyro\" or \"encoders\""},
        BadLine{"heading_source = 1", "heading_source must be \"gyro\" or \"encoders\""},
        BadLine{"encoder_counter_bits = 4",
                "encoder_counter_bits must be a whole number from 8 to 63"},
        BadLine{"encoder_counter_bits = 16.5",
                "encoder_counter_bits must be a whole number from 8 to 63"}));

TEST(Vehicle, TellsAMissingFileFromAFolder) {
    EXPECT_EQ(loadVehicle("/nowhere/robot.toml").error().code, ErrorCode::kFileMissing);
    EXPECT_EQ(loadVehicle(std::filesystem::temp_directory_path()).error().code,
              ErrorCode::kFileUnreadable);
}

TEST(Vehicle, RefusesAnImageWithoutCrashing) {
    std::string bytes = "\x89PNG\r\n\x1a\n";
    bytes += std::string("\0\0\0\rIHDR\xff\xfe", 10);
    EXPECT_EQ(errorOf(bytes).code, ErrorCode::kBadFormat);
}

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
}

TEST(Vehicle, RefusesAKeyOfAHundredThousandLevels) {
    for (const char* line : {"a", "[a", "x = {a"}) {
        const Error error = errorOf(std::string(kGood) + line + repeated(".a", 100000) + " = 1\n");
        EXPECT_EQ(error.code, ErrorCode::kBadFormat);
        EXPECT_EQ(error.subject, "robot.toml");
        EXPECT_NE(error.detail.find(" bytes, such a file has 16384 at most"), std::string::npos);
    }
}

TEST(Vehicle, SurvivesTheDeepestKeyThatFits) {
    const Error unknown = errorOf("a" + repeated(".a", 8000) + " = 1\n");
    EXPECT_EQ(unknown.subject, "robot.toml:1");
    for (const char* nested : {"[", "[[", "{", "a = [", "a = {a = ", "[\n", "a = [\n"}) {
        EXPECT_EQ(errorOf(repeated(nested, 1600)).code, ErrorCode::kBadFormat) << nested;
    }
}

// The library's own assertions end the program at such texts.
TEST(Vehicle, SurvivesWhatTheLibraryAsserts) {
    for (const char* text : {"[+a]", "a = +é", "é = 1", "[é.+]", "a.é = 1"}) {
        EXPECT_FALSE(parseVehicle(text, "robot.toml")) << text;
    }
    const auto named = parseVehicle(std::string(kGood) + "# Größe\n", "robot.toml");
    EXPECT_TRUE(named);
}

double anyPositive() {
    return std::ldexp(1.0 + *rc::gen::inRange(0, 1 << 30) * 0x1p-30, *rc::gen::inRange(-39, 29));
}

RC_GTEST_PROP(Vehicle, SurvivesItsTextToTheLastBit, ()) {
    Vehicle vehicle;
    vehicle.name = *rc::gen::container<std::string>(rc::gen::inRange<char>(0x00, 0x7F));
    vehicle.geometry = {anyPositive(), anyPositive(), anyPositive(), anyPositive()};
    vehicle.heading_source = *rc::gen::element(HeadingSource::kGyro, HeadingSource::kEncoders);
    vehicle.encoder_counter_bits = *rc::gen::inRange(8, 64);
    vehicle.gyro_scale = anyPositive();
    if (*rc::gen::arbitrary<bool>()) vehicle.gyro_bias_rad_s = -anyPositive();
    vehicle.gyro_noise_rad_s_sqrthz = std::min(anyPositive(), 10.0);
    vehicle.gyro_bias_walk_rad_s_sqrts = std::min(anyPositive(), 10.0);
    vehicle.max_speed_m_s = anyPositive();
    if (*rc::gen::arbitrary<bool>())
        vehicle.gyro_drift = {anyPositive(), -anyPositive(), anyPositive()};
    if (*rc::gen::arbitrary<bool>())
        vehicle.magnetometer = {anyPositive(), -anyPositive(), anyPositive(), -anyPositive(),
                                *rc::gen::element(0.0, 0.3, -0.999)};
    const auto read = parseVehicle(formatVehicle(vehicle), "text");
    RC_ASSERT(read.has_value());
    RC_ASSERT(*read == vehicle);
}

TEST(Vehicle, HasThePresetsOfTheThreePapers) {
    std::vector<std::string> names;
    for (const Vehicle& vehicle : vehiclePresets()) names.push_back(vehicle.name);
    EXPECT_EQ(names, (std::vector<std::string>{"packbot", "labmate", "romi"}));
}

TEST(Vehicle, HasPresetsThatAreTheShippedFiles) {
    for (const Vehicle& vehicle : vehiclePresets()) {
        const auto file = loadVehicle(HEDR_SOURCE_DIR "/assets/vehicles/" + vehicle.name + ".toml");
        ASSERT_TRUE(file);
        EXPECT_EQ(*file, vehicle);
    }
}

TEST(Vehicle, NamesThePresetsWhereThereIsNeitherFileNorPreset) {
    EXPECT_EQ(loadVehicleOrPreset("romi").value().name, "romi");
    const auto none = loadVehicleOrPreset("nopreset");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().subject, "nopreset");
    for (const char* name : {"packbot", "labmate", "romi"}) {
        EXPECT_NE(none.error().detail.find(name), std::string::npos) << name;
    }
}

TEST(Vehicle, HasAPackbotWhoseBiasWalksAsTheFileSays) {
    const Vehicle packbot = vehiclePresets().front();
    EXPECT_NEAR(packbot.gyro_bias_walk_rad_s_sqrts * 180.0 / 3.14159265358979, 0.004, 1e-12);
    EXPECT_EQ(packbot.geometry.ticks_per_revolution, 36.0);
}

TEST(Vehicle, ReadsEveryRecordedOne) {
    if (!std::filesystem::exists(kRecordings)) GTEST_SKIP() << kRecordings << " is not here";
    int count = 0;
    for (const auto& folder : std::filesystem::directory_iterator(kRecordings)) {
        const auto file = folder.path() / "vehicle.toml";
        if (!std::filesystem::exists(file)) continue;
        const auto vehicle = loadVehicle(file);
        ASSERT_TRUE(vehicle) << vehicle.error().subject << ": " << vehicle.error().detail;
        ++count;
    }
    EXPECT_GT(count, 10);
}

}  // namespace
}  // namespace hedr
