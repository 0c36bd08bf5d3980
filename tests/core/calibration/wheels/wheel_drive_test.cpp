#include "core/calibration/wheels/wheel_drive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "tests/core/calibration/wheels/simulated_drive.h"

namespace hedr {
namespace {

using test::DriveBench;
using test::DriveOnBench;

const FoundParameter& foundOf(const WheelDrive& wheels, std::string_view key) {
    return *std::ranges::find(wheels.calibration.found, key, &FoundParameter::key);
}

std::string refusalOf(const DriveOnBench& drive) {
    const WheelDrive wheels = calibrateByDriving(drive.sets, drive.believed);
    EXPECT_EQ(wheels.calibration.verdict, Verdict::kRefused);
    return wheels.calibration.reason;
}

template <class Change>
DriveOnBench changed(const DriveBench& bench, const Change& change) {
    DriveOnBench drive = test::driven(bench, 1);
    for (SensorReport& report : drive.sets[0].reports) change(report);
    return drive;
}

TEST(WheelDrive, FindsAWheelbaseAndWheelsThatWereFarOff) {
    const WheelDrive wheels =
        test::calibratedOn({.believed_wheelbase_m = 0.45, .believed_right_larger = 0.04}, 3);
    EXPECT_EQ(wheels.calibration.verdict, Verdict::kAccepted) << wheels.calibration.reason;
    EXPECT_NEAR(foundOf(wheels, "wheelbase_m").now.value, 0.65, 0.04);
    EXPECT_NEAR(foundOf(wheels, "left_wheel_diameter_m").now.value, 0.183, 0.001);
    EXPECT_NEAR(foundOf(wheels, "right_wheel_diameter_m").now.value, 0.183, 0.001);
    EXPECT_GT(wheels.calibration.proof->times_better, 2.0);
}

TEST(WheelDrive, LeavesRightWheelsAlone) {
    const DriveOnBench drive = test::driven({}, 5);
    const WheelDrive wheels = calibrateByDriving(drive.sets, drive.believed);
    EXPECT_EQ(wheels.calibration.verdict, Verdict::kUnchanged) << wheels.calibration.reason;
    const auto vehicle = calibrated(drive.believed, wheels.calibration);
    ASSERT_TRUE(vehicle);
    EXPECT_EQ(*vehicle, drive.believed);
}

TEST(WheelDrive, ChangesWhatIsSurelyBetterOnly) {
    const DriveOnBench drive = test::driven({.believed_wheelbase_m = 0.5}, 7);
    const WheelDrive wheels = calibrateByDriving(drive.sets, drive.believed);
    EXPECT_EQ(wheels.calibration.verdict, Verdict::kAccepted) << wheels.calibration.reason;
    const auto vehicle = calibrated(drive.believed, wheels.calibration);
    ASSERT_TRUE(vehicle);
    EXPECT_NEAR(vehicle->geometry.wheelbase_m, 0.65, 0.04);
    EXPECT_EQ(vehicle->geometry.left_wheel_diameter_m, 0.183);
}

// Twelve percent less three, halved, may be the gyro's scale as well.
TEST(WheelDrive, LeavesAWheelbaseThatTheGyrosScaleMayExplain) {
    const DriveBench bench{.duration_s = 3600.0, .believed_wheelbase_m = 0.65 / 1.12};
    const WheelDrive unsure = test::calibratedOn(bench, 2);
    EXPECT_FALSE(unsure.fit.wheelbase_changes);
    ASSERT_FALSE(unsure.calibration.remarks.empty());
    EXPECT_NE(unsure.calibration.remarks[0].find("scale of a gyro"), std::string::npos);
    DriveBench known = bench;
    known.gyro_scale = 1.02;
    EXPECT_TRUE(test::calibratedOn(known, 2).fit.wheelbase_changes);
}

// A minute of a track that spins in every two.
TEST(WheelDrive, PassesOverTracksThatSpin) {
    const WheelDrive wheels =
        test::calibratedOn({.believed_right_larger = 0.02, .spins_per_min = 1.0}, 4);
    EXPECT_LT(std::abs(wheels.fit.right_larger.value + 0.02), 0.008);
    EXPECT_GT(std::ranges::count(wheels.fit.weights, 0.0), 3);
}

TEST(WheelDrive, TellsAWheelbaseThatGrowsWithTheRateOfTurn) {
    const WheelDrive wheels = test::calibratedOn({.duration_s = 3600.0}, 6);
    ASSERT_GE(wheels.calibration.track_widths.size(), 3U);
    for (const TrackWidth& width : wheels.calibration.track_widths) {
        EXPECT_GE(width.turns, 5U);
        EXPECT_NEAR(width.wheelbase_m.value, 0.65, 0.08);
    }
}

TEST(WheelDrive, NeedsEncodersOfBothSides) {
    const auto silent = changed({.duration_s = 120.0}, [](auto& report) { report.odometry = {}; });
    EXPECT_EQ(refusalOf(silent), "No encoder counts came. Check that the robot sends them.");
    const auto one = changed({.duration_s = 120.0}, [](auto& report) {
        report.odometry = PathTravel{report.robot_time_s};
    });
    EXPECT_EQ(refusalOf(one), "The encoders do not tell the left side from the right one.");
    EXPECT_EQ(refusalOf({}), "No encoder counts came. Check that the robot sends them.");
}

TEST(WheelDrive, NeedsAGyro) {
    const auto drive = changed({.duration_s = 120.0}, [](auto& report) { report.gyro = {}; });
    EXPECT_NE(refusalOf(drive).find("Without a gyro"), std::string::npos);
}

TEST(WheelDrive, IsRefusedWithoutDriving) {
    EXPECT_NE(refusalOf(test::driven({.duration_s = 12.0}, 1)).find("It was driven by"),
              std::string::npos);
    const auto equal = changed({.duration_s = 120.0}, [](auto& report) {
        report.odometry = WheelTicks{5, 5};
        report.gyro = GyroRate{0.01};
    });
    EXPECT_NE(refusalOf(equal).find("It was driven by 0 m only"), std::string::npos);
}

TEST(WheelDrive, IsRefusedWithoutTurns) {
    DriveOnBench drive = test::driven({}, 1);
    std::erase_if(drive.sets[0].reports,
                  [](const SensorReport& report) { return report.robot_time_s > 60.0; });
    EXPECT_NE(refusalOf(drive).find("hardly turned"), std::string::npos);
}

TEST(WheelDrive, IsRefusedWithReadingsThatAreNoNumbers) {
    int count = 0;
    const auto drive = changed({.duration_s = 300.0}, [&count](auto& report) {
        if (++count % 4 == 0) report.gyro = GyroRate{std::numeric_limits<double>::quiet_NaN()};
    });
    EXPECT_NE(refusalOf(drive).find("are no numbers"), std::string::npos);
}

TEST(WheelDrive, IsRefusedWithAGyroAtTheEndOfItsRange) {
    const auto drive = changed({}, [](auto& report) {
        auto& rate_rad_s = std::get<GyroRate>(report.gyro).rad_s;
        rate_rad_s = std::clamp(rate_rad_s, -0.3, 0.3);
    });
    EXPECT_EQ(refusalOf(drive),
              "The gyro was at the end of its range while it turned. Turn slower.");
}

TEST(WheelDrive, SendsTheOperatorToTheEncoderCheck) {
    const auto swapped = changed({}, [](auto& report) {
        auto& ticks = std::get<WheelTicks>(report.odometry);
        std::swap(ticks.left, ticks.right);
    });
    EXPECT_NE(refusalOf(swapped).find("other way round"), std::string::npos);
    const auto silent =
        changed({}, [](auto& report) { std::get<WheelTicks>(report.odometry).left = 0; });
    EXPECT_NE(refusalOf(silent).find("encoder check first"), std::string::npos);
    const auto half =
        changed({}, [](auto& report) { std::get<WheelTicks>(report.odometry).left /= 2; });
    EXPECT_NE(refusalOf(half).find("One wheel counts"), std::string::npos);
}

}  // namespace
}  // namespace hedr
