#include "ui/live_model.h"

#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "tests/ui/scene.h"

namespace hedr {
namespace {

using test::atSecond;

LiveBatch batchAt(double second, Point<World> hedr, Point<World> odometry) {
    LiveBatch batch;
    batch.port = PortState::kOpen;
    batch.last_byte = batch.last_frame = atSecond(second);
    batch.tracks = {{"odometry", {{second, {odometry, 0.1}, 0.0}}},
                    {"hedr_bayes", {{second, {hedr, 0.0}, 0.0}}}};
    batch.statuses = {{"hedr_bayes", {.state = HedrState::kActive}}};
    batch.speed_m_s = 0.5;
    return batch;
}

TEST(LiveModel, PutsTheMostTrustedTrailFirstInWhateverOrderTheyCome) {
    LiveModel model;
    model.apply(batchAt(0.0, {0, 0}, {0, 0}), atSecond(0.0));
    LiveBatch later;
    later.tracks = {{"robot", {{0.1, {}, 0.0}}}, {"other", {{0.1, {}, 0.0}}}};
    model.apply(later, atSecond(0.1));
    ASSERT_EQ(model.trails().size(), 4u);
    EXPECT_EQ(model.trails()[0].name, "hedr_bayes");
    EXPECT_EQ(model.trails()[1].name, "robot");
    EXPECT_EQ(model.trails()[2].name, "odometry");
    EXPECT_EQ(model.trails()[3].name, "other");
}

TEST(LiveModel, LeavesTrailsOnTheFloorWhereTheyWereDriven) {
    LiveModel model;
    model.apply(batchAt(0.0, {0, 0}, {0, 0}), atSecond(0.0));
    model.apply(batchAt(1.0, {4, 0}, {4, 0}), atSecond(1.0));
    model.setFloor(1);
    model.apply(batchAt(2.0, {8, 0}, {8, 0}), atSecond(2.0));
    ASSERT_EQ(model.left().size(), 1u);
    EXPECT_EQ(model.left()[0].floor, 0u);
    EXPECT_EQ(model.left()[0].trails[0].track.size(), 2u);
    EXPECT_EQ(model.primary()->track.at(0).pose.position, (Point<World>{4, 0}));
    EXPECT_EQ(model.pose()->position, (Point<World>{8, 0}));
    EXPECT_EQ(*model.home(), (Point<World>{0, 0}));
}

TEST(LiveModel, KeepsTheTrailWholeWhereAFloorWasSaidByMistake) {
    LiveModel model;
    model.apply(batchAt(0.0, {0, 0}, {0, 0}), atSecond(0.0));
    model.apply(batchAt(1.0, {4, 0}, {4, 0}), atSecond(1.0));
    model.setFloor(1);
    model.apply(batchAt(1.1, {4.1, 0}, {4.1, 0}), atSecond(1.1));
    model.setFloor(0);
    EXPECT_TRUE(model.left().empty());
    EXPECT_EQ(model.primary()->track.size(), 3u);
}

TEST(LiveModel, MeasuresTheWayHomeAndHowFarTrailsAreApart) {
    LiveModel model;
    model.apply(batchAt(0.0, {1, 2}, {1, 2}), atSecond(0.0));
    model.apply(batchAt(1.0, {4, 2}, {4, 6}), atSecond(1.0));
    EXPECT_DOUBLE_EQ(model.homeDistance_m(), 3.0);
    EXPECT_DOUBLE_EQ(model.homeBearing_rad(), kPi);
    EXPECT_DOUBLE_EQ(model.apart_m(model.trails().back()), 4.0);
}

TEST(LiveModel, TrustsAHeadingForTenSecondsAfterTheLastStraightDriving) {
    LiveModel model;
    LiveBatch batch = batchAt(0.0, {0, 0}, {0, 0});
    HedrStatus& status = batch.statuses.front().status;
    status = {.state = HedrState::kSuspended, .seconds_since_active = 9.9};
    model.apply(batch, atSecond(0.0));
    EXPECT_EQ(model.trust(atSecond(0.0)), Trust::kGood);
    status.seconds_since_active = 10.1;
    model.apply(batch, atSecond(0.0));
    EXPECT_EQ(model.trust(atSecond(0.0)), Trust::kCoasting);
    status.state = HedrState::kOff;
    model.apply(batch, atSecond(0.0));
    EXPECT_EQ(model.trust(atSecond(0.0)), Trust::kOff);
}

TEST(LiveModel, DoesNotTrustAHeadingThatIsStale) {
    LiveModel model;
    model.apply(batchAt(0.0, {0, 0}, {0, 0}), atSecond(0.0));
    EXPECT_EQ(model.trust(atSecond(0.5)), Trust::kGood);
    EXPECT_EQ(model.trust(atSecond(1.5)), Trust::kCoasting);
}

TEST(LiveModel, LetsTheReachGrowWithTheTopSpeedSoFarButNoSlowerThanOneMetrePerSecond) {
    LiveModel model;
    model.apply(batchAt(0.0, {0, 0}, {0, 0}), atSecond(0.0));
    EXPECT_NEAR(model.reach_m(atSecond(7.0)), 7.0, 1e-9);
    LiveBatch fast = batchAt(1.0, {0, 0}, {0, 0});
    fast.speed_m_s = -1.8;
    model.apply(fast, atSecond(1.0));
    model.apply(batchAt(2.0, {0, 0}, {0, 0}), atSecond(2.0));
    EXPECT_NEAR(model.reach_m(atSecond(9.0)), 12.6, 1e-9);
}

TEST(LiveModel, IsNotMadeLiveByAFrameOfTheLinkBefore) {
    LiveModel model;
    model.apply(batchAt(0.0, {0, 0}, {0, 0}), atSecond(0.0));
    LiveBatch closed;
    closed.last_frame = atSecond(0.0);
    model.apply(closed, atSecond(1.0));
    EXPECT_EQ(model.link(atSecond(1.0)).state, LinkState::kOff);
    LiveBatch opened = closed;
    opened.port = PortState::kOpen;
    model.apply(opened, atSecond(20.0));
    EXPECT_EQ(model.link(atSecond(20.5)).state, LinkState::kWaiting);
    model.apply(batchAt(21.0, {0, 0}, {0, 0}), atSecond(21.0));
    EXPECT_EQ(model.link(atSecond(21.0)).state, LinkState::kLive);
}

TEST(LiveModel, KeepsTheMissionClockRunningThroughASilence) {
    LiveModel model;
    EXPECT_EQ(model.missionDuration_s(atSecond(5.0)), 0.0);
    model.apply(batchAt(10.0, {0, 0}, {0, 0}), atSecond(10.0));
    EXPECT_DOUBLE_EQ(model.missionDuration_s(atSecond(70.0)), 60.0);
    LiveBatch closed;
    closed.last_frame = atSecond(40.0);
    model.apply(closed, atSecond(70.0));
    EXPECT_DOUBLE_EQ(model.missionDuration_s(atSecond(90.0)), 30.0);
}

TEST(LiveModel, CountsAContinuedMissionFromItsFirstStart) {
    LiveModel model;
    LiveBatch batch = batchAt(10.0, {0, 0}, {0, 0});
    batch.mission_begin = atSecond(-50.0);
    model.apply(batch, atSecond(10.0));
    EXPECT_DOUBLE_EQ(model.missionDuration_s(atSecond(10.0)), 60.0);
}

TEST(LiveModel, SaysNoWordOfTrustWithoutALink) {
    LiveModel model;
    LiveBatch batch = batchAt(0.0, {0, 0}, {0, 0});
    model.apply(batch, atSecond(0.0));
    batch.port = PortState::kClosed;
    model.apply(batch, atSecond(0.2));
    EXPECT_EQ(model.trust(atSecond(0.2)), Trust::kOff);
}

TEST(LiveModel, ForgetsTheMissionButNotTheLink) {
    LiveModel model;
    model.apply(batchAt(0.0, {3, 4}, {0, 0}), atSecond(0.0));
    model.clear();
    EXPECT_TRUE(model.trails().empty());
    EXPECT_FALSE(model.pose());
    EXPECT_FALSE(model.home());
    EXPECT_EQ(model.link(atSecond(0.1)).state, LinkState::kLive);
}

// Both trails go on all the time, so a change of mind loses nothing of either.
TEST(LiveModel, GivesPoseHomeAndDistancesOfTheTrailThatIsPrimaryNow) {
    LiveModel model;
    model.apply(batchAt(0.0, {1, 2}, {1, 2}), atSecond(0.0));
    model.apply(batchAt(1.0, {4, 2}, {1, 6}), atSecond(1.0));
    model.choosePrimary("odometry");
    ASSERT_EQ(model.primary()->name, "odometry");
    EXPECT_EQ(model.primary()->track.size(), 2u);
    EXPECT_EQ(model.trails().front().track.size(), 2u) << "hedr_bayes";
    EXPECT_DOUBLE_EQ(model.pose()->position.y, 6.0);
    EXPECT_DOUBLE_EQ(model.homeDistance_m(), 4.0);
    EXPECT_DOUBLE_EQ(model.homeBearing_rad(), -kPi / 2.0);
    EXPECT_DOUBLE_EQ(model.apart_m(model.trails().front()), 5.0);
    EXPECT_DOUBLE_EQ(model.apart_m(*model.primary()), 0.0);
    model.apply(batchAt(2.0, {5, 2}, {1, 7}), atSecond(2.0));
    model.choosePrimary("hedr_bayes");
    EXPECT_EQ(model.primary()->track.size(), 3u);
    EXPECT_DOUBLE_EQ(model.homeDistance_m(), 4.0);
}

TEST(LiveModel, KeepsTheWishForATrailThatIsNotThere) {
    LiveModel model;
    model.setChoice({.primary = "gyro"});
    EXPECT_EQ(model.primary(), nullptr);
    model.apply(batchAt(0.0, {0, 0}, {0, 0}), atSecond(0.0));
    EXPECT_EQ(model.primary()->name, "hedr_bayes");
    model.clear();
    LiveBatch other;
    other.tracks = {{"hedr_bayes", {TrackPoint{}}}, {"gyro", {TrackPoint{}}}};
    model.apply(other, atSecond(1.0));
    EXPECT_EQ(model.primary()->name, "gyro");
}

TEST(LiveModel, GoesRoundTheTrailsThatAreShown) {
    LiveModel model;
    EXPECT_EQ(model.nextPrimary(), nullptr);
    model.apply(batchAt(0.0, {0, 0}, {0, 0}), atSecond(0.0));
    LiveBatch more;
    more.tracks = {{"robot", {TrackPoint{}}}, {"gyro", {TrackPoint{}}}};
    model.apply(more, atSecond(0.1));
    for (const char* name : {"robot", "odometry", "hedr_bayes", "robot"}) {
        ASSERT_NE(model.nextPrimary(), nullptr);
        EXPECT_EQ(model.nextPrimary()->name, name) << "gyro is hidden at first";
        model.choosePrimary(model.nextPrimary()->name);
    }
    model.showTrail("odometry", false);
    model.showTrail("hedr_bayes", false);
    EXPECT_EQ(model.nextPrimary(), nullptr);
}

TEST(LiveModel, TrustsWhatThePrimaryTrailSaysOfItself) {
    LiveModel model;
    LiveBatch batch = batchAt(0.0, {0, 0}, {0, 0});
    batch.tracks.push_back({"robot", {TrackPoint{}}});
    batch.tracks.push_back({"hedr", {TrackPoint{}}});
    batch.statuses = {{"hedr_bayes", {.state = HedrState::kActive}},
                      {"hedr", {.state = HedrState::kActive, .lost = true}},
                      {"robot", {.state = HedrState::kSuspended, .seconds_since_active = 60.0}}};
    model.apply(batch, atSecond(0.0));
    const auto trustIn = [&](const char* name) {
        model.choosePrimary(name);
        return model.trust(atSecond(0.1));
    };
    EXPECT_EQ(trustIn("hedr_bayes"), Trust::kGood);
    EXPECT_EQ(trustIn("hedr"), Trust::kLostLock);
    EXPECT_EQ(trustIn("robot"), Trust::kCoasting);
    EXPECT_EQ(trustIn("odometry"), Trust::kOff) << "nothing checks its heading";
}

TEST(LiveModel, TakesEmptyTracksWithoutMakingATrail) {
    LiveModel model;
    LiveBatch batch;
    batch.tracks = {{"hedr_bayes", {}}};
    model.apply(batch, atSecond(0.0));
    EXPECT_TRUE(model.trails().empty());
}

}  // namespace
}  // namespace hedr
