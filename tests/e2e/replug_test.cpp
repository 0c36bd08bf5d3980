// A cable that is pulled and plugged in again, in earnest: the terminal hangs up, and another one
// comes under the same name.
#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <iostream>

#include "core/mission/mission_reader.h"
#include "radio/live_link.h"
#include "radio/recomputation.h"
#include "radio/robot_line.h"
#include "tests/radio/source/source_listener.h"
#include "tests/radio/spoken_drive.h"

namespace hedr {
namespace {

using Bytes = std::vector<std::uint8_t>;

class Replugged : public ::testing::Test {
  protected:
    QString port() const { return folder_.filePath("robot"); }
    std::filesystem::path mission() const { return folder_.filePath("m.hedr").toStdString(); }

    void open() {
        link_ = std::make_unique<LiveLink>(LiveLink::Setup{
            .vehicle = {},
            .mission = mission(),
            .header = {.start = std::chrono::system_clock::now(), .program_version = "test"}});
        QObject::connect(link_.get(), &LiveLink::batchReady,
                         [this](const LiveBatch& batch) { last_ = batch; });
        link_->open(SerialAddress{port(), 57600});
    }

    // Plugs the cable in, lets the robot say a part of what it has to say, and pulls the cable.
    void plugInAndPull(std::span<const std::uint8_t> part) {
        RobotLine line = RobotLine::openPseudoTerminal(port().toStdString()).value();
        QElapsedTimer timer;
        timer.start();
        ASSERT_TRUE(soon([&] { return last_.port == PortState::kOpen; }));
        slowest_ms_ = std::max(slowest_ms_, timer.elapsed());
        line.send(part);
        said_.insert(said_.end(), part.begin(), part.end());
        ASSERT_TRUE(soon([&] { return last_.link.bytes == said_.size(); }));
        { const RobotLine pulled = std::move(line); }
        ASSERT_TRUE(soon([&] { return last_.port == PortState::kGone; }));
        EXPECT_EQ(last_.port_error->code, ErrorCode::kPortMissing);
    }

    void replug(int times) {
        const Bytes drive = spoken(straightDrive(0.5 * times));
        const std::size_t share = drive.size() / static_cast<std::size_t>(times) + 1;
        open();
        for (std::size_t begin = 0; begin < drive.size(); begin += share) {
            const std::size_t size = std::min(share, drive.size() - begin);
            ASSERT_NO_FATAL_FAILURE(plugInAndPull(std::span(drive).subspan(begin, size)));
        }
        link_->close();
        std::cout << times << " times: back after at most " << slowest_ms_ << " ms\n";
        EXPECT_LT(slowest_ms_, 2000);
        EXPECT_EQ(last_.link.reconnects, static_cast<std::uint64_t>(times - 1));
        EXPECT_EQ(last_.link.lost_frames, 0U);
        // Of a frame that the cable cut in two the end is none.
        EXPECT_LT(last_.link.bad_frames, static_cast<std::uint64_t>(times));
        EXPECT_EQ(last_.link.restarts, 0U);
        expectAllRecorded(times);
    }

    void expectAllRecorded(int times) const {
        Bytes kept;
        std::map<StreamKind, int> marks;
        const auto reader = MissionReader::open(mission());
        ASSERT_TRUE(reader);
        ASSERT_TRUE(reader->forEachStreamRow([&](const StreamRow& row) {
            ++marks[row.kind];
            if (row.kind == StreamKind::kBytes)
                kept.insert(kept.end(), row.data.begin(), row.data.end());
            return true;
        }));
        EXPECT_TRUE(kept == said_) << kept.size() << " of " << said_.size() << " bytes";
        EXPECT_EQ(marks[StreamKind::kPortOpened], times);
        EXPECT_EQ(marks[StreamKind::kPortLost], times);
        const auto again = recomputeTracks(mission(), {});
        ASSERT_TRUE(again);
        for (const RecomputedTrack& track : again->tracks) EXPECT_TRUE(track.as_live) << track.name;
    }

    QTemporaryDir folder_;
    std::unique_ptr<LiveLink> link_;
    LiveBatch last_{};
    Bytes said_;
    qint64 slowest_ms_ = 0;
};

TEST_F(Replugged, ThirtyTimesTheSameMissionGoesOnWithinTwoSeconds) { replug(30); }

TEST_F(Replugged, DISABLED_AHundredTimesTheSameMissionGoesOnWithinTwoSeconds) { replug(100); }

TEST_F(Replugged, AfterALongWhileTheMissionSaysHowLongItWasSilent) {
    const Bytes drive = spoken(straightDrive(4.0));
    const std::size_t half = drive.size() / 2;
    open();
    ASSERT_NO_FATAL_FAILURE(plugInAndPull(std::span(drive).first(half)));
    QTest::qWait(3100);
    ASSERT_NO_FATAL_FAILURE(plugInAndPull(std::span(drive).subspan(half)));
    link_->close();
    expectAllRecorded(2);
    const auto events = MissionReader::open(mission()).value().events().value();
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events[0].kind, kGapEvent);
    EXPECT_NEAR(std::stod(events[0].text), 3.3, 0.3);
}

}  // namespace
}  // namespace hedr
