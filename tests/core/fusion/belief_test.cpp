#include "core/fusion/belief.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hedr {
namespace {

WeightedHypothesis hypothesisAt(double heading_deg, double weight, bool building = true) {
    const HeadingHypothesis hypothesis({{}, radFromDeg(heading_deg)}, radFromDeg(1.0), 0.0,
                                       DrivingModel{});
    return {hypothesis, std::log(weight), LegKind::kCorridor, LegKind::kCorridor, building};
}

double shownDeg(const std::vector<WeightedHypothesis>& hypotheses) {
    return degFromRad(beliefOf(hypotheses, {}).pose.heading_rad);
}

TEST(Belief, IsTheMeanOfThoseThatLieInOneQuarter) {
    EXPECT_NEAR(shownDeg({hypothesisAt(0.0, 0.75), hypothesisAt(4.0, 0.25)}), 1.0, 1e-9);
}

TEST(Belief, LeavesThoseOfAnotherQuarterToTheCovariance) {
    const std::vector hypotheses{hypothesisAt(0.0, 0.75), hypothesisAt(90.0, 0.25)};
    const Belief belief = beliefOf(hypotheses, {});
    EXPECT_NEAR(degFromRad(belief.pose.heading_rad), 0.0, 1e-9);
    EXPECT_NEAR(degFromRad(std::sqrt(belief.covariance(2, 2))), 45.0, 0.5);
    EXPECT_NEAR(belief.share, 0.75, 1e-9);
}

TEST(Belief, SwitchesOnlyToWhatIsClearlyLikelier) {
    EXPECT_NEAR(shownDeg({hypothesisAt(0.0, 0.4), hypothesisAt(90.0, 0.6)}), 0.0, 1e-9);
    EXPECT_NEAR(shownDeg({hypothesisAt(0.0, 0.2), hypothesisAt(90.0, 0.8)}), 90.0, 1e-9);
}

TEST(Belief, TrustsNoBuildingWhereNoneStandsOut) {
    const std::vector hypotheses{hypothesisAt(-90.0, 0.4), hypothesisAt(90.0, 0.4),
                                 hypothesisAt(0.0, 0.2, false)};
    const Belief belief = beliefOf(hypotheses, {});
    EXPECT_FALSE(belief.building);
    EXPECT_NEAR(degFromRad(belief.pose.heading_rad), 0.0, 1e-9);
    EXPECT_NEAR(belief.building_share, 0.8, 1e-9);
}

}  // namespace
}  // namespace hedr
