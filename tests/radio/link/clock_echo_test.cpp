#include "radio/link/clock_echo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hedr {
namespace {

constexpr double kNoWrap = std::numeric_limits<double>::infinity();

TEST(ClockEcho, AsksOnceASecond) {
    ClockEcho echo;
    int asked = 0;
    for (double now_s = 100.0; now_s < 110.0; now_s += 0.016)
        asked += echo.requestIfDue(now_s) ? 1 : 0;
    EXPECT_EQ(asked, 10);
}

TEST(ClockEcho, MeasuresTheRoundTripAndTheOffsetOfTheQuickestAnswer) {
    ClockEcho echo;
    const double ways_s[][2] = {{0.300, 0.020}, {0.010, 0.012}, {0.02, 0.4}};
    double now_s = 50.0;
    for (const auto& [there_s, back_s] : ways_s) {
        const auto request = echo.requestIfDue(now_s);
        ASSERT_TRUE(request);
        const double robot_time_s = now_s + there_s - 40.0;
        EXPECT_TRUE(echo.hear({request->token, robot_time_s}, now_s + there_s + back_s, kNoWrap));
        now_s += 1.0;
    }
    EXPECT_NEAR(*echo.roundTrip_s(now_s), 0.42, 1e-9);
    EXPECT_NEAR(*echo.offset_s(), -40.0, 0.0011) << "half the difference of the ways";
    EXPECT_FALSE(echo.roundTrip_s(now_s + 60.0)) << "nothing old is shown";
}

TEST(ClockEcho, ARestartedRobotHasAnotherClock) {
    ClockEcho echo;
    const auto before = echo.requestIfDue(100.0);
    ASSERT_TRUE(echo.hear({before->token, 5000.0}, 100.01, kNoWrap));
    const auto asked = echo.requestIfDue(101.0);
    echo.forgetAnswers();
    EXPECT_FALSE(echo.offset_s());
    EXPECT_FALSE(echo.roundTrip_s(101.0));
    EXPECT_FALSE(echo.hear({asked->token, 5001.0}, 101.3, kNoWrap)) << "from before";
    const auto after = echo.requestIfDue(102.0);
    ASSERT_TRUE(echo.hear({after->token, 2.0}, 102.5, kNoWrap));
    EXPECT_NEAR(*echo.offset_s(), -100.25, 1e-9) << "though the earlier answer was quicker";
}

TEST(ClockEcho, AClockThatWrapsHasItsOffsetAroundZero) {
    ClockEcho echo;
    const auto request = echo.requestIfDue(5000.0);
    ASSERT_TRUE(echo.hear({request->token, std::fmod(5003.0, 4294.967296)}, 5000.02, 4294.967296));
    EXPECT_NEAR(*echo.offset_s(), 2.99, 1e-6);
}

TEST(ClockEcho, AnswersToNothingThatWasAskedDoNotCount) {
    ClockEcho echo;
    EXPECT_FALSE(echo.hear({0, 1.0}, 1.0, kNoWrap));
    const auto request = echo.requestIfDue(1.0);
    EXPECT_FALSE(echo.hear({request->token + 8, 1.0}, 1.1, kNoWrap));
    EXPECT_TRUE(echo.hear({request->token, 1.0}, 1.1, kNoWrap));
    EXPECT_FALSE(echo.hear({request->token, 1.0}, 1.2, kNoWrap)) << "repeated by the radio";
    const auto late = echo.requestIfDue(3.0);
    EXPECT_FALSE(echo.hear({late->token, 1.0}, 9.0, kNoWrap));
}

}  // namespace
}  // namespace hedr
