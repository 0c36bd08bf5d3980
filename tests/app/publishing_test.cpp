#include "app/publishing.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

namespace hedr {
namespace {

ReceiveClock::time_point moment(double seconds) {
    return ReceiveClock::time_point(std::chrono::duration_cast<ReceiveClock::duration>(
        std::chrono::duration<double>(1000.0 + seconds)));
}

LiveBatch liveBatch() {
    LiveBatch batch;
    batch.port = PortState::kOpen;
    batch.last_frame = moment(0.0);
    batch.speed_m_s = 0.4;
    batch.tracks = {{"hedr_bayes", {{.t_s = 1.0, .pose = {{2.0, 3.0}, 0.5}}}}};
    batch.statuses = {{"hedr_bayes", {.state = HedrState::kActive}}};
    return batch;
}

Site tiedSite() {
    return {.floors = {{.name = "Cellar"}, {.name = "Ground"}},
            .geo_tie = GeoTie{{}, {48.0, 11.0}, 0.0}};
}

TEST(Publishing, TellsWhatTheWindowShows) {
    LiveModel robot;
    robot.apply(liveBatch(), moment(0.1));
    const auto pose = poseToPublish(robot, "Robot 1", tiedSite(), moment(0.2));
    ASSERT_TRUE(pose);
    EXPECT_EQ(pose->call_sign, "Robot 1");
    EXPECT_EQ(pose->heard, moment(0.0));
    EXPECT_EQ(pose->pose, *robot.pose());
    EXPECT_EQ(pose->speed_m_s, 0.4);
    EXPECT_EQ(pose->trust, PublishedTrust::kGood);
    EXPECT_EQ(pose->estimator, "hedr_bayes");
    EXPECT_EQ(pose->floor, "Cellar");
    EXPECT_EQ(pose->tie, tiedSite().geo_tie);
}

TEST(Publishing, TellsNothingOfARobotThatIsNotConnectedOrNotHeard) {
    LiveModel robot;
    EXPECT_FALSE(poseToPublish(robot, "Robot 1", {}, moment(0.0)));
    LiveBatch batch = liveBatch();
    robot.apply(batch, moment(0.1));
    EXPECT_TRUE(poseToPublish(robot, "Robot 1", {}, moment(0.1))) << "a site need not be there";
    batch.tracks.clear();
    batch.port = PortState::kClosed;
    robot.apply(batch, moment(0.2));
    EXPECT_FALSE(poseToPublish(robot, "Robot 1", {}, moment(0.2)));
    batch.port = PortState::kOpen;
    batch.last_frame.reset();
    robot.apply(batch, moment(0.3));
    EXPECT_FALSE(poseToPublish(robot, "Robot 1", {}, moment(0.3)));
}

TEST(Publishing, TellsATroubleOnceAndAgainForNewTargets) {
    Publishing publishing;
    QSignalSpy failures(&publishing, &Publishing::failed);
    // An address of no computer: nothing can be listened to there.
    const PublishTarget foreign{PublishKind::kJson, QStringLiteral("192.0.2.1"), 10120};
    publishing.setTargets({foreign});
    ASSERT_EQ(failures.size(), 1);
    EXPECT_EQ(failures.front().front().value<Error>().code, ErrorCode::kAddressInUse);
    publishing.setTargets({});
    EXPECT_EQ(failures.size(), 1);
    publishing.setTargets({foreign});
    EXPECT_EQ(failures.size(), 2);
}

TEST(Publishing, SaysOnceThatTheMapIsNotTiedToTheGlobe) {
    Publishing publishing;
    QSignalSpy failures(&publishing, &Publishing::failed);
    publishing.setTargets({{PublishKind::kNmea, QStringLiteral("127.0.0.1"), 0}});
    LiveModel robot;
    robot.apply(liveBatch(), moment(0.1));
    publishing.publish({*poseToPublish(robot, "Robot 1", {}, moment(0.1))});
    ASSERT_TRUE(QTest::qWaitFor([&] { return failures.size() == 1; }));
    EXPECT_EQ(failures.front().front().value<Error>().code, ErrorCode::kNotOnGlobe);
    QTest::qWait(500);  // several more are sent
    EXPECT_EQ(failures.size(), 1);
}

}  // namespace
}  // namespace hedr
