#include "core/fusion/heading_hypothesis.h"

#include <algorithm>
#include <cmath>

namespace hedr {

namespace {

double squared(double x) { return x * x; }

double turnVariance(const MotionSegment& segment, const DrivingModel& model) {
    const double unheard_s = segment.dt_s - segment.heard_s;
    return squared(model.turn_noise_rad_sqrts) * segment.heard_s +
           squared(model.witness_noise_rad_sqrts) * unheard_s +
           squared(model.unheard_share * segment.unheard_swing_rad) +
           squared(model.turn_noise_rad_sqrtm) * segment.path_m +
           squared(model.turn_noise_rad_sqrtrad) * segment.swing_rad;
}

constexpr double kShortestPath_m = 0.01;
constexpr double kSwerve = 2.5;  // in sigmas: a driver goes round a person, a wheel slips
constexpr double kNudge = 4.0;   // somebody touches a standing robot

}  // namespace

HeadingHypothesis::HeadingHypothesis(const Pose<World>& start, double grid_sigma_rad,
                                     double bias_rad_s, const DrivingModel& model)
    : bias_walk_rad_s_sqrts_(model.bias_walk_rad_s_sqrts) {
    mean_[kX] = start.position.x;
    mean_[kY] = start.position.y;
    mean_[kHeading] = start.heading_rad;
    mean_[kBias] = bias_rad_s;
    mean_[kGrid] = start.heading_rad;
    mean_[kLeg] = start.heading_rad;
    covariance_(kBias, kBias) = squared(model.bias_rad_s);
    covariance_(kScale, kScale) = squared(model.scale);
    covariance_(kCurvature, kCurvature) = squared(model.curvature_rad_m);
    covariance_(kGrid, kGrid) = squared(grid_sigma_rad);
    covariance_(kWitnessScale, kWitnessScale) = squared(model.witness_scale);
    covariance_(kWitnessCurvature, kWitnessCurvature) = squared(model.witness_curvature_rad_m);
}

void HeadingHypothesis::move(const MotionSegment& segment, const DrivingModel& model) {
    const double unscaled = segment.sensed_turn_rad - mean_[kBias] * segment.heard_s -
                            mean_[kCurvature] * segment.distance_m;
    const double turn = (1.0 + mean_[kScale]) * unscaled;
    const double middle = mean_[kHeading] + 0.5 * (turn - segment.turn_rad);
    const double c = std::cos(middle);
    const double s = std::sin(middle);
    const double dx = c * segment.displacement.x - s * segment.displacement.y;
    const double dy = s * segment.displacement.x + c * segment.displacement.y;
    mean_[kX] += dx;
    mean_[kY] += dy;
    mean_[kLateral] += segment.distance_m * std::sin(mean_[kHeading] + 0.5 * turn - mean_[kLeg]);
    mean_[kHeading] += turn;

    // The Jacobian differs from one in few rows; P = F P F' in two passes over them.
    const double by_bias = -segment.heard_s;
    const double by_curvature = -segment.distance_m;
    const double along = segment.distance_m;
    const auto pass = [&](auto&& line) {
        const auto turned =
            (by_bias * line(kBias) + unscaled * line(kScale) + by_curvature * line(kCurvature))
                .eval();
        const auto halfway = (line(kHeading) + 0.5 * turned).eval();
        line(kX) += -dy * halfway;
        line(kY) += dx * halfway;
        line(kLateral) += along * (halfway - line(kLeg));
        line(kHeading) += turned;
    };
    pass([this](int i) { return covariance_.row(i); });
    pass([this](int i) { return covariance_.col(i); });

    const double slip_variance = squared(model.slip_sqrtm) * segment.path_m;
    const double turn_variance = turnVariance(segment, model);
    mean_[kTurnError] = 0.0;
    covariance_.row(kTurnError).setZero();
    covariance_.col(kTurnError).setZero();
    covariance_(kTurnError, kTurnError) = turn_variance;
    covariance_(kTurnError, kHeading) = turn_variance;
    covariance_(kHeading, kTurnError) = turn_variance;
    covariance_(kHeading, kHeading) += turn_variance;
    covariance_(kBias, kBias) += squared(bias_walk_rad_s_sqrts_) * segment.dt_s;
    covariance_(kCurvature, kCurvature) +=
        squared(model.curvature_walk_rad_m_sqrtm) * segment.path_m;
    covariance_(kX, kX) += slip_variance * c * c;
    covariance_(kX, kY) += slip_variance * c * s;
    covariance_(kY, kX) += slip_variance * c * s;
    covariance_(kY, kY) += slip_variance * s * s;
}

void HeadingHypothesis::loosen(double sigma_rad) {
    covariance_(kHeading, kHeading) += squared(sigma_rad);
}

void HeadingHypothesis::loosenGrid(double sigma_rad) {
    covariance_(kGrid, kGrid) += squared(sigma_rad);
}

double HeadingHypothesis::measure(const Measurement& m) {
    const StateVector spread = covariance_ * m.row;
    const double expected_variance = m.row.dot(spread) + m.variance;
    const double sigmas = std::abs(m.innovation) / std::sqrt(expected_variance);
    const double excess = std::max(1.0, sigmas / m.surprise);
    StateVector gain = spread / (excess * expected_variance);
    if (!m.tells_scale) gain[kScale] = 0.0;
    mean_ += gain * m.innovation;
    covariance_ -= gain * spread.transpose() + spread * gain.transpose() -
                   (excess * expected_variance) * gain * gain.transpose();
    const double cost = excess > 1.0 ? m.surprise * (2.0 * sigmas - m.surprise) : squared(sigmas);
    return -0.5 * (cost + std::log(2.0 * kPi * expected_variance));
}

double HeadingHypothesis::hearWitness(const MotionSegment& segment, double noise_rad2_s,
                                      const DrivingModel& model) {
    const double unscaled = segment.sensed_turn_rad - mean_[kBias] * segment.heard_s;
    const double turn = (1.0 + mean_[kScale]) * unscaled;
    const double seen_larger = 1.0 + mean_[kWitnessScale];
    Measurement m;
    m.row[kBias] = -seen_larger * segment.heard_s;
    m.row[kScale] = unscaled;
    m.row[kWitnessScale] = turn;
    m.row[kWitnessCurvature] = segment.distance_m;
    m.row[kTurnError] = seen_larger;
    m.innovation = segment.witness_turn_rad - seen_larger * turn -
                   mean_[kWitnessCurvature] * segment.distance_m;
    m.variance = noise_rad2_s * segment.dt_s + squared(model.witness_slip * segment.swing_rad);
    m.surprise = kSwerve;
    return measure(m);
}

double HeadingHypothesis::standStill(const MotionSegment& segment, const DrivingModel& model) {
    covariance_(kBias, kBias) += squared(bias_walk_rad_s_sqrts_) * segment.dt_s;
    if (model.turn_from_encoders || segment.heard_s < segment.dt_s) return 0.0;
    Measurement m;
    m.row[kBias] = segment.dt_s;
    m.innovation = segment.sensed_turn_rad - mean_[kBias] * segment.heard_s;
    m.variance = squared(model.turn_noise_rad_sqrts) * segment.dt_s;
    m.surprise = kNudge;
    m.tells_scale = false;
    return measure(m);
}

double HeadingHypothesis::hearDirection(double direction_rad, double sigma_rad) {
    Measurement m;
    m.row[kGrid] = 1.0;
    m.innovation = -deviationFromGrid(mean_[kGrid] - direction_rad, 0.5 * kPi);
    m.variance = squared(sigma_rad);
    return measure(m);
}

double HeadingHypothesis::beginLegAlong(double offset_rad, const DrivingModel& model) {
    mean_[kLeg] = mean_[kGrid] + offset_rad;
    covariance_.row(kLeg) = covariance_.row(kGrid);
    covariance_.col(kLeg) = covariance_.col(kGrid);
    covariance_(kLeg, kLeg) = covariance_(kGrid, kGrid) + squared(model.crooked_corridor_rad);
    placeInMiddle(model);
    // No surprise is forgiven here: it is what tells a corridor from another way.
    Measurement m;
    m.row[kHeading] = 1.0;
    m.row[kLeg] = -1.0;
    m.innovation = mean_[kLeg] - mean_[kHeading];
    m.variance = squared(model.zigzag_rad);
    return measure(m);
}

void HeadingHypothesis::beginFreeLeg(const DrivingModel& model) {
    mean_[kLeg] = mean_[kHeading];
    covariance_.row(kLeg) = covariance_.row(kHeading);
    covariance_.col(kLeg) = covariance_.col(kHeading);
    covariance_(kLeg, kLeg) = covariance_(kHeading, kHeading) + squared(model.zigzag_rad);
    placeInMiddle(model);
}

void HeadingHypothesis::placeInMiddle(const DrivingModel& model) {
    mean_[kLateral] = 0.0;
    covariance_.row(kLateral).setZero();
    covariance_.col(kLateral).setZero();
    covariance_(kLateral, kLateral) = squared(model.lateral_m);
}

HeadingHypothesis::Measurement HeadingHypothesis::unexpectedOnLeg(const MotionSegment& segment,
                                                                  const DrivingModel& model,
                                                                  double steering_rad_m) const {
    const double keep = std::exp(-segment.path_m / model.zigzag_m);
    const double fade = 1.0 - keep;
    const double direction = segment.distance_m < 0.0 ? -1.0 : 1.0;
    const double turn = segment.sensed_turn_rad - mean_[kBias] * segment.heard_s -
                        mean_[kCurvature] * segment.distance_m + mean_[kTurnError];
    Measurement m;
    m.row[kHeading] = fade;
    m.row[kLeg] = -fade;
    m.row[kLateral] = direction * fade * steering_rad_m;
    m.row[kBias] = -keep * segment.heard_s;
    m.row[kCurvature] = -keep * segment.distance_m;
    m.row[kTurnError] = keep;
    m.innovation = -(fade * (mean_[kHeading] - mean_[kLeg]) + keep * turn +
                     direction * fade * steering_rad_m * mean_[kLateral]);
    m.variance = squared(model.zigzag_rad) * (1.0 - keep * keep);
    m.surprise = kSwerve;
    // Small turns say nothing about the scale, but one that shrinks them would seem likelier.
    m.tells_scale = false;
    return m;
}

double HeadingHypothesis::driveLegAlong(const MotionSegment& segment, const DrivingModel& model) {
    if (segment.path_m < kShortestPath_m) return 0.0;
    // The steering towards the middle that makes `lateral_m` of this zigzag.
    const double steering = model.zigzag_m * squared(model.zigzag_rad / model.lateral_m);
    return measure(unexpectedOnLeg(segment, model, steering));
}

double HeadingHypothesis::driveFreeLeg(const MotionSegment& segment, double wander_rad_sqrtm,
                                       const DrivingModel& model) {
    if (segment.path_m < kShortestPath_m) return 0.0;
    covariance_(kLeg, kLeg) += squared(wander_rad_sqrtm) * segment.path_m;
    return measure(unexpectedOnLeg(segment, model, 0.0));
}

double HeadingHypothesis::fromGridVariance() const {
    return covariance_(kHeading, kHeading) - 2.0 * covariance_(kHeading, kGrid) +
           covariance_(kGrid, kGrid);
}

void HeadingHypothesis::absorb(const HeadingHypothesis& other, double own_share) {
    const StateVector apart = other.mean_ - mean_;
    const double other_share = 1.0 - own_share;
    mean_ += other_share * apart;
    covariance_ = own_share * covariance_ + other_share * other.covariance_ +
                  own_share * other_share * apart * apart.transpose();
}

}  // namespace hedr
