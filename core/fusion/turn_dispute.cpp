#include "core/fusion/turn_dispute.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr double kWindow_s = 10.0;
constexpr double kTurn_rad = radFromDeg(45.0);  // less is no turn to speak of
constexpr double kShare = 0.5;

}  // namespace

void TurnDispute::add(double gyro_turn_rad, double wheel_turn_rad, double dt_s) {
    gyro_rad_ += gyro_turn_rad;
    wheels_rad_ += wheel_turn_rad;
    time_s_ += dt_s;
    if (time_s_ < kWindow_s) return;
    judge();
    time_s_ = gyro_rad_ = wheels_rad_ = 0.0;
}

void TurnDispute::judge() {
    const double larger_rad = std::max(std::abs(gyro_rad_), std::abs(wheels_rad_));
    if (larger_rad < kTurn_rad) return;
    const bool agree = std::abs(gyro_rad_ - wheels_rad_) < kShare * larger_rad;
    in_a_row_ = agree ? 0 : in_a_row_ + 1;
}

}  // namespace hedr
