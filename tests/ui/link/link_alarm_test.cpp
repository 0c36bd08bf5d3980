#include "ui/link/link_alarm.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/ui/scene.h"

namespace hedr {
namespace {

using test::atSecond;

TEST(LinkAlarm, SoundsOnceForALinkThatIsLost) {
    LinkAlarm alarm;
    EXPECT_FALSE(alarm.sounds(LinkState::kLive, atSecond(0.0)));
    EXPECT_FALSE(alarm.sounds(LinkState::kStale, atSecond(2.0)));
    EXPECT_TRUE(alarm.sounds(LinkState::kLost, atSecond(4.0)));
    for (double t_s = 4.1; t_s < 60.0; t_s += 0.1)
        EXPECT_FALSE(alarm.sounds(LinkState::kLost, atSecond(t_s)));
}

TEST(LinkAlarm, IsSilentAboutALinkThatComesAndGoes) {
    LinkAlarm alarm;
    int tones = 0;
    for (double t_s = 0.0; t_s < 60.0; t_s += 0.1) {
        const bool lost = std::fmod(t_s, 6.0) > 3.0;
        tones += alarm.sounds(lost ? LinkState::kLost : LinkState::kLive, atSecond(t_s)) ? 1 : 0;
    }
    EXPECT_EQ(tones, 1);
}

TEST(LinkAlarm, SoundsAgainAfterTenQuietSeconds) {
    LinkAlarm alarm;
    EXPECT_TRUE(alarm.sounds(LinkState::kLost, atSecond(0.0)));
    EXPECT_FALSE(alarm.sounds(LinkState::kLive, atSecond(9.0)));
    EXPECT_FALSE(alarm.sounds(LinkState::kLost, atSecond(9.5)));
    EXPECT_FALSE(alarm.sounds(LinkState::kLive, atSecond(20.0)));
    EXPECT_TRUE(alarm.sounds(LinkState::kLost, atSecond(21.0)));
}

}  // namespace
}  // namespace hedr
