#include "radio/link/sensor_rate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hedr {
namespace {

using Advice = SensorRate::Advice;

// What is advised while so many reports come each second; looked at every 16 ms.
std::vector<Advice> advised(SensorRate& rate, double from_s, double to_s, double reports_per_s) {
    std::vector<Advice> all;
    for (double now_s = from_s; now_s < to_s; now_s += 0.016) {
        const auto reports = static_cast<std::uint64_t>(reports_per_s * now_s);
        const Advice advice = rate.look(now_s, reports);
        if (advice != Advice::kNone) all.push_back(advice);
    }
    return all;
}

TEST(SensorRate, AsksAFewTimesAndThenWarnsOnce) {
    SensorRate rate;
    const auto all = advised(rate, 0.0, 120.0, 4.0);
    EXPECT_EQ(all, (std::vector{Advice::kAsk, Advice::kAsk, Advice::kAsk, Advice::kWarn}));
    EXPECT_NEAR(rate.rate_hz(), 4.0, 0.4);
}

TEST(SensorRate, IsContentWhereEnoughComes) {
    SensorRate rate;
    EXPECT_TRUE(advised(rate, 0.0, 60.0, 20.0).empty());
    EXPECT_TRUE(advised(rate, 60.0, 90.0, 100.0).empty());
}

TEST(SensorRate, DoesNotWarnOfARobotThatDoesWhatItIsAsked) {
    SensorRate rate;
    EXPECT_EQ(advised(rate, 100.0, 104.0, 4.0), std::vector{Advice::kAsk});
    EXPECT_TRUE(advised(rate, 104.0, 160.0, 20.0).empty());
}

TEST(SensorRate, DoesNotBlameTheRobotForOutagesOfTheRadio) {
    SensorRate rate;
    std::uint64_t reports = 0;
    int warnings = 0;
    for (double now_s = 0.0; now_s < 300.0; now_s += 0.05) {
        if (std::fmod(now_s, 20.0) < 5.0) continue;  // nothing comes
        warnings += rate.look(now_s, ++reports) == Advice::kWarn ? 1 : 0;
    }
    EXPECT_EQ(warnings, 0);
}

TEST(SensorRate, AsksAgainAfterARestart) {
    SensorRate rate;
    (void)advised(rate, 0.0, 60.0, 4.0);
    rate.startAgain();
    EXPECT_EQ(advised(rate, 60.0, 64.0, 4.0), std::vector{Advice::kAsk});
}

}  // namespace
}  // namespace hedr
