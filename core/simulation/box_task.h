#pragma once

#include <cstddef>
#include <optional>

#include "core/geometry/angle.h"
#include "core/geometry/frames.h"
#include "core/simulation/random.h"
#include "core/site/floor_plan.h"

namespace hedr {

struct DriveCommand {
    double speed_m_s = 0.0;
    double yaw_rate_rad_s = 0.0;
};

// Pushing a box around a square of 2 m, as in Run 4 of the HEDR paper: many short pushes along its
// sides, each followed by backing off and aligning anew. The square lies at any angle.
class BoxTask {
  public:
    BoxTask(const Pose<Floor>& start, double duration_s, Random& random);

    // What the operator commands now; none once the time is over.
    std::optional<DriveCommand> next(const Pose<Floor>& pose, double step_s, Random& random);

  private:
    enum class Phase { kTurning, kDriving, kLooking };
    enum class Move { kApproach, kPush, kBackOff };

    void plan(const Pose<Floor>& pose, Random& random);
    void aimAt(Point<Floor> target, const Pose<Floor>& pose, Random& random);
    Point<Floor> behindCorner() const;
    DriveCommand turn(const Pose<Floor>& pose, Random& random);
    DriveCommand drive(const Pose<Floor>& pose, Random& random);

    Point<Floor> middle_;
    double square_rad_;  // direction of its first side
    double left_s_;
    std::size_t side_ = 0;
    int pushes_left_ = 0;
    Move move_ = Move::kBackOff;
    Phase phase_ = Phase::kLooking;
    double looking_s_ = 1.0;
    double heading_rad_ = 0.0;  // wanted
    double sign_ = 1.0;         // forward or backward
    double way_m_ = 0.0;        // of this move
    Point<Floor> from_{};
};

}  // namespace hedr
