#include "core/fusion/hedr_bayes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hedr {

namespace {

constexpr double kSegment_s = 0.5;
constexpr double kStandingSegment_s = 0.25;
constexpr double kLongestStep_s = 2.0;
constexpr double kGapDrift_rad_s = radFromDeg(1.0);  // nobody watched
constexpr double kMostGapDrift_rad = radFromDeg(30.0);

constexpr double kSureShare = 0.7;
constexpr double kSureSigma_rad = radFromDeg(5.0);
constexpr double kUnsure_s = 10.0;  // a turn may make it unsure for shorter
constexpr double kSearch_m = 30.0;  // after so much driving it should have been found

// A gyro of which nothing is known is taken for a noisy one while it stands, so that its bias is
// not believed too early, and never for a better one than the usual: driving shakes it.
constexpr double kUsualGyroNoise_rad_sqrts = DrivingModel{}.turn_noise_rad_sqrts;
constexpr double kNoisyGyro_rad_sqrts = radFromDeg(0.15);
constexpr double kNoisiestGyro_rad_sqrts = radFromDeg(0.3);

constexpr double kWitnessBlock_s = 2.0;
constexpr double kSnakingBlock_m = 2.5;
constexpr double kSteadiest_rad = radFromDeg(0.5);
constexpr double kWildest_rad = radFromDeg(6.0);

constexpr double kUnknownWalk_rad_s_sqrts = radFromDeg(0.003);
constexpr double kWorseWalk = 4.0;
constexpr double kCalibratedBias_rad_s = radFromDeg(0.05);

double squared(double x) { return x * x; }

DrivingModel encodersModel() {
    DrivingModel model;
    model.turn_from_encoders = true;
    model.turn_noise_rad_sqrts = 0.0;
    model.turn_noise_rad_sqrtm = radFromDeg(2.0);
    model.turn_noise_rad_sqrtrad = radFromDeg(4.0);
    model.bias_rad_s = 1e-6;
    model.bias_walk_rad_s_sqrts = 0.0;
    model.scale = 0.02;
    model.curvature_rad_m = radFromDeg(0.7);
    model.curvature_walk_rad_m_sqrtm = radFromDeg(0.1);
    model.zigzag_rad = radFromDeg(2.5);
    model.zigzag_m = 1.5;
    model.lateral_m = 0.2;
    model.wander_rad_sqrtm = 0.0;  // they bend more than any driver
    model.bent_share = 0.0;
    model.crooked_corridor_rad = radFromDeg(0.3);
    return model;
}

DrivingModel gyroModel(const Vehicle& vehicle) {
    DrivingModel model;
    if (vehicle.gyro_noise_rad_s_sqrthz > 0.0)
        model.turn_noise_rad_sqrts = vehicle.gyro_noise_rad_s_sqrthz;
    if (vehicle.gyro_bias_walk_rad_s_sqrts > 0.0) {
        model.bias_walk_rad_s_sqrts = vehicle.gyro_bias_walk_rad_s_sqrts;
    } else {
        model.bias_walk_rad_s_sqrts = kUnknownWalk_rad_s_sqrts;
        model.worse_walk = kWorseWalk;
    }
    if (vehicle.gyro_bias_rad_s) {
        model.bias_rad_s = kCalibratedBias_rad_s;
    } else {
        model.calibrated_bias_rad_s = kCalibratedBias_rad_s;
    }
    return model;
}

}  // namespace

HedrBayesConfig hedrBayesPreset(const Vehicle& vehicle) {
    const bool encoders = vehicle.heading_source == HeadingSource::kEncoders;
    return {.heading_source = vehicle.heading_source,
            .model = encoders ? encodersModel() : gyroModel(vehicle),
            .known_bias_rad_s = vehicle.gyro_bias_rad_s,
            .learn_gyro_noise = !encoders && !(vehicle.gyro_noise_rad_s_sqrthz > 0.0)};
}

HedrBayes::HedrBayes(const Pose<World>& start, const HedrBayesConfig& config)
    : config_(config),
      hypotheses_(start, config.known_bias_rad_s.value_or(0.0), config.model),
      belief_(hypotheses_.belief(start)),
      legs_(config.leg),
      gyro_noise_({.block_span = kStandingSegment_s,
                   .prior = squared(kNoisyGyro_rad_sqrts),
                   .prior_weight = 2.0,
                   .most_weight = 100.0}),
      witness_noise_({.block_span = kWitnessBlock_s,
                      .prior = squared(config.model.witness_noise_rad_sqrts),
                      .prior_weight = 4.0,
                      .most_weight = 60.0}),
      snaking_({.block_span = kSnakingBlock_m,
                .prior = 2.0 * squared(config.model.zigzag_rad) * config.model.zigzag_m,
                .prior_weight = 10.0,
                .most_weight = 60.0}),
      segment_start_(start),
      pose_(start) {
    if (const auto direction_rad = std::exchange(config_.direction_rad, std::nullopt))
        setDirection(direction_rad);
}

void HedrBayes::setDirection(std::optional<double> direction_rad) {
    const bool told_before = config_.direction_rad.has_value();
    config_.direction_rad = direction_rad;
    if (direction_rad) {
        hypotheses_.hearDirection(*direction_rad, told_before);
    } else if (told_before) {
        hypotheses_.forgetDirection();
    }
}

MotionSegment::Step HedrBayes::stepOf(const Motion& motion) {
    const bool by_gyro = motion.gyro_turn_rad && (config_.heading_source == HeadingSource::kGyro ||
                                                  !motion.odometry_turn_rad);
    const bool silent = by_gyro && motion.gyro_silent;
    const double heard_s = silent ? 0.0 : motion.dt_s;
    const double sensed = by_gyro ? *motion.gyro_turn_rad + motion.gyro_bias_rad_s * heard_s
                                  : motion.odometry_turn_rad.value_or(0.0);
    const double drift = belief_.bias_rad_s * heard_s + belief_.curvature_rad_m * motion.distance_m;
    segment_witnessed_ = segment_witnessed_ && by_gyro && !silent && motion.odometry_turn_rad;
    return {.dt_s = motion.dt_s,
            .distance_m = motion.distance_m,
            .silent = silent,
            .sensed_rad = sensed,
            .believed_rad = (1.0 + belief_.scale) * (sensed - drift),
            .witness_rad = motion.odometry_turn_rad.value_or(0.0)};
}

void HedrBayes::update(const Motion& motion) {
    if (motion.standing != segment_standing_) {
        segment_standing_ = false;
        closeSegment();
        segment_standing_ = motion.standing;
    }
    segment_.add(stepOf(motion));
    if (!motion.standing) {
        const Point<World> at = rigidTransform<World, Robot>(segment_start_) *
                                Point<Robot>{segment_.displacement.x, segment_.displacement.y};
        pose_ = {at, segment_start_.heading_rad + segment_.turn_rad};
    }
    const double full_s = motion.standing ? kStandingSegment_s : kSegment_s;
    if (segment_.dt_s > full_s - 0.5 * motion.dt_s) closeSegment();
}

void HedrBayes::closeSegment() {
    if (segment_standing_) {
        stand();
    } else {
        if (stood_) endStanding();
        if (segment_.dt_s > 0.0) drive(segment_);
    }
    belief_ = hypotheses_.belief(pose_);
    driven_m_ += segment_.path_m;
    found_ = found_ || sure();
    unsure_s_ = sure() ? 0.0 : unsure_s_ + segment_.dt_s;
    segment_ = {};
    segment_witnessed_ = true;
    segment_start_ = pose_ = belief_.pose;
}

// The last quarter of a second before it moves does not count: with coarse encoders a robot has
// turned a little before the first count comes.
void HedrBayes::stand() {
    if (stood_) {
        if (config_.learn_gyro_noise && stood_->heard_s == stood_->dt_s) learnGyroNoise(*stood_);
        hypotheses_.standStill(*stood_, config_.model);
    }
    stood_ = segment_;
}

void HedrBayes::endStanding() {
    gyro_noise_.interrupt();
    hypotheses_.merge();
    drive(*std::exchange(stood_, std::nullopt));
}

void HedrBayes::learnGyroNoise(const MotionSegment& segment) {
    gyro_noise_.add(segment.sensed_turn_rad, segment.dt_s);
    config_.model.turn_noise_rad_sqrts = std::clamp(
        std::sqrt(gyro_noise_.density()), kUsualGyroNoise_rad_sqrts, kNoisiestGyro_rad_sqrts);
}

void HedrBayes::drive(const MotionSegment& segment) {
    hypotheses_.move(segment, config_.model);
    if (segment_witnessed_) hearWitness(segment);
    followLeg(segment);
    if (segment.dt_s > kLongestStep_s)
        hypotheses_.loosen(std::min(kGapDrift_rad_s * segment.dt_s, kMostGapDrift_rad));
}

void HedrBayes::hearWitness(const MotionSegment& segment) {
    dispute_.add(segment.turn_rad, segment.witness_turn_rad, segment.dt_s);
    witness_noise_.add(segment.witness_turn_rad - segment.sensed_turn_rad, segment.dt_s);
    hypotheses_.hearWitness(segment, witness_noise_.density(), config_.model);
}

void HedrBayes::followLeg(const MotionSegment& segment) {
    switch (legs_.add(segment)) {
        case LegDetector::Change::kBegun:
            hypotheses_.beginLeg(config_.model);
            leg_heading_rad_ = 0.0;
            return;
        case LegDetector::Change::kEnded:
            hypotheses_.endLeg();
            snaking_.interrupt();
            return;
        case LegDetector::Change::kNone:
            break;
    }
    if (!legs_.onLeg() || legs_.newGround_m() <= 0.0) return;
    hypotheses_.driveLeg(segment, config_.model);
    if (!config_.model.turn_from_encoders) learnSnaking(segment);
}

// How steadily this driver keeps straight. Encoders are noisier than any driver.
void HedrBayes::learnSnaking(const MotionSegment& segment) {
    leg_heading_rad_ += segment.turn_rad;
    snaking_.add(leg_heading_rad_ * segment.path_m, segment.path_m);
    config_.model.zigzag_rad =
        std::clamp(std::sqrt(snaking_.density() / (2.0 * config_.model.zigzag_m)), kSteadiest_rad,
                   kWildest_rad);
}

bool HedrBayes::sure() const {
    return belief_.building && std::min(belief_.share, belief_.building_share) > kSureShare &&
           belief_.sigma_rad < kSureSigma_rad;
}

BayesStatus HedrBayes::status() const {
    const bool searching = !found_ && driven_m_ < kSearch_m;
    return {.leg = belief_.leg,
            .searching = searching,
            .lost = dispute_.lasting() || (!searching && unsure_s_ > kUnsure_s),
            .bias_rad_s = belief_.bias_rad_s,
            .share = belief_.share,
            .sigma_rad = belief_.sigma_rad,
            .hypotheses = hypotheses_.size()};
}

}  // namespace hedr
