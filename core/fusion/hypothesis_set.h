#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/fusion/heading_hypothesis.h"

namespace hedr {

enum class LegKind : unsigned char { kNone, kCorridor, kDiagonal, kOwn };

// What all hypotheses say together.
struct Belief {
    Pose<World> pose{};
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // x, y, heading; of the mixture
    double bias_rad_s = 0.0;
    double scale = 0.0;
    double curvature_rad_m = 0.0;
    double share = 1.0;      // weight of those that agree on the heading
    double sigma_rad = 0.0;  // of the heading against the building
    LegKind leg = LegKind::kNone;
    bool building = true;  // false: dead reckoning only
};

// Hypotheses about the building's direction, with weights. Each leg is along a corridor, diagonal
// to the corridors, or has a direction of its own, as a whole: every choice is followed up, until
// later legs decide.
class HypothesisSet {
  public:
    HypothesisSet(const Pose<World>& start, double bias_rad_s, const DrivingModel& model);

    void move(const MotionSegment& segment);
    void loosen(double sigma_rad);
    void standStill(const MotionSegment& segment);
    void beginLeg();
    void driveLeg(const MotionSegment& segment);
    void endLeg();

    const Belief& belief() const { return belief_; }
    std::size_t size() const { return hypotheses_.size(); }
    // Sums up what the hypotheses say; `shown` is where the robot was said to be until now.
    void summarise(const Pose<World>& shown);

  private:
    struct Weighted {
        HeadingHypothesis hypothesis;
        double log_weight = 0.0;
        LegKind leg = LegKind::kNone;       // of the leg that it drives
        LegKind last = LegKind::kCorridor;  // of the leg before
        bool building = true;               // false: nothing here runs in few directions
    };

    void addChildren(const Weighted& parent, std::vector<Weighted>& children) const;
    void normalise();
    void merge();
    std::pair<std::size_t, std::size_t> cheapestPair() const;
    double shareNear(const Pose<World>& pose) const;
    const Weighted& chosen(const Pose<World>& shown) const;
    void spreadAround(const HeadingHypothesis::StateVector& mean);

    DrivingModel model_;
    std::vector<Weighted> hypotheses_;
    Belief belief_{};
};

}  // namespace hedr
