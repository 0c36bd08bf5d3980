#include "ui/calibration/sample_collector.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

std::vector<HeardSensors> heard(std::uint64_t boot, double from_s, int count) {
    std::vector<HeardSensors> sensors;
    for (int i = 0; i < count; ++i) sensors.push_back({boot, {.robot_time_s = from_s + i}});
    return sensors;
}

TEST(SampleCollector, GathersASetForEachStartOfTheRobot) {
    SampleCollector samples("live", {});
    samples.add(heard(1, 0.0, 3));
    samples.add(heard(1, 3.0, 2));
    samples.add(heard(2, 0.0, 4));
    ASSERT_EQ(samples.input().sets.size(), 2U);
    EXPECT_EQ(samples.input().sets[0].reports.size(), 5U);
    EXPECT_EQ(samples.input().sets[1].reports.size(), 4U);
    EXPECT_EQ(samples.input().sets[1].origin, "live");
}

TEST(SampleCollector, GathersASetForEachClosedDriveThatIsDone) {
    SampleCollector samples("live", {});
    samples.add(heard(1, 0.0, 3));
    samples.mark();
    EXPECT_TRUE(samples.input().sets.empty()) << "that was on the way to the mark";
    samples.add(heard(1, 3.0, 4));
    EXPECT_TRUE(samples.input().sets.empty()) << "it is under way";
    samples.mark();
    samples.add(heard(1, 7.0, 5));
    ASSERT_EQ(samples.input().sets.size(), 1U);
    EXPECT_EQ(samples.input().sets[0].reports.size(), 4U);
    samples.mark();
    ASSERT_EQ(samples.input().sets.size(), 2U);
    EXPECT_EQ(samples.input().sets[1].reports.front().robot_time_s, 7.0);
}

TEST(SampleCollector, TakesAClosedDriveThatBeganBeforeTheRobotWasHeard) {
    SampleCollector samples("live", {});
    samples.mark();
    samples.add(heard(1, 0.0, 4));
    samples.mark();
    ASSERT_EQ(samples.input().sets.size(), 1U);
    EXPECT_EQ(samples.input().sets[0].reports.size(), 4U);
}

TEST(SampleCollector, ForgetsAClosedDriveOnWhichTheRobotWasRestarted) {
    SampleCollector samples("live", {});
    samples.add(heard(1, 0.0, 1));
    samples.mark();
    samples.add(heard(1, 1.0, 4));
    samples.add(heard(2, 0.0, 4));
    samples.mark();
    EXPECT_TRUE(samples.input().sets.empty());
    samples.add(heard(2, 4.0, 6));
    samples.mark();
    ASSERT_EQ(samples.input().sets.size(), 1U);
    EXPECT_EQ(samples.input().sets[0].reports.size(), 6U);
}

}  // namespace
}  // namespace hedr
