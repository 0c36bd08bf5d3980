#include "radio/source/baud_search.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace hedr {
namespace {

using namespace std::chrono_literals;

// Bytes that make no sense every 10 ms until the search comes to `right`; how long it took.
BaudSearch::Clock::duration timeToFind(int right) {
    BaudSearch search;
    BaudSearch::Clock::time_point now{};
    while (search.baud() != right && now.time_since_epoch() < 60s) {
        search.noteBytes(now);
        now += 10ms;
    }
    return now.time_since_epoch();
}

TEST(BaudSearch, ComesToEveryUsualRateWithinFiveSeconds) {
    for (const int baud : kUsualBauds) EXPECT_LT(timeToFind(baud), 5s) << baud;
}

TEST(BaudSearch, StaysWhereBytesMakeSense) {
    BaudSearch search;
    search.noteBytes(BaudSearch::Clock::time_point(0s));
    search.settle();
    EXPECT_FALSE(search.noteBytes(BaudSearch::Clock::time_point(100s)));
    EXPECT_EQ(search.baud(), kUsualBauds.front());
}

TEST(BaudSearch, SilenceIsNoReasonToGoOn) {
    BaudSearch search;
    EXPECT_FALSE(search.noteBytes(BaudSearch::Clock::time_point(100s)));
    EXPECT_FALSE(search.noteBytes(BaudSearch::Clock::time_point(100s + 400ms)));
    EXPECT_TRUE(search.noteBytes(BaudSearch::Clock::time_point(100s + 600ms)));
}

TEST(BaudSearch, IsPatientWithSlowTalkersInLaterRounds) {
    BaudSearch search;
    BaudSearch::Clock::time_point now{};
    int rates = 0;
    while (rates < 8) {
        rates += search.noteBytes(now) ? 1 : 0;
        now += 10ms;
    }
    const auto round_two = now;
    while (!search.noteBytes(now)) now += 10ms;
    EXPECT_GT(now - round_two, 2s);
}

}  // namespace
}  // namespace hedr
