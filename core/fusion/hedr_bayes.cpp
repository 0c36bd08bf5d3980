#include "core/fusion/hedr_bayes.h"

#include <cmath>

namespace hedr {

namespace {

constexpr double kSegment_s = 0.5;
constexpr double kLongestStep_s = 2.0;
constexpr double kGapDrift_rad_s = radFromDeg(1.0);  // nobody watched
constexpr double kMostGapDrift_rad = radFromDeg(30.0);
constexpr double kSureShare = 0.7;
constexpr double kSureSigma_rad = radFromDeg(8.0);
constexpr double kUnsure_s = 10.0;  // a turn may make it unsure for shorter
constexpr double kSearch_m = 30.0;  // after so much driving it should have been found

}  // namespace

HedrBayesConfig hedrBayesPreset(const Vehicle& vehicle) {
    HedrBayesConfig config;
    config.heading_source = vehicle.heading_source;
    DrivingModel& model = config.model;
    if (vehicle.heading_source == HeadingSource::kEncoders) {
        model.turn_from_encoders = true;
        model.zigzag_rad = radFromDeg(2.5);
        model.lateral_m = 0.2;
        model.turn_noise_rad_sqrts = 0.0;
        model.turn_noise_rad_sqrtm = radFromDeg(2.0);
        model.turn_noise_rad_sqrtrad = radFromDeg(4.0);
        model.bias_rad_s = 1e-6;
        model.bias_walk_rad_s_sqrts = 0.0;
        model.scale = 0.02;
        model.curvature_rad_m = radFromDeg(0.7);
        model.curvature_walk_rad_m_sqrtm = radFromDeg(0.1);
    } else {
        if (vehicle.gyro_noise_rad_s_sqrthz > 0.0)
            model.turn_noise_rad_sqrts = vehicle.gyro_noise_rad_s_sqrthz;
        if (vehicle.gyro_bias_walk_rad_s_sqrts > 0.0)
            model.bias_walk_rad_s_sqrts = vehicle.gyro_bias_walk_rad_s_sqrts;
        if (vehicle.gyro_bias_rad_s) model.bias_rad_s = radFromDeg(0.05);
    }
    config.known_bias_rad_s = vehicle.gyro_bias_rad_s;
    return config;
}

HedrBayes::HedrBayes(const Pose<World>& start, const HedrBayesConfig& config)
    : config_(config),
      hypotheses_(start, config.known_bias_rad_s.value_or(0.0), config.model),
      legs_(config.leg),
      segment_start_(start),
      pose_(start) {}

double HedrBayes::sensedTurn(const Motion& motion) const {
    const bool gyro = config_.heading_source == HeadingSource::kGyro;
    if (motion.gyro_turn_rad && (gyro || !motion.odometry_turn_rad))
        return *motion.gyro_turn_rad + motion.gyro_bias_rad_s * motion.dt_s;
    return motion.odometry_turn_rad.value_or(0.0);
}

void HedrBayes::update(const Motion& motion) {
    if (segment_.dt_s > 0.0 && motion.standing != segment_standing_) closeSegment();
    segment_standing_ = motion.standing;
    const Belief& belief = hypotheses_.belief();
    const double sensed = sensedTurn(motion);
    const double drift =
        belief.bias_rad_s * motion.dt_s + belief.curvature_rad_m * motion.distance_m;
    segment_.add(motion.dt_s, motion.distance_m, sensed,
                 motion.standing ? 0.0 : (1.0 + belief.scale) * (sensed - drift));
    const Point<World> at = rigidTransform<World, Robot>(segment_start_) *
                            Point<Robot>{segment_.displacement.x, segment_.displacement.y};
    pose_ = {at, segment_start_.heading_rad + segment_.turn_rad};
    if (segment_.dt_s > kSegment_s - 0.5 * motion.dt_s) closeSegment();
}

void HedrBayes::closeSegment() {
    if (segment_standing_) {
        hypotheses_.standStill(segment_);
    } else {
        hypotheses_.move(segment_);
        const auto change = legs_.add(segment_);
        if (change == LegDetector::Change::kEnded) hypotheses_.endLeg();
        if (change == LegDetector::Change::kBegun) {
            hypotheses_.beginLeg();
        } else if (legs_.onLeg()) {
            hypotheses_.driveLeg(segment_);
        }
        if (segment_.dt_s > kLongestStep_s)
            hypotheses_.loosen(std::min(kGapDrift_rad_s * segment_.dt_s, kMostGapDrift_rad));
    }
    hypotheses_.summarise(pose_);
    driven_m_ += segment_.path_m;
    found_ = found_ || sure();
    unsure_s_ = sure() ? 0.0 : unsure_s_ + segment_.dt_s;
    segment_ = {};
    segment_start_ = pose_ = hypotheses_.belief().pose;
}

double HedrBayes::gyro_bias_rad_s() const { return hypotheses_.belief().bias_rad_s; }

bool HedrBayes::sure() const {
    const Belief& belief = hypotheses_.belief();
    return belief.building && belief.share > kSureShare && belief.sigma_rad < kSureSigma_rad;
}

BayesStatus HedrBayes::status() const {
    const Belief& belief = hypotheses_.belief();
    const bool searching = !found_ && driven_m_ < kSearch_m;
    return {.leg = belief.leg,
            .searching = searching,
            .lost = !searching && unsure_s_ > kUnsure_s,
            .bias_rad_s = belief.bias_rad_s,
            .share = belief.share,
            .sigma_rad = belief.sigma_rad,
            .hypotheses = hypotheses_.size()};
}

}  // namespace hedr
