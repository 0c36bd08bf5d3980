#include "radio/link/robot_parameters.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

Calibration found(std::vector<FoundParameter> parameters) {
    return {.procedure = "wheels", .found = std::move(parameters)};
}

TEST(RobotParameters, AreWhatACalibrationChangesInTheWiresUnits) {
    const auto sets = robotParametersIn(found({{"wheelbase_m", 0.65, {0.6612344, 0.01}},
                                               {"right_wheel_diameter_m", 0.183, {0.1841, 0.001}},
                                               {"ticks_per_revolution", 36.0, {72.0, 0.0}},
                                               {"gyro_scale", 1.0, {1.02, 0.001}}}));
    EXPECT_EQ(sets, (std::vector<ParameterSet>{{3, 661'234}, {2, 184'100}, {4, 72'000}}));
}

TEST(RobotParameters, LeaveOutWhatStaysAndWhatDoesNotFit) {
    EXPECT_TRUE(robotParametersIn(found({{"wheelbase_m", 0.65, {0.66, 0.01}, true},
                                         {"left_wheel_diameter_m", 0.1, {1e9, 1.0}}}))
                    .empty());
}

}  // namespace
}  // namespace hedr
