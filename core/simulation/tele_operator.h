#pragma once

#include <optional>

#include "core/simulation/box_task.h"
#include "core/simulation/delayed_steering.h"
#include "core/simulation/drive.h"
#include "core/simulation/route.h"

namespace hedr {

// A robot and the human who steers it by its camera: he snakes along the corridor, corrects when he
// comes near a wall, cuts corners or turns on the spot and overshoots, and halts to look around.
class TeleOperator {
  public:
    TeleOperator(const Building& building, const DriveStyle& style, double step_s, Random& random);

    void step();
    const Pose<Floor>& pose() const { return pose_; }
    bool atTask() const { return phase_ == Phase::kAtTask; }

  private:
    enum class Phase { kStanding, kDriving, kHalting, kSpinning, kAtTask, kHome };

    struct Leg {
        std::size_t from = 0;
        std::size_t to = 0;
        double heading_rad = 0.0;  // continuous over all legs
        double length_m = 0.0;
    };

    // How the robot goes from this leg to the next one.
    struct Corner {
        std::size_t next = 0;
        double speed_m_s = 0.0;   // 0 turns on the spot, or halts at home
        double distance_m = 0.0;  // before the corner's middle where the turn begins
        double turn_rate_rad_s = 0.0;
        bool last = false;  // the robot has come home
        bool task = false;  // there is work to do here
    };

    // Position in the leg's own axes.
    double along() const;
    double lateral() const;

    void stand();
    void drive();
    void halt();
    void spin();
    void work();
    void leaveTask();

    Leg legBetween(std::size_t from, std::size_t to) const;
    Corner planCorner();
    void enterNextLeg();
    double budget_m() const;
    double courseError() const;
    double steer();
    void scheduleHalt();
    void move(double speed_m_s, double yaw_rate_rad_s);

    CorridorGraph corridors_;
    DriveStyle style_;
    double step_s_;
    Random& random_;
    Route route_;
    std::optional<std::size_t> goal_;  // until he has been there
    std::optional<Route> way_to_goal_;
    bool task_at_goal_;
    std::optional<BoxTask> task_;
    DelayedSteering steering_;
    double time_s_ = 0.0;
    Pose<Floor> pose_{};
    double speed_m_s_ = 0.0;
    double yaw_rate_rad_s_ = 0.0;
    double turn_rate_rad_s_ = 1.0;  // the most that he steers on this leg
    Leg leg_{};
    Corner corner_{};
    Phase phase_ = Phase::kStanding;
    double standing_until_s_ = 0.0;
    double halt_at_s_ = 0.0;
    double overshoot_rad_ = 0.0;
};

}  // namespace hedr
