#include "core/simulation/romi_rectangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hedr {
namespace {

TEST(RomiRectangle, IsClosedAndClockwiseAndOfTheSizeOfThePaper) {
    const SimulatedMission mission = simulate(RomiRectangle{}, 1);
    Point<World> most{};
    for (const TrackPoint& point : mission.truth) {
        most.x = std::max(most.x, point.pose.position.x);
        most.y = std::max(most.y, point.pose.position.y);
    }
    EXPECT_NEAR(most.x, 0.6, 1e-9);
    EXPECT_NEAR(most.y, 1.0, 1e-9);
    const Pose<World>& end = mission.truth.back().pose;
    EXPECT_NEAR((end.position - mission.start.position).length(), 0.0, 1e-9);
    EXPECT_NEAR(end.heading_rad, mission.start.heading_rad - 2.0 * kPi, 1e-9);
    // About 2,000 rows of 10 ms for the way itself.
    EXPECT_NEAR(static_cast<double>(mission.truth.size()), 2000.0 + 350.0, 300.0);
}

// The path is that of the line; what the wheels count and what the file says differs.
TEST(RomiRectangle, PutsTheErrorsWhereThePaperDoes) {
    const RomiRectangle plain{.unevenness_m_sqrtm = 0.0};
    RomiRectangle wide = plain;
    wide.wheelbase_error_m = 0.008;
    RomiRectangle taped = plain;
    taped.left_wheel_error_m = 0.002;
    const SimulatedMission normal = simulate(plain, 2);
    const SimulatedMission with_wide = simulate(wide, 2);
    const SimulatedMission with_tape = simulate(taped, 2);
    EXPECT_NEAR(with_wide.vehicle.geometry.wheelbase_m, 0.148, 1e-12);
    EXPECT_EQ(with_wide.sensors, normal.sensors);
    EXPECT_EQ(with_tape.vehicle, normal.vehicle);
    EXPECT_EQ(with_tape.truth, normal.truth);
    const auto counts = [](const SimulatedMission& mission) {
        return std::get<WheelTicks>(mission.sensors.back().odometry);
    };
    EXPECT_EQ(counts(with_tape).right, counts(normal).right);
    EXPECT_NEAR(static_cast<double>(counts(with_tape).left),
                static_cast<double>(counts(normal).left) * 70.0 / 72.0, 1.5);
}

double compassErrorDeg(const SimulatedMission& mission, std::size_t sample) {
    const MagnetometerRange& range = mission.vehicle.magnetometer.value();
    const MagneticField& field = mission.sensors[sample].magnetic_field.value();
    const double ahead = (field.x - range.centre_x) / range.range_x;
    const double left = (field.y - range.centre_y) / range.range_y;
    const double from_north = std::atan2(-left, ahead);
    return degFromRad(
        wrapAngle(from_north + mission.start.heading_rad - mission.truth[sample].pose.heading_rad));
}

TEST(RomiRectangle, HasACompassThatErrsBesideTheIron) {
    const SimulatedMission mission = simulate({.soft_iron = 0.0, .magnetic_noise = 0.0}, 3);
    double on_first_side = 0.0;
    double beside_iron = 0.0;
    for (std::size_t i = 0; i < mission.sensors.size(); ++i) {
        const auto [x, y] = mission.truth[i].pose.position;
        const double error = std::abs(compassErrorDeg(mission, i));
        if (x < 0.01) on_first_side = std::max(on_first_side, error);
        if (x > 0.59) beside_iron = std::max(beside_iron, error);
    }
    EXPECT_LT(on_first_side, 2.0);
    EXPECT_GT(beside_iron, 20.0);
}

TEST(RomiRectangle, HasACompassThatIsRightFarFromIron) {
    const SimulatedMission mission =
        simulate({.soft_iron = 0.0, .magnetic_noise = 0.0, .disturbance = 0.0}, 3);
    for (std::size_t i = 0; i < mission.sensors.size(); ++i)
        ASSERT_NEAR(compassErrorDeg(mission, i), 0.0, 1e-9);
}

}  // namespace
}  // namespace hedr
