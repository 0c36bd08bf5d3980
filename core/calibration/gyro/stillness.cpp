#include "core/calibration/gyro/stillness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/geometry/angle.h"
#include "core/robot/wheel_motion.h"

namespace hedr {

namespace {

constexpr double kLook_s = 0.5;
constexpr double kLearn_s = 2.0;    // until then nothing can be told
constexpr double kUnsure_s = 30.0;  // until then all is looked at again
constexpr double kLookAgain = 1.5;  // whenever there is so many times as much
constexpr double kSettle_s = 0.5;   // rocking on its tyres
constexpr double kLongestGap_s = 2.0;
// Less than one count of coarse encoders; fine ones may go to and fro by one.
constexpr double kStill_m = 1e-4;
constexpr double kStill_rad = radFromDeg(0.02);
// With coarse encoders a robot has turned a little before the first count comes.
constexpr double kBeforeCount_s = 1.0;
constexpr double kBeforeTurn_s = 0.2;

constexpr double kShortestLevel_s = 0.5;  // standing that tells how it was
constexpr double kLevelNoiseOver_s = 0.05;
constexpr double kSlowCalm_s = 10.0;  // a slow turn needs as long to be told from none
constexpr double kAsBefore_rad_s = radFromDeg(0.02);
constexpr double kAsBeforeSigmas = 3.0;
constexpr double kCalmVariance = 1.7;
constexpr double kNewNormal_s = 30.0;  // calm for so long: whatever it was before, this is standing

double calmFor_s(const MotionSign& sign) {
    return sign.kind == MotionSign::Kind::kTurnsSlowly ? kSlowCalm_s : kLearn_s;
}

double marginBefore_s(const MotionSign& sign) {
    return sign.kind == MotionSign::Kind::kCounted ? kBeforeCount_s : kBeforeTurn_s;
}

// What the robot turned with; infinite where it did not.
double meanRate_rad_s(const MotionSign& sign) {
    if (sign.kind == MotionSign::Kind::kTurnsSlowly) return std::abs(sign.rate_rad_s);
    if (sign.kind != MotionSign::Kind::kTurned) return std::numeric_limits<double>::infinity();
    return std::abs(sign.turn_rad) / (sign.until_s - sign.since_s);
}

}  // namespace

void Stillness::add(const GyroSample& sample) {
    if (sample.dt_s > kLongestGap_s) {
        const MotionSign gap{.kind = MotionSign::Kind::kUnwatched,
                             .since_s = sample.t_s - sample.dt_s,
                             .until_s = sample.t_s};
        if (stretch_.blocks() > 0) noteMotion(gap);
        return;
    }
    for (const GyroSample& passed : filter_.add(sample)) {
        if (passed.t_s - passed.dt_s < calm_from_s_) continue;
        stretch_.add(passed);
        if (stretch_.end_s() >= next_look_s_) look();
    }
}

void Stillness::add(double t_s, const Odometry& odometry) {
    if (std::holds_alternative<std::monostate>(odometry)) return;
    if (!wheels_ || wheels_->index() != odometry.index()) wheels_ = odometry;
    const WheelMotion moved = wheelMotionBetween(*wheels_, odometry, vehicle_);
    const double turn_rad = moved.turn_rad.value_or(0.0);
    if (!std::isfinite(moved.distance_m + turn_rad)) return wheels_.reset();
    if (std::abs(moved.distance_m) <= kStill_m && std::abs(turn_rad) <= kStill_rad) return;
    wheels_ = odometry;
    noteMotion({.kind = MotionSign::Kind::kCounted, .since_s = t_s, .until_s = t_s});
}

// At what is new, and again at all of it whenever noise and bias are known much better. A sign that
// goes on is looked at once more before it counts: then its size is known.
void Stillness::look() {
    next_look_s_ = stretch_.end_s() + kLook_s;
    const double duration_s = stretch_.duration_s();
    if (duration_s < kLearn_s) return;
    const bool again = duration_s < kUnsure_s && duration_s >= kLookAgain * looked_at_all_s_;
    const double from_s = again ? stretch_.begin_s() : std::max(looked_s_, stretch_.begin_s());
    const MotionSign sign = strongestHintIn(stretch_, from_s);
    unrest_.push_back({stretch_.end_s(), sign.strength});
    const bool moves = sign.strength > 1.0;
    const bool goes_on = moves && sign.until_s > stretch_.end_s() - kLook_s;
    if (goes_on && !std::exchange(waits_, true)) return;
    waits_ = false;
    looked_s_ = stretch_.end_s();
    if (again) looked_at_all_s_ = duration_s;
    if (moves) return noteSign(sign);
    if (state_ == State::kStands) {
        standing_.back().end_s = stretch_.end_s();
    } else if (state_ == State::kTooEarly || hasSettled()) {
        begin();
    }
}

// What happens right at the beginning only makes it begin later: the robot was just put down.
// Unless it was calm there, at another rate.
void Stillness::noteSign(const MotionSign& sign) {
    const bool at_once = sign.until_s < stretch_.begin_s() + kLearn_s;
    if (state_ == State::kMoves || !at_once || levelBefore(sign)) return noteMotion(sign);
    startAfter(sign.until_s);
    if (state_ == State::kStands) standing_.pop_back();
    state_ = State::kTooEarly;
}

void Stillness::startAfter(double t_s) {
    calm_from_s_ = t_s + kSettle_s;
    stretch_.dropUntil(calm_from_s_);
    looked_at_all_s_ = 0.0;
}

void Stillness::begin() {
    if (!disturbances_.empty()) disturbances_.back().until_s = stretch_.begin_s();
    standing_.push_back({stretch_.begin_s(), stretch_.end_s()});
    state_ = State::kStands;
}

void Stillness::noteMotion(const MotionSign& sign) {
    const bool counted = sign.kind == MotionSign::Kind::kCounted;
    if (state_ == State::kMoves) {
        disturbances_.back().until_s = sign.until_s;
        disturbances_.back().rate_changed = false;
        if (counted) disturbances_.back().sign.kind = sign.kind;
    } else {
        reference_ = levelBefore(sign);
        if (state_ == State::kStands) endStanding(sign);
        const bool slowly = sign.kind == MotionSign::Kind::kTurnsSlowly;
        disturbances_.push_back({sign, sign.until_s, slowly});
    }
    // What the gyro was before tells nothing after a drive, nor if it vibrated before.
    if (counted || (sign.kind == MotionSign::Kind::kVibrates && sign.noise_ratio < 1.0)) {
        reference_.reset();
    }
    state_ = State::kMoves;
    startAfter(sign.until_s);
}

void Stillness::endStanding(const MotionSign& sign) {
    StandingTime& time = standing_.back();
    time.end_s = std::min(time.end_s, sign.since_s - marginBefore_s(sign));
    if (time.duration_s() < kLearn_s) standing_.pop_back();
}

// Where the sign reaches back to the beginning, it is the beginning that differs from the rest:
// this tells as much, if it was as calm.
std::optional<Stillness::Level> Stillness::levelBefore(const MotionSign& sign) const {
    if (stretch_.blocks() == 0) return std::nullopt;
    const double end_s = sign.since_s - marginBefore_s(sign);
    const bool from_the_beginning = end_s < stretch_.begin_s() + kShortestLevel_s;
    const std::size_t after = stretch_.firstEdgeAfter(from_the_beginning ? sign.until_s : end_s);
    if (after < 2 || stretch_.span_s(0, after - 1) < kShortestLevel_s) return std::nullopt;
    const std::size_t last = after - 1;
    const double variance = stretch_.variance(0, last);
    const bool calm = last == stretch_.blocks() ||
                      variance < kCalmVariance * stretch_.variance(last, stretch_.blocks());
    if (from_the_beginning && !calm) return std::nullopt;
    return Level{stretch_.mean_rad_s(0, last), stretch_.span_s(0, last),
                 stretch_.noise_rad_s_sqrthz(kLevelNoiseOver_s), variance};
}

// Nearer to the rate before than half of what it turned with.
bool Stillness::rateIsAsBefore() const {
    if (!reference_) return true;
    const double change_rad_s =
        std::abs(stretch_.mean_rad_s(0, stretch_.blocks()) - reference_->rate_rad_s);
    const double error_rad_s = reference_->noise_rad_s_sqrthz *
                               std::sqrt(1.0 / stretch_.duration_s() + 1.0 / reference_->span_s);
    const MotionSign& sign = disturbances_.back().sign;
    return change_rad_s <
           std::min(kAsBefore_rad_s + kAsBeforeSigmas * error_rad_s, 0.5 * meanRate_rad_s(sign));
}

// Calm by itself for long enough, and as it was before, or for very long.
bool Stillness::hasSettled() {
    Disturbance& last = disturbances_.back();
    if (stretch_.duration_s() < calmFor_s(last.sign)) return false;
    last.rate_changed = !rateIsAsBefore();
    const bool as_noisy = !reference_ || stretch_.variance(0, stretch_.blocks()) <
                                             kCalmVariance * reference_->variance;
    return (as_noisy && !last.rate_changed) || stretch_.duration_s() >= kNewNormal_s;
}

Stillness stillnessIn(std::span<const SensorReport> reports, const GyroSamples& gyro,
                      const Vehicle& vehicle) {
    Stillness stillness(vehicle);
    auto sample = gyro.samples.begin();
    for (const SensorReport& report : reports) {
        if (!std::isfinite(report.robot_time_s)) continue;
        stillness.add(report.robot_time_s, report.odometry);
        if (sample != gyro.samples.end() && sample->t_s == report.robot_time_s) {
            stillness.add(*sample++);
        }
    }
    return stillness;
}

}  // namespace hedr
