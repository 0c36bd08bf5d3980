#include "core/fusion/compass.h"

#include <gtest/gtest.h>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

Motion seeing(double x, double y, double distance_m = 0.0) {
    return {.dt_s = 0.1, .distance_m = distance_m, .magnetic_field = MagneticField{x, y, 9.0}};
}

TEST(Compass, TurnsCounterClockwiseWhileTheFieldTurnsClockwiseInTheRobot) {
    Compass compass(0.5, {});
    EXPECT_NEAR(compass.heading(seeing(1.0, 0.0), 0.0).value(), 0.5, 1e-12);
    compass.heading(seeing(1.0, 0.0, 0.1), 0.0);
    // The field, straight ahead before, comes from the right: the robot has turned left.
    EXPECT_NEAR(compass.heading(seeing(0.0, -1.0), 0.0).value(), 0.5 + kPi / 2.0, 1e-12);
    EXPECT_NEAR(compass.heading(seeing(-1.0, 0.0), 0.0).value(), 0.5 - kPi, 1e-12);
}

TEST(Compass, FirstSeenOnTheWayTakesTheHeadingThatIsBelieved) {
    Compass compass(0.5, {});
    EXPECT_FALSE(compass.heading({.dt_s = 0.1, .distance_m = 1.0}, 0.5));
    EXPECT_NEAR(compass.heading(seeing(1.0, 1.0), 2.0).value(), 2.0, 1e-12);
    EXPECT_NEAR(compass.heading(seeing(1.0, 1.0), -1.0).value(), 2.0, 1e-12);
}

TEST(Compass, AFieldThatPointsNowhereIsNone) {
    Compass compass(0.0, {0.1, 0.2, 1e-300, 1.0});
    EXPECT_FALSE(compass.heading(seeing(0.1, 0.2), 0.0));
    EXPECT_FALSE(compass.heading(seeing(1e300, 0.0), 0.0));  // over its range
}

}  // namespace
}  // namespace hedr
