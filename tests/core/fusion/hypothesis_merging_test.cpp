#include "core/fusion/hypothesis_merging.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hedr {
namespace {

constexpr double kWalk = radFromDeg(0.004);

WeightedHypothesis hypothesisAt(double heading_deg, double weight, double walk = kWalk) {
    const DrivingModel model{.bias_walk_rad_s_sqrts = walk};
    const HeadingHypothesis hypothesis({{}, radFromDeg(heading_deg)}, radFromDeg(2.0), 0.0, model);
    return {hypothesis, std::log(weight)};
}

TEST(MergeClose, MakesOneOfTwoThatSayTheSame) {
    std::vector hypotheses{hypothesisAt(10.0, 0.6), hypothesisAt(10.0, 0.4)};
    mergeClose(hypotheses);
    ASSERT_EQ(hypotheses.size(), 1u);
    EXPECT_NEAR(hypotheses.front().weight(), 1.0, 1e-12);
    EXPECT_NEAR(degFromRad(hypotheses.front().hypothesis.heading_rad()), 10.0, 1e-9);
}

TEST(MergeClose, KeepsThoseThatDiffer) {
    std::vector hypotheses{hypothesisAt(0.0, 0.5), hypothesisAt(10.0, 0.5)};
    mergeClose(hypotheses);
    EXPECT_EQ(hypotheses.size(), 2u);
}

TEST(MergeClose, KeepsThoseThatBelieveInAnotherGyroOrInNoBuilding) {
    std::vector hypotheses{hypothesisAt(0.0, 0.4), hypothesisAt(0.0, 0.3, 4.0 * kWalk),
                           hypothesisAt(0.0, 0.3)};
    hypotheses.back().building = false;
    mergeClose(hypotheses);
    EXPECT_EQ(hypotheses.size(), 3u);
}

}  // namespace
}  // namespace hedr
