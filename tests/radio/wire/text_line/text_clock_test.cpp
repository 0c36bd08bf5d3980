#include "radio/wire/text_line/text_clock.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

using Step = TextClock::Step;
constexpr double kMillisPeriod_s = 4294967.296;

TEST(TextClock, RunsOnOverAWrap) {
    TextClock clock;
    EXPECT_EQ(clock.advance(4294967.280, kMillisPeriod_s), Step::kGoesOn);
    EXPECT_EQ(clock.advance(0.004, kMillisPeriod_s), Step::kGoesOn);
    EXPECT_DOUBLE_EQ(clock.time_s(), 4294967.300);
    EXPECT_EQ(clock.advance(0.024, kMillisPeriod_s), Step::kGoesOn);
    EXPECT_DOUBLE_EQ(clock.time_s(), 4294967.320);
}

TEST(TextClock, WithoutAPeriodTakesTheSameForARestart) {
    TextClock clock;
    clock.advance(4294967.280, std::nullopt);
    EXPECT_EQ(clock.advance(0.004, std::nullopt), Step::kDoubtful);
    EXPECT_EQ(clock.advance(0.024, std::nullopt), Step::kRestarted);
    EXPECT_DOUBLE_EQ(clock.time_s(), 0.024);
}

TEST(TextClock, DoubtsOneLineThatIsOutOfTime) {
    TextClock clock;
    clock.advance(100.0, kMillisPeriod_s);
    EXPECT_EQ(clock.advance(10.02, kMillisPeriod_s), Step::kDoubtful);
    EXPECT_EQ(clock.advance(100.04, kMillisPeriod_s), Step::kGoesOn);
    EXPECT_EQ(clock.advance(1000.06, kMillisPeriod_s), Step::kDoubtful);
    EXPECT_EQ(clock.advance(100.08, kMillisPeriod_s), Step::kGoesOn);
    EXPECT_DOUBLE_EQ(clock.time_s(), 100.08);
}

TEST(TextClock, DoubtsAStepThatIsLongerThanUsual) {
    TextClock clock;
    for (int i = 0; i <= 50; ++i) clock.advance(0.02 * i, kMillisPeriod_s);
    EXPECT_EQ(clock.advance(3.02, kMillisPeriod_s), Step::kDoubtful);  // a wrong digit
    EXPECT_EQ(clock.advance(1.04, kMillisPeriod_s), Step::kGoesOn);
    EXPECT_EQ(clock.advance(1.14, kMillisPeriod_s), Step::kGoesOn);    // a small one
    EXPECT_EQ(clock.advance(1.08, kMillisPeriod_s), Step::kDoubtful);  // is no restart
    EXPECT_EQ(clock.advance(1.10, kMillisPeriod_s), Step::kDoubtful);
    EXPECT_EQ(clock.advance(1.14, kMillisPeriod_s), Step::kGoesOn);
    EXPECT_DOUBLE_EQ(clock.time_s(), 1.14);
}

TEST(TextClock, FollowsARobotThatBecomesSlower) {
    TextClock clock;
    for (int i = 0; i <= 50; ++i) clock.advance(0.02 * i, kMillisPeriod_s);
    EXPECT_EQ(clock.advance(3.0, kMillisPeriod_s), Step::kDoubtful);
    for (int i = 0; i < 20; ++i) {
        EXPECT_EQ(clock.advance(5.0 + 2.0 * i, kMillisPeriod_s), Step::kGoesOn);
    }
}

TEST(TextClock, BelievesAGapThatTheNextLineConfirms) {
    TextClock clock;
    clock.advance(100.0, kMillisPeriod_s);
    EXPECT_EQ(clock.advance(400.0, kMillisPeriod_s), Step::kDoubtful);
    EXPECT_EQ(clock.advance(400.02, kMillisPeriod_s), Step::kGoesOn);
}

TEST(TextClock, BelievesAtOnceWhatFollowsAHeader) {
    TextClock clock;
    clock.advance(100.0, kMillisPeriod_s);
    clock.expectStart();
    EXPECT_EQ(clock.advance(0.5, kMillisPeriod_s), Step::kRestarted);
    clock.expectStart();
    EXPECT_EQ(clock.advance(0.52, kMillisPeriod_s), Step::kGoesOn);
}

}  // namespace
}  // namespace hedr
