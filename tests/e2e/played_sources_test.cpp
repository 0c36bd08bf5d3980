// A simulated robot and a recording through the whole river: what a port would give.
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <algorithm>
#include <map>

#include "core/mission/mission_reader.h"
#include "radio/live_link.h"
#include "radio/recomputation.h"
#include "tests/e2e/gathered_tracks.h"
#include "tests/e2e/program.h"
#include "tests/e2e/talking_robot.h"
#include "tests/radio/source/source_listener.h"

namespace hedr {
namespace {

constexpr auto kWheelbase = static_cast<std::uint8_t>(RobotParameter::kWheelbaseUm);

class PlayedSource : public ::testing::Test {
  protected:
    QString path(const char* name) const { return folder_.filePath(QLatin1String(name)); }

    std::unique_ptr<LiveLink> makeLink(const char* mission) {
        tracks_.clear();
        last_ = {};
        auto link = std::make_unique<LiveLink>(LiveLink::Setup{
            .vehicle = {},
            .mission = path(mission).toStdString(),
            .header = {.start = std::chrono::system_clock::now(), .program_version = "test"}});
        QObject::connect(link.get(), &LiveLink::batchReady, [this](const LiveBatch& batch) {
            last_ = batch;
            gather(tracks_, batch);
            for (const RequestProgress& progress : batch.requests) requests_.push_back(progress);
        });
        return link;
    }

    bool isOver() const {
        return last_.port_error && last_.port_error->code == ErrorCode::kReplayEnded;
    }

    // Bytes and marks of the port, as they follow one another.
    std::vector<std::pair<StreamKind, QByteArray>> streamOf(const char* mission) const {
        std::vector<std::pair<StreamKind, QByteArray>> stream;
        const auto reader = MissionReader::open(path(mission).toStdString());
        if (!reader) return stream;
        (void)reader->forEachStreamRow([&](const StreamRow& row) {
            const QByteArray bytes(reinterpret_cast<const char*>(row.data.data()),
                                   static_cast<qsizetype>(row.data.size()));
            if (row.kind == StreamKind::kSent) return true;
            const bool goes_on = row.kind == StreamKind::kBytes && !stream.empty() &&
                                 stream.back().first == StreamKind::kBytes;
            if (goes_on) {
                stream.back().second += bytes;
            } else {
                stream.emplace_back(row.kind, bytes);
            }
            return true;
        });
        return stream;
    }

    QTemporaryDir folder_;
    LiveBatch last_;
    GatheredTracks tracks_;
    std::vector<RequestProgress> requests_;
};

TEST_F(PlayedSource, ASimulatedRobotGivesTracksAndAnswers) {
    auto link = makeLink("m.hedr");
    link->open(parseLinkAddress("sim://umbmark?seed=3&speed=50").value());
    ASSERT_TRUE(soon([&] { return tracks_["hedr"].size() > 1000; }, 20000));
    EXPECT_EQ(last_.port, PortState::kOpen);
    EXPECT_GT(last_.driven_m, 1.0);
    EXPECT_EQ(last_.link.lost_frames, 0U);
    EXPECT_EQ(last_.link.bad_frames, 0U);
    link->ask(1, ParameterGet{kWheelbase});
    ASSERT_TRUE(
        soon([&] { return !requests_.empty() && requests_.back().state == RequestState::kDone; }));
    EXPECT_GT(requests_.back().value, 0);
    link->close();
    link.reset();
    EXPECT_TRUE(recomputeTrack(path("m.hedr").toStdString(), "hedr", {}).value().as_live);
}

TEST_F(PlayedSource, ARecordingGivesTheReportsOfThatTimeBitForBit) {
    {
        auto robot = std::make_unique<TalkingRobot>(
            path("robot"), 60.0, ReplayScript{.speed = 20.0, .faults = {.loss = 0.05}});
        auto link = makeLink("first.hedr");
        link->open(SerialAddress{path("robot")});
        ASSERT_TRUE(soon([&] { return tracks_["hedr"].size() > 700; }));
        robot.reset();  // unplugged, and another one plugged in
        ASSERT_TRUE(soon([&] { return last_.port == PortState::kGone; }));
        robot = std::make_unique<TalkingRobot>(path("robot"), 20.0, ReplayScript{.speed = 20.0});
        ASSERT_TRUE(soon([&] { return robot->done(); }));
        link->close();
    }
    const GatheredTracks live = tracks_;
    const LinkHealth health = last_.link;
    EXPECT_EQ(health.reconnects, 1U);
    auto link = makeLink("second.hedr");
    link->open(parseLinkAddress("file://" + path("first.hedr") + "?speed=20").value());
    ASSERT_TRUE(soon([&] { return isOver(); }, 20000));
    link->close();
    link.reset();
    EXPECT_EQ(last_.link, health);
    ASSERT_EQ(tracks_.size(), live.size());
    for (const auto& [name, points] : live) EXPECT_TRUE(tracks_[name] == points) << name;
    EXPECT_EQ(streamOf("second.hedr"), streamOf("first.hedr"));
}

TEST_F(PlayedSource, ARecordingConfirmsNoWish) {
    {
        auto link = makeLink("first.hedr");
        link->open(parseLinkAddress("sim://umbmark?speed=10").value());
        ASSERT_TRUE(soon([&] { return tracks_["hedr"].size() > 100; }, 20000));
        link->ask(1, ParameterSet{kWheelbase, 123456});
        ASSERT_TRUE(soon(
            [&] { return !requests_.empty() && requests_.back().state == RequestState::kDone; }));
        link->close();
    }
    requests_.clear();
    auto link = makeLink("second.hedr");
    link->open(RecordingAddress{path("first.hedr")});
    ASSERT_TRUE(soon([&] { return last_.port == PortState::kOpen; }));
    link->ask(2, ParameterSet{kWheelbase, 123456});
    ASSERT_TRUE(soon([&] { return !requests_.empty(); }));
    EXPECT_EQ(requests_.back().state, RequestState::kCanceled);
}

TEST_F(PlayedSource, AMissionIsNotRecordedIntoItself) {
    ASSERT_EQ(
        run(kHedrTool, {"record", "--port", "sim://umbmark?speed=10000", "--out", path("m.hedr")})
            .exit_code,
        0);
    auto link = makeLink("m.hedr");
    link->open(RecordingAddress{path("m.hedr")});
    ASSERT_TRUE(soon([&] { return last_.port == PortState::kGone; }, 20000));
    EXPECT_EQ(last_.port_error->detail, "it is the mission that is being recorded to");
}

TEST_F(PlayedSource, IsRecordedToItsEndByTheTool) {
    const Outcome first = run(kHedrTool, {"record", "--port", "sim://umbmark?seed=3&speed=1000",
                                          "--out", path("a.hedr")});
    ASSERT_EQ(first.exit_code, 0) << first.err.toStdString();
    const Outcome second = run(
        kHedrTool,
        {"record", "--port", "file://" + path("a.hedr") + "?speed=1000", "--out", path("b.hedr")});
    ASSERT_EQ(second.exit_code, 0) << second.err.toStdString();
    const auto first_track = recomputeTrack(path("a.hedr").toStdString(), "hedr", {});
    const auto second_track = recomputeTrack(path("b.hedr").toStdString(), "hedr", {});
    ASSERT_TRUE(first_track && second_track);
    EXPECT_TRUE(first_track->as_live && second_track->as_live);
    EXPECT_TRUE(first_track->points == second_track->points);
}

TEST_F(PlayedSource, ThatCannotBeIsRefusedInOneSentence) {
    const Outcome unknown =
        run(kHedrTool, {"record", "--port", "sim://mars", "--out", path("m.hedr")});
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_TRUE(unknown.err.contains("packbot-corridors")) << unknown.err.toStdString();
    const Outcome missing =
        run(kHedrTool, {"record", "--port", "no.hedr", "--out", path("m.hedr")});
    EXPECT_EQ(missing.exit_code, 1);
    EXPECT_TRUE(missing.err.contains("There is no file")) << missing.err.toStdString();
    const Outcome ocu = run(kHedrOcu, {"--port", "file://m.hedr", "--exit-after", "1"});
    EXPECT_EQ(ocu.exit_code, 2);
    EXPECT_TRUE(ocu.err.contains("full path")) << ocu.err.toStdString();
}

}  // namespace
}  // namespace hedr
