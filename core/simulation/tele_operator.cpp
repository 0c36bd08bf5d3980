#include "core/simulation/tele_operator.h"

#include <algorithm>
#include <cmath>

namespace hedr {

namespace {

constexpr double kAcceleration_m_s2 = 0.5;
constexpr double kAngularAcceleration_rad_s2 = 4.0;
constexpr double kSteering_1_s = 4.0;     // yaw rate per course error
constexpr double kTurning_rad = 0.25;     // a course error that is a corner, not snaking
constexpr double kHaltClearance_m = 2.0;  // no halts near corners
constexpr double kSpinEnd_rad = 0.01;
constexpr double kStandingSpeed_m_s = 0.01;

// He hardly minds being off the middle, but minds a wall.
double towardsMiddle(double lateral_m) {
    const double course = 0.06 * lateral_m + 0.12 * lateral_m * lateral_m * lateral_m;
    return -std::clamp(course, -0.35, 0.35);
}

double approach(double value, double target, double most) {
    return value + std::clamp(target - value, -most, most);
}

}  // namespace

TeleOperator::TeleOperator(const Building& building, const DriveStyle& style, double step_s,
                           Random& random)
    : corridors_(building.corridors),
      style_(style),
      step_s_(step_s),
      random_(random),
      route_(building.corridors, building.home),
      goal_(building.goal),
      task_at_goal_(building.task_at_goal),
      steering_(style.zigzag_rad, step_s),
      standing_until_s_(style.standing_start_s) {
    if (goal_) way_to_goal_.emplace(building.corridors, *goal_);
    leg_ = legBetween(building.start, building.first_towards);
    pose_ = {corridors_.nodes[building.start], leg_.heading_rad};
    corner_ = planCorner();
    steering_.setVideoLag(random_.uniform(0.0, style_.video_lag_s));
}

void TeleOperator::step() {
    switch (phase_) {
        case Phase::kStanding:
            stand();
            break;
        case Phase::kDriving:
            drive();
            break;
        case Phase::kHalting:
            halt();
            break;
        case Phase::kSpinning:
            spin();
            break;
        case Phase::kAtTask:
            work();
            break;
        case Phase::kHome:
            move(0.0, 0.0);
            break;
    }
    time_s_ += step_s_;
}

void TeleOperator::stand() {
    move(0.0, 0.0);
    if (time_s_ + step_s_ < standing_until_s_) return;
    phase_ = Phase::kDriving;
    scheduleHalt();
}

void TeleOperator::drive() {
    const bool turning = std::abs(courseError()) > kTurning_rad;
    const double left_m = leg_.length_m - along() - corner_.distance_m;
    const double corner_speed = corner_.speed_m_s;
    // He brakes half as hard as the robot can, so that it follows.
    const double braking = corner_speed * corner_speed + kAcceleration_m_s2 * std::max(left_m, 0.0);
    const double wanted = std::min(turning ? 0.6 * style_.speed_m_s : style_.speed_m_s,
                                   left_m > 0.0 ? std::sqrt(braking) : corner_speed);
    move(wanted, steer());
    if (left_m <= 0.01 && corner_.last) {
        phase_ = Phase::kHome;
    } else if (left_m <= 0.01 && corner_.task) {
        task_.emplace(pose_, style_.task_s, random_);
        phase_ = Phase::kAtTask;
    } else if (left_m <= 0.01 && (corner_speed > 0.0 || speed_m_s_ < kStandingSpeed_m_s)) {
        enterNextLeg();
    } else if (time_s_ > halt_at_s_ && along() > kHaltClearance_m && left_m > kHaltClearance_m) {
        phase_ = Phase::kHalting;
    }
}

// Turns are driven by feel, the straight is kept by what he sees.
double TeleOperator::steer() {
    const double error = courseError();
    double rate = kSteering_1_s * error;
    if (std::abs(error) > kTurning_rad) {
        steering_.lookAnew();
    } else {
        rate = steering_.yawRate_rad_s(error, random_);
    }
    return std::clamp(rate, -turn_rate_rad_s_, turn_rate_rad_s_);
}

void TeleOperator::halt() {
    steering_.lookAnew();
    move(0.0, 0.0);
    if (speed_m_s_ > 0.0 || yaw_rate_rad_s_ != 0.0) return;
    standing_until_s_ = time_s_ + random_.uniform(5.0, 20.0);
    phase_ = Phase::kStanding;
}

void TeleOperator::spin() {
    const double error = leg_.heading_rad + overshoot_rad_ - pose_.heading_rad;
    steering_.lookAnew();
    move(0.0, std::clamp(kSteering_1_s * error, -turn_rate_rad_s_, turn_rate_rad_s_));
    if (std::abs(error) > kSpinEnd_rad) return;
    phase_ = Phase::kDriving;
    corner_ = planCorner();
}

void TeleOperator::work() {
    const auto command = task_->next(pose_, step_s_, random_);
    if (!command) return leaveTask();
    move(command->speed_m_s, command->yaw_rate_rad_s);
}

// He looks for the way out, and drives there at whatever angle it lies.
void TeleOperator::leaveTask() {
    task_.reset();
    const std::size_t here = *goal_;
    goal_.reset();
    const auto next = route_.next(leg_.from, here, budget_m(), random_);
    leg_.heading_rad = pose_.heading_rad;
    leg_ = legBetween(here, next.value_or(leg_.from));
    overshoot_rad_ = radFromDeg(random_.uniform(-5.0, 5.0));
    phase_ = Phase::kSpinning;
}

double TeleOperator::along() const {
    const Vector<Floor> d = pose_.position - corridors_.nodes[leg_.from];
    return d.x * std::cos(leg_.heading_rad) + d.y * std::sin(leg_.heading_rad);
}

double TeleOperator::lateral() const {
    const Vector<Floor> d = pose_.position - corridors_.nodes[leg_.from];
    return d.y * std::cos(leg_.heading_rad) - d.x * std::sin(leg_.heading_rad);
}

double TeleOperator::courseError() const {
    return leg_.heading_rad + towardsMiddle(lateral()) - pose_.heading_rad;
}

TeleOperator::Leg TeleOperator::legBetween(std::size_t from, std::size_t to) const {
    const Vector<Floor> d = corridors_.nodes[to] - corridors_.nodes[from];
    const double turn = wrapAngle(std::atan2(d.y, d.x) - leg_.heading_rad);
    return {from, to, leg_.heading_rad + turn, d.length()};
}

// Halts, corners and detours cost about a sixth of the time.
double TeleOperator::budget_m() const {
    return 0.85 * style_.speed_m_s * (style_.duration_s - time_s_) - (leg_.length_m - along());
}

TeleOperator::Corner TeleOperator::planCorner() {
    const double turn_rate = radFromDeg(random_.uniform(30.0, 60.0));
    // There is nothing to choose on the way to the goal.
    const bool to_goal = goal_ && time_s_ > style_.goal_after_s;
    const bool at_goal = to_goal && leg_.to == *goal_;
    if (at_goal && task_at_goal_) return {.turn_rate_rad_s = turn_rate, .task = true};
    if (at_goal) goal_.reset();
    const auto next = to_goal && !at_goal ? way_to_goal_->next(leg_.from, leg_.to, 0.0, random_)
                                          : route_.next(leg_.from, leg_.to, budget_m(), random_);
    if (!next) return {.turn_rate_rad_s = turn_rate, .last = true};
    const Leg after = legBetween(leg_.to, *next);
    if (std::abs(after.heading_rad - leg_.heading_rad) < kTurning_rad) {
        return {.next = *next, .speed_m_s = style_.speed_m_s, .turn_rate_rad_s = turn_rate};
    }
    if (random_.uniform() < style_.spin_share) {
        return {
            .next = *next, .distance_m = random_.uniform(-0.3, 0.3), .turn_rate_rad_s = turn_rate};
    }
    const double speed = 0.6 * style_.speed_m_s;
    return {.next = *next,
            .speed_m_s = speed,
            .distance_m = speed / turn_rate,
            .turn_rate_rad_s = turn_rate};
}

void TeleOperator::enterNextLeg() {
    const double before_rad = leg_.heading_rad;
    leg_ = legBetween(leg_.to, corner_.next);
    turn_rate_rad_s_ = corner_.turn_rate_rad_s;
    steering_.setVideoLag(random_.uniform(0.0, style_.video_lag_s));
    if (corner_.speed_m_s > 0.0) {
        corner_ = planCorner();
        return;
    }
    const double side = leg_.heading_rad > before_rad ? 1.0 : -1.0;
    overshoot_rad_ = side * radFromDeg(random_.uniform(3.0, 10.0));
    phase_ = Phase::kSpinning;
}

void TeleOperator::scheduleHalt() {
    halt_at_s_ = time_s_ + style_.stop_every_s * random_.uniform(0.5, 1.5);
}

void TeleOperator::move(double speed_m_s, double yaw_rate_rad_s) {
    speed_m_s_ = approach(speed_m_s_, speed_m_s, kAcceleration_m_s2 * step_s_);
    yaw_rate_rad_s_ =
        approach(yaw_rate_rad_s_, yaw_rate_rad_s, kAngularAcceleration_rad_s2 * step_s_);
    const double middle = pose_.heading_rad + 0.5 * yaw_rate_rad_s_ * step_s_;
    pose_.position = pose_.position + Vector<Floor>{speed_m_s_ * step_s_ * std::cos(middle),
                                                    speed_m_s_ * step_s_ * std::sin(middle)};
    pose_.heading_rad += yaw_rate_rad_s_ * step_s_;
}

}  // namespace hedr
