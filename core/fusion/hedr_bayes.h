#pragma once

#include <optional>

#include "core/fusion/hypothesis_set.h"
#include "core/fusion/leg_detector.h"
#include "core/fusion/noise_density.h"
#include "core/fusion/turn_dispute.h"
#include "core/robot/motion.h"

namespace hedr {

struct HedrBayesConfig {
    HeadingSource heading_source = HeadingSource::kGyro;
    DrivingModel model{};
    LegDetector::Config leg{};
    std::optional<double> known_bias_rad_s{};
    std::optional<double> direction_rad{};  // heading of one corridor; none: learnt
    bool learn_gyro_noise = false;  // while it stands, for the vehicle file does not tell it
};

HedrBayesConfig hedrBayesPreset(const Vehicle& vehicle);

// What the filter makes of the building, for the operator.
struct BayesStatus {
    LegKind leg = LegKind::kNone;
    bool searching = false;  // the building's direction has not been found yet
    bool lost = false;       // it is not known any more, or cannot be found, or a sensor is broken
    double bias_rad_s = 0.0;
    double share = 1.0;
    double sigma_rad = 0.0;
    std::size_t hypotheses = 0;

    bool alongCorridor() const {
        return !searching && (leg == LegKind::kCorridor || leg == LegKind::kDiagonal);
    }
};

// HEDR as a Bayesian filter: see docs/estimators/hedr_bayes.md. Several hypotheses about the
// building's direction and the heading sensor's drift are kept while the driving does not decide.
class HedrBayes {
  public:
    HedrBayes(const Pose<World>& start, const HedrBayesConfig& config);

    void update(const Motion& motion);
    // The heading of one corridor, from a plan; none: what was told was wrong.
    void setDirection(std::optional<double> direction_rad);
    const Pose<World>& pose() const { return pose_; }
    double gyro_bias_rad_s() const { return belief_.bias_rad_s; }
    // x, y, heading; as of the last decision, a fraction of a second ago.
    const Eigen::Matrix3d& covariance() const { return belief_.covariance; }
    BayesStatus status() const;

  private:
    MotionSegment::Step stepOf(const Motion& motion);
    void closeSegment();
    void stand();
    void endStanding();
    void learnGyroNoise(const MotionSegment& segment);
    void drive(const MotionSegment& segment);
    void hearWitness(const MotionSegment& segment);
    void followLeg(const MotionSegment& segment);
    void learnSnaking(const MotionSegment& segment);
    bool sure() const;

    HedrBayesConfig config_;
    HypothesisSet hypotheses_;
    Belief belief_;
    LegDetector legs_;
    NoiseDensity gyro_noise_;
    NoiseDensity witness_noise_;
    NoiseDensity snaking_;
    TurnDispute dispute_;
    double leg_heading_rad_ = 0.0;  // since the leg began

    MotionSegment segment_{};
    bool segment_standing_ = false;
    bool segment_witnessed_ = true;
    std::optional<MotionSegment> stood_{};  // it may have been the last one before it moved
    Pose<World> segment_start_;
    Pose<World> pose_;
    double driven_m_ = 0.0;
    bool found_ = false;
    double unsure_s_ = 0.0;
};

}  // namespace hedr
