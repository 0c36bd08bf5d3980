#include "core/simulation/box_task.h"

#include <algorithm>
#include <cmath>

namespace hedr {

namespace {

constexpr double kSide_m = 2.0;
constexpr double kBehind_m = 0.8;  // before he pushes
constexpr double kSpeed_m_s = 0.3;
constexpr double kTurnRate_rad_s = radFromDeg(35.0);
constexpr double kAligned_rad = radFromDeg(2.0);

double directionTo(Point<Floor> target, const Pose<Floor>& pose) {
    const Vector<Floor> way = target - pose.position;
    return pose.heading_rad + wrapAngle(std::atan2(way.y, way.x) - pose.heading_rad);
}

}  // namespace

BoxTask::BoxTask(const Pose<Floor>& start, double duration_s, Random& random)
    : middle_(start.position),
      square_rad_(random.uniform(-kPi, kPi)),
      left_s_(duration_s),
      from_(start.position) {}

std::optional<DriveCommand> BoxTask::next(const Pose<Floor>& pose, double step_s, Random& random) {
    left_s_ -= step_s;
    if (left_s_ < 0.0) return std::nullopt;
    switch (phase_) {
        case Phase::kTurning:
            return turn(pose, random);
        case Phase::kDriving:
            return drive(pose, random);
        case Phase::kLooking:
            looking_s_ -= step_s;
            if (looking_s_ < 0.0) plan(pose, random);
            return DriveCommand{};
    }
    return std::nullopt;
}

// A push ends with backing off; after some pushes the box is at the next corner.
void BoxTask::plan(const Pose<Floor>& pose, Random& random) {
    phase_ = Phase::kTurning;
    sign_ = 1.0;
    if (move_ == Move::kPush) {
        move_ = Move::kBackOff;
        heading_rad_ = pose.heading_rad + radFromDeg(random.uniform(-12.0, 12.0));
        sign_ = -1.0;
        way_m_ = random.uniform(0.3, 0.8);
    } else if (move_ == Move::kBackOff && pushes_left_ == 0) {
        move_ = Move::kApproach;
        ++side_;
        pushes_left_ = 2 + static_cast<int>(random.uniform(0.0, 3.0));
        aimAt(behindCorner(), pose, random);
    } else {
        move_ = Move::kPush;
        --pushes_left_;
        const double along = square_rad_ + 0.5 * kPi * static_cast<double>(side_);
        heading_rad_ = pose.heading_rad + wrapAngle(along - pose.heading_rad) +
                       radFromDeg(random.uniform(-15.0, 15.0));
        way_m_ = random.uniform(0.4, 1.2);
    }
}

Point<Floor> BoxTask::behindCorner() const {
    const double along = square_rad_ + 0.5 * kPi * static_cast<double>(side_);
    const double half = 0.5 * kSide_m;
    const Vector<Floor> ahead{std::cos(along), std::sin(along)};
    const Vector<Floor> right{std::sin(along), -std::cos(along)};
    return middle_ + half * right + (-(half + kBehind_m)) * ahead;
}

void BoxTask::aimAt(Point<Floor> target, const Pose<Floor>& pose, Random& random) {
    heading_rad_ = directionTo(target, pose) + radFromDeg(random.uniform(-5.0, 5.0));
    way_m_ = (target - pose.position).length();
}

DriveCommand BoxTask::turn(const Pose<Floor>& pose, Random& random) {
    const double error = heading_rad_ - pose.heading_rad;
    if (std::abs(error) > kAligned_rad)
        return {0.0, std::clamp(4.0 * error, -kTurnRate_rad_s, kTurnRate_rad_s)};
    phase_ = Phase::kDriving;
    from_ = pose.position;
    heading_rad_ += radFromDeg(random.uniform(-3.0, 3.0));
    return {};
}

DriveCommand BoxTask::drive(const Pose<Floor>& pose, Random& random) {
    if ((pose.position - from_).length() < way_m_) {
        const double error = heading_rad_ - pose.heading_rad;
        return {sign_ * kSpeed_m_s, std::clamp(2.0 * error, -0.3, 0.3)};
    }
    phase_ = Phase::kLooking;
    looking_s_ = random.uniform(0.3, 3.0);
    return {};
}

}  // namespace hedr
