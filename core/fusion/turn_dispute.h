#pragma once

namespace hedr {

// Whether the gyro and the wheels tell the same of the robot's turns. Wheels slip, so that a turn
// is a third larger or smaller to them; but where they differ by more than half, turn after turn,
// one of the two is broken, and nobody knows which.
class TurnDispute {
  public:
    void add(double gyro_turn_rad, double wheel_turn_rad, double dt_s);
    bool lasting() const { return in_a_row_ >= kTurnsForADispute; }

  private:
    static constexpr int kTurnsForADispute = 3;

    void judge();

    double time_s_ = 0.0;
    double gyro_rad_ = 0.0;
    double wheels_rad_ = 0.0;
    int in_a_row_ = 0;
};

}  // namespace hedr
