#include "radio/link/robot_parameters.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

Calibration found(std::vector<FoundParameter> parameters) {
    return {.procedure = "wheels", .found = std::move(parameters)};
}

Vehicle believed() {
    return {.geometry = {.left_wheel_diameter_m = 0.183,
                         .right_wheel_diameter_m = 0.184,
                         .wheelbase_m = 0.65,
                         .ticks_per_revolution = 36.0}};
}

TEST(RobotParameters, AreAllTheWheelsInTheWiresUnits) {
    EXPECT_EQ(robotParametersIn(found({{"wheelbase_m", 0.65, {0.6612344, 0.01}},
                                       {"left_wheel_diameter_m", 0.183, {0.2, 0.1}, true},
                                       {"gyro_scale", 1.0, {1.02, 0.001}}}),
                                believed()),
              (std::vector<ParameterSet>{{1, 183'000}, {2, 184'000}, {3, 661'234}, {4, 36'000}}));
}

TEST(RobotParameters, AreNoneWhereNoWheelChanges) {
    EXPECT_TRUE(robotParametersIn(found({{"wheelbase_m", 0.65, {0.66, 0.01}, true},
                                         {"gyro_scale", 1.0, {1.02, 0.001}}}),
                                  believed())
                    .empty());
}

// A part of them would be wrong with the rest.
TEST(RobotParameters, AreNoneWhereOneDoesNotFit) {
    EXPECT_TRUE(robotParametersIn(found({{"wheelbase_m", 0.65, {0.66, 0.01}},
                                         {"left_wheel_diameter_m", 0.1, {1e9, 1.0}}}),
                                  believed())
                    .empty());
}

}  // namespace
}  // namespace hedr
