// The magnetometers of real robots and boards.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "core/calibration/compass/compass_errors.h"
#include "core/calibration/compass/magnetometer.h"
#include "core/geometry/angle.h"
#include "core/robot/sensor_csv.h"

namespace hedr {
namespace {

const std::filesystem::path kRecordings = HEDR_SOURCE_DIR "/../shared/data";

std::optional<std::vector<SampleSet>> recorded(const char* name) {
    const auto log = loadSensorLog(kRecordings / name / "sensors.csv");
    if (!log) return std::nullopt;
    return std::vector{SampleSet{name, log->reports}};
}

void tell(const char* name, const Calibration& calibration) {
    std::cout << name << ": " << calibration.reason << '\n';
    for (const FoundParameter& found : calibration.found) {
        std::cout << "  " << found.key << " = " << found.now.value << " ± " << found.now.margin()
                  << '\n';
    }
    for (const EvidenceFigure& figure : calibration.figures) {
        const bool angle = figure.unit == "rad";
        std::cout << "  " << figure.name << ": "
                  << (angle ? degFromRad(figure.value) : figure.value) << ' '
                  << (angle ? "deg" : figure.unit) << '\n';
    }
    for (const std::string& remark : calibration.remarks) std::cout << "  " << remark << '\n';
    if (!calibration.proof) return;
    std::cout << "  proof: " << calibration.proof->before << " before, " << calibration.proof->after
              << " after, " << calibration.proof->parts << " parts, 99 % from "
              << calibration.proof->times_better_99.low << '\n';
}

TEST(RealMagnetometers, TurnedFlatByHandAreCalibrated) {
    const auto sets = recorded("mag_gyro_flat_rotation");
    if (!sets) GTEST_SKIP() << "The recording is absent.";
    const MagnetometerCalibration found = calibrateMagnetometer(*sets, {});
    tell("mag_gyro_flat_rotation", found.calibration);
    // The hand tilted it, in a field that is twice as strong downward as level.
    EXPECT_EQ(found.calibration.verdict, Verdict::kRefused);
    EXPECT_NE(found.calibration.reason.find("It tilted"), std::string::npos);
    ASSERT_TRUE(found.calibration.proof);
    EXPECT_GT(found.calibration.proof->before, radFromDeg(40.0));
    EXPECT_LT(found.calibration.proof->after, radFromDeg(6.5));
}

class RealRoombaMagnetometer : public testing::TestWithParam<const char*> {};

TEST_P(RealRoombaMagnetometer, IsLookedAtWhereItTurnsOnTheSpot) {
    const auto sets = recorded(GetParam());
    if (!sets) GTEST_SKIP() << "The recording is absent.";
    const auto vehicle = loadVehicle(kRecordings / GetParam() / "vehicle.toml");
    ASSERT_TRUE(vehicle);
    const MagnetometerCalibration found = calibrateMagnetometer(*sets, *vehicle);
    tell(GetParam(), found.calibration);
    EXPECT_EQ(found.calibration.verdict, Verdict::kRefused);
}

INSTANTIATE_TEST_SUITE_P(Roombas, RealRoombaMagnetometer,
                         testing::Values("roomba_mag_1_notruth", "roomba_mag_2_notruth",
                                         "mtrn4010_lab"),
                         [](const auto& run) { return std::string(run.param); });

TEST(RealMagnetometers, GiveThePublishedEllipsoid) {
    const auto sets = recorded("magcal_fxos8700");
    if (!sets) GTEST_SKIP() << "The recording is absent.";
    const MagnetometerCalibration found = calibrateMagnetometer(*sets, {});
    tell("magcal_fxos8700", found.calibration);
    ASSERT_TRUE(found.sphere);
    // By its author, with the program Magneto; A is to a factor, which is the unit of the result.
    const Eigen::Vector3d centre(28.557458, -39.981060, -27.428035);
    Eigen::Matrix3d iron;
    iron << 0.989575, -0.022220, 0.005152, -0.022220, 0.989327, 0.022216, 0.005152, 0.022216,
        1.045404;
    iron /= std::cbrt(iron.determinant());
    EXPECT_LT((found.sphere->ellipsoid.centre - centre).cwiseAbs().maxCoeff(), 0.15);
    EXPECT_LT((found.sphere->ellipsoid.iron - iron).cwiseAbs().maxCoeff(), 0.004);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_TRUE(found.sphere->centre.at(axis).interval().contains(
            centre(static_cast<Eigen::Index>(axis))));
    }
}

TEST(RealMagnetometers, OfAWholeSphereHaveOneStrength) {
    const auto sets = recorded("magcal_hmc5883l_sphere");
    if (!sets) GTEST_SKIP() << "The recording is absent.";
    const MagnetometerCalibration found = calibrateMagnetometer(*sets, {});
    tell("magcal_hmc5883l_sphere", found.calibration);
    ASSERT_TRUE(found.sphere);
    // 13.6 % as it came: 0.558 ± 0.076.
    EXPECT_LT(found.sphere->variance, 0.006);
    EXPECT_EQ(found.calibration.verdict, Verdict::kNotProven);
}

}  // namespace
}  // namespace hedr
