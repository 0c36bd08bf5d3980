#include "radio/wire/signing/replay_window.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace hedr {
namespace {

TEST(ReplayWindow, TakesEachCounterOnceInAnyOrder) {
    ReplayWindow window;
    for (const std::uint32_t counter : {3U, 1U, 2U, 66U}) EXPECT_TRUE(window.take(counter));
    for (const std::uint32_t counter : {3U, 1U, 2U, 66U}) EXPECT_FALSE(window.take(counter));
    EXPECT_EQ(window.highest(), 66U);
}

TEST(ReplayWindow, TakesNothingThatIsSixtyFourBehind) {
    ReplayWindow window;
    window.take(164);
    EXPECT_FALSE(window.take(100));
    EXPECT_TRUE(window.take(101));
    EXPECT_FALSE(window.take(101));
}

TEST(ReplayWindow, TakesNothingUpToWhatWasHeardBefore) {
    ReplayWindow window(1000);
    for (const std::uint32_t counter : {1000U, 999U, 940U, 1U, 0U}) {
        EXPECT_FALSE(window.take(counter)) << counter;
    }
    EXPECT_TRUE(window.take(1002));
    EXPECT_TRUE(window.take(1001));
    EXPECT_FALSE(window.take(1000));
}

TEST(ReplayWindow, EndsWithTheCountersAndDoesNotWrap) {
    ReplayWindow window;
    EXPECT_TRUE(window.take(UINT32_MAX));
    EXPECT_FALSE(window.take(UINT32_MAX));
    EXPECT_FALSE(window.take(0));
    EXPECT_FALSE(window.take(1));
    EXPECT_TRUE(window.take(UINT32_MAX - 63));
}

// The definition: taken before, or 64 behind the highest, or not above what was heard.
RC_GTEST_PROP(ReplayWindow, AgreesWithASetOfAllThatWasTaken, ()) {
    const auto heard = *rc::gen::inRange<std::uint32_t>(0, 200);
    const auto counters =
        *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange<std::uint32_t>(0, 400));
    ReplayWindow window(heard);
    std::set<std::uint32_t> taken;
    std::uint32_t highest = heard;
    for (const std::uint32_t counter : counters) {
        highest = std::max(highest, counter);
        const bool fresh = counter > heard && counter + 64 > highest && !taken.contains(counter);
        RC_ASSERT(window.take(counter) == fresh);
        if (fresh) taken.insert(counter);
    }
}

}  // namespace
}  // namespace hedr
