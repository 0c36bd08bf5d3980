#include "radio/wire/sequence_tracker.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

namespace hedr {
namespace {

SequenceTracker tracked(const std::vector<int>& numbers) {
    SequenceTracker tracker;
    for (const int number : numbers) tracker.note(static_cast<std::uint16_t>(number));
    return tracker;
}

TEST(SequenceTracker, CountsWhatIsMissingAcrossTheWrap) {
    EXPECT_EQ(tracked({10, 11}).lost(), 0U);
    EXPECT_EQ(tracked({10, 14}).lost(), 3U);
    EXPECT_EQ(tracked({65535, 0}).lost(), 0U);
    EXPECT_EQ(tracked({65533, 2}).lost(), 4U);
    EXPECT_EQ(tracked({0, 2000}).lost(), 1999U);  // ten seconds of silence and more
}

TEST(SequenceTracker, AFrameThatWasOvertakenIsLateAndNotLost) {
    SequenceTracker tracker = tracked({5, 7});
    EXPECT_EQ(tracker.lost(), 1U);
    EXPECT_EQ(tracker.note(6), Arrival::kLate);
    EXPECT_EQ(tracker.lost(), 0U);
    EXPECT_EQ(tracker.late(), 1U);
    EXPECT_EQ(tracker.note(8), Arrival::kInOrder);
    EXPECT_EQ(tracker.lost(), 0U);
}

TEST(SequenceTracker, ARepeatedFrameIsNeitherLostNorNew) {
    SequenceTracker tracker = tracked({65534, 65535, 0, 1});
    EXPECT_EQ(tracker.note(1), Arrival::kRepeated);
    EXPECT_EQ(tracker.note(65535), Arrival::kRepeated);
    EXPECT_EQ(tracker.note(2), Arrival::kInOrder);
    EXPECT_EQ(tracker.repeated(), 2U);
    EXPECT_EQ(tracker.lost(), 0U);
}

TEST(SequenceTracker, ARestartIsNoLoss) {
    EXPECT_EQ(tracked({30000, 0, 1}).lost(), 0U);  // far back
    SequenceTracker early = tracked({98, 99, 100});
    for (int i = 0; i <= SequenceTracker::kRestartAfterLate; ++i) {
        early.note(static_cast<std::uint16_t>(i));
    }
    EXPECT_EQ(early.note(50), Arrival::kInOrder);  // counted from the new beginning
    // From 40000 to 0 seems a step ahead, until the robot says that it was restarted.
    SequenceTracker told = tracked({39999, 40000, 0, 1});
    EXPECT_EQ(told.lost(), 25535U);
    told.startAgain();
    EXPECT_EQ(told.lost(), 0U);
    told.note(2);
    EXPECT_EQ(told.lost(), 0U);
}

TEST(SequenceTracker, ALongSilenceOfTheSameRobotStaysALoss) {
    SequenceTracker tracker = tracked({10, 5010});
    tracker.confirm();
    tracker.startAgain();
    EXPECT_EQ(tracker.lost(), 4999U);
}

// Whatever is lost, overtaken by up to a window, or doubled: the sums come out.
RC_GTEST_PROP(SequenceTracker, AccountsForEveryFrameSent, ()) {
    const int first = *rc::gen::inRange(0, 65536);
    const auto fates = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 8));
    std::vector<std::pair<int, int>> order{{-1, 0}};  // place in the order of arrival, number
    for (std::size_t i = 0; i < fates.size(); ++i) {
        const int number = static_cast<int>(i) + 1;
        const int delay = fates[i] == 1 ? *rc::gen::inRange(1, SequenceTracker::kWindow / 2) : 0;
        if (fates[i] == 0) continue;
        order.emplace_back(number + delay, number);
        if (fates[i] == 2) order.emplace_back(number + 3, number);
    }
    std::ranges::stable_sort(order, {}, &std::pair<int, int>::first);
    SequenceTracker tracker;
    std::size_t arrived = 0;
    int highest = 0;
    for (const auto& [place, number] : order) {
        const Arrival arrival = tracker.note(static_cast<std::uint16_t>(first + number));
        RC_ASSERT(arrival != Arrival::kRestarted);
        arrived += arrival == Arrival::kRepeated ? 0 : 1;
        highest = std::max(highest, number);
    }
    RC_ASSERT(tracker.lost() + arrived == static_cast<std::size_t>(highest) + 1);
}

}  // namespace
}  // namespace hedr
