#include "core/fusion/turn_dispute.h"

#include <gtest/gtest.h>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

// Corridors, with a turn of 90 degrees every half minute, as the two tell it.
bool inDispute(int turns, double gyro_share, double wheel_share) {
    TurnDispute dispute;
    for (int turn = 0; turn < turns; ++turn) {
        for (int i = 0; i < 54; ++i) dispute.add(0.0, 0.0, 0.5);
        for (int i = 0; i < 6; ++i) {
            const double turn_rad = radFromDeg(15.0);
            dispute.add(gyro_share * turn_rad, wheel_share * turn_rad, 0.5);
        }
    }
    return dispute.lasting();
}

TEST(TurnDispute, IsNoneWhereWheelsSlip) {
    EXPECT_FALSE(inDispute(20, 1.0, 1.0));
    EXPECT_FALSE(inDispute(20, 1.0, 1.4));
    EXPECT_FALSE(inDispute(20, 1.0, 0.6));
}

TEST(TurnDispute, IsOneAfterThreeTurnsWithADeadGyro) {
    EXPECT_FALSE(inDispute(2, 0.0, 1.0));
    EXPECT_TRUE(inDispute(4, 0.0, 1.0));
}

TEST(TurnDispute, IsOneWhereTheGyroIsMountedUpsideDown) { EXPECT_TRUE(inDispute(4, -1.0, 1.0)); }

TEST(TurnDispute, EndsWithATurnOnWhichTheyAgree) {
    TurnDispute dispute;
    for (int i = 0; i < 4; ++i) dispute.add(0.0, 1.5, 10.0);
    EXPECT_TRUE(dispute.lasting());
    dispute.add(1.5, 1.5, 10.0);
    EXPECT_FALSE(dispute.lasting());
}

}  // namespace
}  // namespace hedr
