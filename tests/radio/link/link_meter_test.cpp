#include "radio/link/link_meter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hedr {
namespace {

struct Line {
    LinkMeter meter;
    LinkHealth health{};
    std::vector<LinkSample> samples;

    // A frame each 10 ms, on its way for `delay_s`; looked at every 16 ms.
    template <class Delay>
    void run(double from_s, double to_s, Delay delay_s) {
        for (double t_s = from_s; t_s < to_s; t_s += 0.01) {
            ++health.good_frames;
            meter.noteFrames(t_s + delay_s(t_s), t_s);
            look(t_s);
        }
    }
    void look(double now_s) {
        if (const auto sample = meter.sampleIfDue(now_s, health, {})) samples.push_back(*sample);
    }
};

TEST(LinkMeter, TakesASampleOfEachSecond) {
    Line line;
    line.run(0.0, 10.05, [](double) { return 0.02; });
    ASSERT_EQ(line.samples.size(), 10U);
    EXPECT_NEAR(line.samples[5].frames_per_s, 100.0, 1.5);
    EXPECT_EQ(line.samples[5].loss, 0.0);
    EXPECT_NEAR(line.samples[5].longest_gap_s, 0.01, 0.011);
    EXPECT_NEAR(line.samples[9].jitter_s, 0.0, 1e-6);
}

TEST(LinkMeter, JitterIsThatOfTheTimeOnTheWay) {
    Line line;
    bool odd = false;
    line.run(0.0, 5.0, [&](double) { return (odd = !odd) ? 0.004 : 0.0; });
    EXPECT_NEAR(line.samples.back().jitter_s, 0.004, 2e-4);
}

TEST(LinkMeter, LossIsOfThatSecondAndAGapGrowsWhileItLasts) {
    Line line;
    line.run(0.0, 2.0, [](double) { return 0.0; });
    line.health.lost_frames += 100;
    line.run(2.0, 3.01, [](double) { return 0.0; });
    EXPECT_NEAR(line.samples[1].loss, 0.5, 0.01);
    EXPECT_EQ(line.samples[2].loss, 0.0);
    for (double t_s = 3.02; t_s < 8.1; t_s += 0.016) line.look(t_s);
    EXPECT_NEAR(line.samples.back().longest_gap_s, 5.0, 0.1);
    EXPECT_EQ(line.samples.back().frames_per_s, 0.0);
}

TEST(LinkMeter, WhatAMissionThatGoesOnHasHeardBeforeIsNotOfNow) {
    Line line;
    line.health.good_frames = 100'000;
    line.look(0.0);
    line.run(0.01, 1.05, [](double) { return 0.0; });
    ASSERT_EQ(line.samples.size(), 1U);
    EXPECT_NEAR(line.samples[0].frames_per_s, 100.0, 1.5);
}

TEST(LinkMeter, ARestartedRobotsClockIsNoJitter) {
    Line line;
    line.run(1000.0, 1003.0, [](double) { return 0.0; });
    line.meter.noteFrames(1003.1, 0.0);
    line.meter.noteFrames(1004.2, 1.1);
    line.look(1004.3);
    EXPECT_LT(line.samples.back().jitter_s, 1e-3);
}

}  // namespace
}  // namespace hedr
