#pragma once

#include <cstddef>
#include <vector>

#include "core/fusion/belief.h"
#include "core/fusion/weighted_hypothesis.h"

namespace hedr {

// Hypotheses about the building's direction and the heading sensor, with weights. Each leg is along
// a corridor, diagonal to the corridors, or has a direction of its own, as a whole: every choice is
// followed up, until later legs decide.
class HypothesisSet {
  public:
    HypothesisSet(const Pose<World>& start, double bias_rad_s, const DrivingModel& model);

    void move(const MotionSegment& segment, const DrivingModel& model);
    void hearWitness(const MotionSegment& segment, double noise_rad2_s, const DrivingModel& model);
    void loosen(double sigma_rad);
    // Of one corridor, as a plan tells it; `anew`: an earlier one was wrong.
    void hearDirection(double direction_rad, bool anew);
    void forgetDirection();
    void standStill(const MotionSegment& segment, const DrivingModel& model);
    void beginLeg(const DrivingModel& model);
    void driveLeg(const MotionSegment& segment, const DrivingModel& model);
    void endLeg();
    // Those that have come to say the same become one.
    void merge();

    Belief belief(const Pose<World>& shown) const { return beliefOf(hypotheses_, shown); }
    std::size_t size() const { return hypotheses_.size(); }

  private:
    void normalise();

    std::vector<WeightedHypothesis> hypotheses_;
};

}  // namespace hedr
