// The whole river over a real pseudo-terminal: port, recorder, receiver, and what goes wrong.
#include "radio/live_link.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <QTemporaryDir>
#include <QtTest/QTest>
#include <algorithm>
#include <map>
#include <memory>
#include <optional>

#include "core/mission/mission_reader.h"
#include "radio/recomputation.h"
#include "tests/e2e/talking_robot.h"

namespace hedr {
namespace {

class LiveLinkOnPty : public ::testing::Test {
  protected:
    QString port() const { return folder_.filePath("robot"); }
    std::filesystem::path mission() const { return folder_.filePath("m.hedr").toStdString(); }

    std::unique_ptr<LiveLink> makeLink(const std::optional<Vehicle>& vehicle = {}) {
        auto link = std::make_unique<LiveLink>(LiveLink::Setup{
            .vehicle = vehicle,
            .mission = mission(),
            .header = {.start = std::chrono::system_clock::now(), .program_version = "test"}});
        QObject::connect(link.get(), &LiveLink::batchReady, [this](const LiveBatch& batch) {
            last_ = batch;
            warnings_.insert(warnings_.end(), batch.warnings.begin(), batch.warnings.end());
            for (const NamedPoints& part : batch.tracks) points_[part.name] += part.points.size();
        });
        return link;
    }

    QTemporaryDir folder_;
    // Lets a robot print four seconds of lines.
    void hearLines(LiveLink& link) {
        RobotLine line = RobotLine::openPseudoTerminal(port().toStdString()).value();
        link.open(SerialAddress{port()});
        ASSERT_TRUE(QTest::qWaitFor([&] { return last_.port == PortState::kOpen; }, 5000));
        std::string text = "t_ms,left_ticks,right_ticks\n";
        for (int i = 0; i < 200; ++i) {
            const std::string ticks = std::to_string(5 * i);
            text.append(std::to_string(20 * i)).append(",").append(ticks).append(",").append(ticks);
            text.append("\n");
        }
        line.send({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
        ASSERT_TRUE(QTest::qWaitFor([&] { return points_["odometry"] > 50; }, 5000));
        link.close();
    }

    LiveBatch last_;
    std::vector<Error> warnings_;
    std::map<std::string, std::size_t> points_;
};

double cpuSeconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

TEST_F(LiveLinkOnPty, RecordsWhatItShowsBitForBit) {
    const TalkingRobot robot(port(), 60.0, {.speed = 20.0});
    auto link = makeLink();
    link->open(SerialAddress{port()});
    ASSERT_TRUE(QTest::qWaitFor([&] { return robot.done(); }, 20000));
    ASSERT_TRUE(QTest::qWaitFor([&] { return points_["hedr"] >= 3000; }, 5000));
    link->close();
    link.reset();
    for (const char* name : {"odometry", "gyro", "gyrodometry", "hedr", "robot"}) {
        const auto again = recomputeTrack(mission(), name, {});
        ASSERT_TRUE(again) << again.error().detail;
        EXPECT_TRUE(again->as_live) << name;
        EXPECT_EQ(again->points.size(), points_[name]) << name;
    }
}

TEST_F(LiveLinkOnPty, RecordsBitForBitAlsoWhenClosedWhileTheRobotTalks) {
    for (int round = 0; round < 5; ++round) {
        std::filesystem::remove(mission());
        points_.clear();
        const TalkingRobot robot(port(), 60.0, {.speed = 10.0});
        auto link = makeLink();
        link->open(SerialAddress{port()});
        ASSERT_TRUE(QTest::qWaitFor([&] { return points_["hedr"] >= 100; }, 5000));
        QTest::qWait(7 * round);
        if (round % 2 == 0) link->close();
        link.reset();
        const auto again = recomputeTrack(mission(), "hedr", {});
        ASSERT_TRUE(again);
        EXPECT_TRUE(again->as_live) << round;
    }
}

TEST_F(LiveLinkOnPty, SurvivesABadRadioInLumpsAndInSingleBytes) {
    for (const std::size_t lump : {1u, 4096u}) {
        points_.clear();
        std::filesystem::remove(mission());
        const ReplayScript script{
            .speed = 20.0,
            .faults = {.loss = 0.05, .corrupt = 0.01, .noise = 0.3, .lump_bytes = lump},
            .restart_at_s = 15.0};
        const TalkingRobot robot(port(), 30.0, script);
        auto link = makeLink();
        link->open(SerialAddress{port()});
        ASSERT_TRUE(QTest::qWaitFor([&] { return robot.done(); }, 20000));
        link->close();
        EXPECT_EQ(last_.link.restarts, 1u) << lump;
        EXPECT_GT(points_["hedr"], 900u) << lump;
        EXPECT_NEAR(last_.driven_m, 14.0, 0.5) << lump;
        link.reset();
        EXPECT_TRUE(recomputeTrack(mission(), "hedr", {}).value().as_live) << lump;
    }
}

TEST_F(LiveLinkOnPty, APulledCableIsSeenAtOnceAndWaitedForWithoutBusyLoop) {
    auto robot = std::make_unique<TalkingRobot>(port(), 60.0, ReplayScript{.speed = 1.0});
    auto link = makeLink();
    link->open(SerialAddress{port()});
    ASSERT_TRUE(QTest::qWaitFor([&] { return points_["hedr"] > 20; }, 5000));
    robot.reset();
    ASSERT_TRUE(QTest::qWaitFor([&] { return last_.port == PortState::kGone; }, 1000));
    const double cpu_before_s = cpuSeconds();
    QTest::qWait(2000);
    EXPECT_LT(cpuSeconds() - cpu_before_s, 0.1);  // 5 % of two seconds

    const std::size_t before = points_["hedr"];
    robot = std::make_unique<TalkingRobot>(port(), 60.0, ReplayScript{.speed = 1.0});
    ASSERT_TRUE(QTest::qWaitFor([&] { return last_.port == PortState::kOpen; }, 2000));
    ASSERT_TRUE(QTest::qWaitFor([&] { return points_["hedr"] > before + 20; }, 5000));
    EXPECT_EQ(last_.link.reconnects, 1u);
    link->close();
    link.reset();
    EXPECT_TRUE(recomputeTrack(mission(), "hedr", {}).value().as_live);
}

TEST_F(LiveLinkOnPty, ContinuesAMissionAfterTheProgramWasEnded) {
    auto robot = std::make_unique<TalkingRobot>(port(), 30.0, ReplayScript{.speed = 10.0});
    auto link = makeLink();
    link->open(SerialAddress{port()});
    ASSERT_TRUE(QTest::qWaitFor([&] { return robot->done(); }, 10000));
    link->close();
    link.reset();
    const double driven_m = last_.driven_m;
    const std::size_t before = points_["hedr"];
    robot = std::make_unique<TalkingRobot>(port(), 30.0, ReplayScript{.speed = 10.0});
    points_.clear();
    link = makeLink();
    link->open(SerialAddress{port()});
    ASSERT_TRUE(QTest::qWaitFor([&] { return robot->done(); }, 10000));
    link->close();
    link.reset();
    EXPECT_GT(driven_m, 13.0);
    EXPECT_NEAR(last_.driven_m, 2.0 * driven_m, 0.5);
    EXPECT_GT(points_["hedr"], 2 * before - 50);
    EXPECT_TRUE(recomputeTrack(mission(), "hedr", {}).value().as_live);
}

TEST_F(LiveLinkOnPty, GivesAContinuedMissionItsSiteAndTheFloorsOfItsTrail) {
    const Site site{.floors = {{.name = "Ground"}, {.name = "Upper"}}, .direction_rad = 0.5};
    auto robot = std::make_unique<TalkingRobot>(port(), 30.0, ReplayScript{.speed = 10.0});
    auto link = makeLink();
    link->noteSite({});
    link->noteFloor("Ground");
    link->open(SerialAddress{port()});
    ASSERT_TRUE(QTest::qWaitFor([&] { return points_["hedr"] >= 500; }, 10000));
    link->noteSite(site);
    link->noteFloor("Upper");
    Site renamed = site;
    renamed.floors[0].name = "Entrance";
    link->noteSite(renamed);
    ASSERT_TRUE(QTest::qWaitFor([&] { return robot->done(); }, 10000));
    link->close();
    link.reset();
    robot.reset();

    std::vector<LiveBatch> batches;
    const auto reopen = [&](auto&& before) {
        batches.clear();
        link = makeLink();
        QObject::connect(link.get(), &LiveLink::batchReady,
                         [&](const LiveBatch& batch) { batches.push_back(batch); });
        before(*link);
        link->open(SerialAddress{port()});
        const bool heard = QTest::qWaitFor([&] { return !batches.empty(); }, 5000);
        link->close();  // sends another one
        return heard;
    };
    ASSERT_TRUE(reopen([](LiveLink&) {}));
    ASSERT_GE(batches.size(), 2U);
    EXPECT_EQ(batches[0].restored_site, renamed);
    EXPECT_FALSE(batches[1].restored_site);
    ASSERT_EQ(batches[0].restored_floors.size(), 2U);
    EXPECT_TRUE(batches[1].restored_floors.empty());
    const auto [ground, upper] =
        std::pair(batches[0].restored_floors[0], batches[0].restored_floors[1]);
    EXPECT_EQ(ground.floor, "Entrance") << "as it is called now";
    EXPECT_EQ(upper.floor, "Upper");
    const auto hedr = recomputeTrack(mission(), "hedr", {});
    ASSERT_TRUE(hedr && hedr->points.size() > 1000);
    EXPECT_LT(ground.t_s, hedr->points[100].t_s);
    EXPECT_GT(upper.t_s, hedr->points[400].t_s);
    EXPECT_LT(upper.t_s, hedr->points.back().t_s);
    for (const char* track : {"hedr", "hedr_bayes"}) {
        const auto again = recomputeTrack(mission(), track, {});
        EXPECT_TRUE(again && again->as_live) << track << ", which was told the site's direction";
    }

    link.reset();
    ASSERT_TRUE(reopen([](LiveLink& l) { l.noteSite({}); }));
    EXPECT_FALSE(batches[0].restored_site) << "the operator's own is newer";
    EXPECT_EQ(batches[0].restored_floors.size(), 2U);
}

// Requests that are open when the operator disconnects are over; the link's history goes on.
TEST_F(LiveLinkOnPty, AMissionThatGoesOnHasItsHistoryBeforeNow) {
    std::vector<LinkSample> samples;
    std::optional<RequestState> request;
    for (int round = 0; round < 2; ++round) {
        const TalkingRobot robot(port(), 60.0, {.speed = 1.0});
        auto link = makeLink();
        samples.clear();
        QObject::connect(link.get(), &LiveLink::batchReady, [&](const LiveBatch& batch) {
            samples.insert(samples.end(), batch.link_samples.begin(), batch.link_samples.end());
            for (const RequestProgress& progress : batch.requests) request = progress.state;
        });
        link->open(SerialAddress{port()});
        const std::size_t wanted = round == 0 ? 2 : 4;
        ASSERT_TRUE(QTest::qWaitFor([&] { return samples.size() >= wanted; }, 10000));
        link->ask(1, ParameterGet{1});
        link->close();
        EXPECT_EQ(request, RequestState::kCanceled);
    }
    EXPECT_LT(samples.front().receive_time_s, 0.0);
    EXPECT_TRUE(std::ranges::is_sorted(samples, {}, &LinkSample::receive_time_s));
    EXPECT_LT(samples.back().frames_per_s, 200.0);
}

TEST_F(LiveLinkOnPty, SaysThatAPortIsMissing) {
    auto link = makeLink();
    link->open(SerialAddress{folder_.filePath("nothing")});
    ASSERT_TRUE(QTest::qWaitFor([&] { return last_.port == PortState::kGone; }, 1000));
    ASSERT_TRUE(last_.port_error);
    EXPECT_EQ(last_.port_error->code, ErrorCode::kPortMissing);
    EXPECT_FALSE(std::filesystem::exists(mission()));  // nothing came, nothing is recorded
}

TEST_F(LiveLinkOnPty, WarnsOnceOfWheelsThatNobodyHasDescribed) {
    auto link = makeLink();
    hearLines(*link);
    link.reset();
    ASSERT_EQ(warnings_.size(), 1U);
    EXPECT_EQ(warnings_[0].code, ErrorCode::kWheelsUnknown);
    EXPECT_EQ(warnings_[0].detail,
              "they are taken to measure 0.2 m, 0.4 m apart, with 1000 counts a turn");
    EXPECT_TRUE(last_.wheels_assumed);
    {
        const auto reader = MissionReader::open(mission());
        ASSERT_TRUE(reader);
        const std::vector<MissionEvent> events = reader->events().value();
        const auto warned = [](const MissionEvent& event) { return event.kind == kWarningEvent; };
        EXPECT_EQ(std::ranges::count_if(events, warned), 1);
    }
    points_.clear();
    link = makeLink();  // goes on with the mission: told already, but no better known
    hearLines(*link);
    EXPECT_EQ(warnings_.size(), 1U);
    EXPECT_TRUE(last_.wheels_assumed);
}

TEST_F(LiveLinkOnPty, DoesNotWarnOfWheelsThatTheOperatorHasDescribed) {
    const auto link = makeLink(spokenVehicle());
    hearLines(*link);
    EXPECT_TRUE(warnings_.empty());
    EXPECT_FALSE(last_.wheels_assumed);
}

TEST_F(LiveLinkOnPty, WhatIsAskedNowIsNotDoneLaterWhenTheRobotIsBack) {
    auto robot = std::make_unique<TalkingRobot>(port(), 60.0, ReplayScript{.speed = 1.0});
    auto link = makeLink();
    std::vector<RequestProgress> progress;
    QObject::connect(link.get(), &LiveLink::batchReady, [&](const LiveBatch& batch) {
        progress.insert(progress.end(), batch.requests.begin(), batch.requests.end());
    });
    link->open(SerialAddress{port()});
    ASSERT_TRUE(QTest::qWaitFor([&] { return points_["hedr"] > 20; }, 5000));
    robot.reset();
    ASSERT_TRUE(QTest::qWaitFor([&] { return last_.port == PortState::kGone; }, 5000));
    link->ask(1, RobotCommand{.kind = CommandKind::kResetPose});
    ASSERT_TRUE(QTest::qWaitFor([&] { return !progress.empty(); }, 5000));
    EXPECT_EQ(progress.back().state, RequestState::kCanceled);
}

}  // namespace
}  // namespace hedr
