#include "ui/link_state.h"

#include <gtest/gtest.h>

#include "tests/ui/scene.h"

namespace hedr {
namespace {

using test::atSecond;

LinkFacts openSince(double second) { return {PortState::kOpen, atSecond(second), {}, {}, {}, 0}; }

LinkFacts lastFrameAt(double second) {
    LinkFacts facts = openSince(0.0);
    facts.last_byte = atSecond(second);
    facts.last_frame = atSecond(second);
    return facts;
}

TEST(LinkState, IsOffWhileThePortIsClosed) {
    EXPECT_EQ(judgeLink({}, atSecond(5.0)).state, LinkState::kOff);
    EXPECT_EQ(judgeLink({}, atSecond(5.0)).trouble, LinkTrouble::kNone);
}

TEST(LinkState, WaitsQuietlyForTheFirstPacketThenSaysWhatIsMissing) {
    LinkFacts facts = openSince(0.0);
    EXPECT_EQ(judgeLink(facts, atSecond(1.0)),
              (LinkVerdict{LinkState::kWaiting, LinkTrouble::kNone, 1.0}));
    EXPECT_EQ(judgeLink(facts, atSecond(3.5)).trouble, LinkTrouble::kNoBytes);
    facts.last_byte = atSecond(3.4);
    EXPECT_EQ(judgeLink(facts, atSecond(3.5)).trouble, LinkTrouble::kNoValidFrames);
}

TEST(LinkState, IsStaleAfterOneSecondAndLostAfterThree) {
    const LinkFacts facts = lastFrameAt(10.0);
    EXPECT_EQ(judgeLink(facts, atSecond(10.99)).state, LinkState::kLive);
    EXPECT_EQ(judgeLink(facts, atSecond(11.0)).state, LinkState::kStale);
    EXPECT_EQ(judgeLink(facts, atSecond(12.99)).state, LinkState::kStale);
    EXPECT_EQ(judgeLink(facts, atSecond(13.0)).state, LinkState::kLost);
}

TEST(LinkState, TellsASilentRobotFromAnUnreadableOne) {
    LinkFacts facts = lastFrameAt(10.0);
    EXPECT_EQ(judgeLink(facts, atSecond(12.0)).trouble, LinkTrouble::kNoBytes);
    facts.last_byte = atSecond(11.9);
    EXPECT_EQ(judgeLink(facts, atSecond(12.0)).trouble, LinkTrouble::kNoValidFrames);
}

TEST(LinkState, ARobotThatGreetsOnlyIsNotLive) {
    LinkFacts facts = lastFrameAt(10.0);
    facts.last_byte = facts.last_good = atSecond(11.9);
    EXPECT_EQ(judgeLink(facts, atSecond(12.0)),
              (LinkVerdict{LinkState::kStale, LinkTrouble::kNoMotion, 2.0}));
    facts.last_frame.reset();
    EXPECT_EQ(judgeLink(facts, atSecond(12.0)).state, LinkState::kWaiting);
}

TEST(LinkState, NamesAnUnpluggedRadioAtOnce) {
    LinkFacts facts = lastFrameAt(10.0);
    facts.port = PortState::kGone;
    EXPECT_EQ(judgeLink(facts, atSecond(10.1)).trouble, LinkTrouble::kDeviceGone);
    EXPECT_EQ(judgeLink(facts, atSecond(10.1)).state, LinkState::kLive);
    EXPECT_EQ(judgeLink(facts, atSecond(11.1)).state, LinkState::kStale);
}

TEST(LinkState, ReportsTheRobotsOwnFaultWhileTheLinkIsGood) {
    LinkFacts facts = lastFrameAt(10.0);
    facts.robot_faults = 4;
    EXPECT_EQ(judgeLink(facts, atSecond(10.1)).trouble, LinkTrouble::kRobotFault);
    EXPECT_EQ(judgeLink(facts, atSecond(12.0)).trouble, LinkTrouble::kNoBytes);
}

TEST(LinkState, TakesAFrameFromAMomentAheadAsNew) {
    EXPECT_EQ(judgeLink(lastFrameAt(10.0), atSecond(9.99)),
              (LinkVerdict{LinkState::kLive, LinkTrouble::kNone, 0.0}));
}

}  // namespace
}  // namespace hedr
