#include "ui/panels/status_tiles.h"

#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "tests/ui/scene.h"
#include "ui/link/link_advice.h"

namespace hedr {
namespace {

using test::atSecond;

QString plain(QString text) { return text.replace(QChar(0x00A0), QChar(' ')); }

std::vector<StatusTile> tilesOf(const LiveBatch& batch, double silence_s) {
    LiveModel model;
    model.apply(batch, atSecond(10.0));
    return statusTiles(model, atSecond(10.0 + silence_s));
}

TEST(StatusTiles, SayHowFarOffTheRobotMayBeInMetresAndDegrees) {
    LiveBatch batch = test::sampleBatch(10.0);
    const auto deg = static_cast<float>(radFromDeg(1.0));
    batch.tracks = {{"hedr_bayes", {{10.0, {{3, 3}, 0.0}, 0.0, {0.09F, 0.0F, 0.16F, deg * deg}}}}};
    const auto tiles = tilesOf(batch, 0.0);
    EXPECT_EQ(tiles[1].value, "GOOD");
    EXPECT_EQ(plain(tiles[1].detail), "±1.0 m ±2.0°");
    EXPECT_TRUE(tiles[1].note.contains("95 %")) << "files have one standard deviation";
    EXPECT_EQ(tilesOf(batch, 7.0)[1].note, "") << "no figure, nothing to explain";
}

TEST(StatusTiles, SayThatTheHeadingIsUnknownBeyondAQuarterTurnEitherWay) {
    LiveBatch batch = test::sampleBatch(10.0);
    const auto detailAt = [&](double two_sigma_deg) {
        const double sigma_rad = radFromDeg(two_sigma_deg) / 2.0;
        const auto variance = static_cast<float>(sigma_rad * sigma_rad);
        batch.tracks = {
            {"odometry", {{10.0, {{3, 3}, 0.0}, 0.0, {1250.0F, 0.0F, 1250.0F, variance}}}}};
        return plain(tilesOf(batch, 0.0)[1].detail);
    };
    EXPECT_EQ(detailAt(89.9), "±100.0 m ±89.9° · no heading check");
    for (const double deg : {90.1, 360.0, 1e6}) {
        EXPECT_EQ(detailAt(deg), "heading unknown, ±100.0 m · no heading check") << deg;
    }
}

TEST(StatusTiles, SayThatTheRobotStillSearchesForTheCorridors) {
    LiveBatch batch = test::sampleBatch(10.0);
    batch.tracks = {{"robot", {{10.0, {{3, 3}, 0.0}, 0.0}}}};
    batch.statuses = {
        {"robot", {.state = HedrState::kSuspended, .reason = SuspendReason::kSearching}}};
    EXPECT_TRUE(tilesOf(batch, 0.0)[1].detail.startsWith("seeking corridors"));
}

TEST(StatusTiles, SayThatTheCorridorsDirectionIsLost) {
    LiveBatch batch = test::sampleBatch(10.0);
    batch.statuses = {{"hedr_bayes", {.state = HedrState::kSuspended, .lost = true}}};
    const auto tiles = tilesOf(batch, 0.0);
    EXPECT_EQ(tiles[1].value, "LOST LOCK");
    EXPECT_EQ(tiles[1].tone, Tone::kAlarm);
    EXPECT_EQ(tiles[1].mark, Mark::kTriangle);
    EXPECT_TRUE(tiles[1].detail.endsWith("corridors lost"));
    EXPECT_TRUE(tiles[2].detail.endsWith("unknown now"));
}

TEST(StatusTiles, SayThatNothingChecksTheHeadingOfPlainOdometry) {
    LiveModel model;
    model.apply(test::sampleBatch(10.0), atSecond(10.0));
    model.choosePrimary("odometry");
    auto tiles = statusTiles(model, atSecond(10.0));
    EXPECT_EQ(tiles[1].value, "OFF");
    EXPECT_EQ(tiles[1].detail, "no heading check");
    EXPECT_TRUE(tiles[1].note.contains("Nothing checks this heading"));
    EXPECT_EQ(tiles[1].tone, Tone::kWarning);
    EXPECT_EQ(tiles[2].detail, "") << "nothing tells its drift";
    model.choosePrimary("robot");
    tiles = statusTiles(model, atSecond(10.0));
    EXPECT_EQ(tiles[1].value, "GOOD");
    EXPECT_EQ(tiles[1].detail, "HEDR active") << "the robot tells no variances";
}

TEST(StatusTiles, ShowALiveMission) {
    const auto tiles = tilesOf(test::sampleBatch(10.0), 0.0);
    ASSERT_EQ(tiles.size(), 7u);
    EXPECT_EQ(tiles[0].value, "LIVE");
    EXPECT_EQ(plain(tiles[0].detail), "loss 0.4 % · unsigned · 120 Hz · −71 dBm");
    EXPECT_EQ(tiles[1].value, "GOOD");
    EXPECT_EQ(plain(tiles[2].detail), "drift +3.1 °/min, removed");
    EXPECT_EQ(plain(tiles[3].value), "0.62 m/s");
    EXPECT_EQ(tiles[6].value, "REC");
    EXPECT_EQ(plain(tiles[6].detail), "3.1 MB");
}

TEST(StatusTiles, DimOldValuesAndSayHowOldTheyAre) {
    const auto tiles = tilesOf(test::sampleBatch(10.0), 7.2);
    EXPECT_EQ(plain(tiles[0].value), "LOST 7 s");
    EXPECT_EQ(tiles[0].mark, Mark::kCross);
    EXPECT_EQ(tiles[1].value, "COASTING");
    for (const std::size_t i : {2u, 3u, 4u}) {
        EXPECT_EQ(plain(tiles[i].detail), "7 s old");
        EXPECT_EQ(tiles[i].tone, Tone::kDim);
    }
    EXPECT_EQ(tiles[5].tone, Tone::kPlain) << "the mission's clock goes on";
}

TEST(StatusTiles, ShowStaleByWordAndShape) {
    const auto tiles = tilesOf(test::sampleBatch(10.0), 1.5);
    EXPECT_EQ(plain(tiles[0].value), "STALE 1 s");
    EXPECT_EQ(tiles[0].mark, Mark::kTriangle);
}

TEST(StatusTiles, AreAllDimAndOldAfterDisconnecting) {
    LiveModel model;
    LiveBatch batch = test::sampleBatch(10.0);
    model.apply(batch, atSecond(10.0));
    batch.port = PortState::kClosed;
    model.apply(batch, atSecond(11.0));
    const auto tiles = statusTiles(model, atSecond(20.0));
    for (const StatusTile& tile : tiles) {
        EXPECT_EQ(tile.tone, Tone::kDim) << tile.label.toStdString();
        EXPECT_NE(tile.mark, Mark::kRecording);
    }
    EXPECT_EQ(tiles[1].value, "–");
    for (const std::size_t i : {1u, 2u, 3u, 4u}) EXPECT_EQ(tiles[i].detail, "old");
    EXPECT_EQ(tiles[6].value, "OFF");
    EXPECT_EQ(plain(tiles[6].detail), "saved 3.1 MB");
    batch.port = PortState::kOpen;
    model.apply(batch, atSecond(21.0));
    const auto waiting = statusTiles(model, atSecond(21.5));
    EXPECT_EQ(waiting[0].value, "WAITING");
    EXPECT_EQ(waiting[1].value, "–");
    EXPECT_EQ(waiting[2].tone, Tone::kDim);
}

TEST(StatusTiles, SayWhichWayHomeIs) {
    LiveBatch batch = test::sampleBatch(10.0);
    batch.tracks = {{"hedr_bayes", {{0.0, {{0, 0}, 0.0}, 0.0}, {1.0, {{3, 3}, 0.0}, 0.0}}}};
    EXPECT_EQ(plain(tilesOf(batch, 0.0)[4].detail), "towards 225°");
}

TEST(StatusTiles, ShowThatARecordingThatFailsIsKeptInMemory) {
    LiveBatch batch = test::sampleBatch(10.0);
    batch.recorder.error = Error{ErrorCode::kDiskFull, "/missions/a.hedr", ""};
    const auto tiles = tilesOf(batch, 0.0);
    EXPECT_EQ(tiles[6].value, "DISK FULL");
    EXPECT_TRUE(tiles[6].detail.startsWith("kept in memory"));
    EXPECT_EQ(tiles[6].tone, Tone::kAlarm);
    batch.recorder.error = Error{ErrorCode::kFileUnwritable, "/missions/a.hedr", ""};
    EXPECT_EQ(tilesOf(batch, 0.0)[6].value, "NOT SAVED");
}

TEST(StatusTiles, ShowDashesWhereNothingIsKnown) {
    for (const StatusTile& tile : tilesOf({}, 0.0)) {
        if (tile.label == "MISSION") continue;
        EXPECT_TRUE(tile.value == "–" || tile.value == "OFF") << tile.label.toStdString();
        EXPECT_EQ(tile.tone, Tone::kDim);
    }
}

TEST(LinkAdvice, TellsWhatIsWrongAndSinceWhen) {
    test::HandClock hand;
    const auto advice = [&](const LiveBatch& batch, double now_s) {
        LiveModel model;
        hand.set(10.0);
        model.apply(batch, hand.clock().now());
        hand.set(now_s);
        return linkAdvice(model.last(), model.link(hand.clock().now()), hand.clock());
    };
    LiveBatch batch = test::sampleBatch(10.0);
    EXPECT_EQ(advice(batch, 10.5), "");
    EXPECT_EQ(advice(batch, 17.0),
              "No packets since 13:58:01. Radio is plugged in, robot is silent.");
    batch.last_byte = atSecond(16.9);
    EXPECT_TRUE(advice(batch, 17.0).contains("Looking for the baud rate"));
    batch.address = SerialAddress{"/dev/ttyUSB0", 57600};
    EXPECT_TRUE(advice(batch, 17.0).contains("Check the baud rate"));
    batch.refusal = "the lines hold no time";
    EXPECT_TRUE(advice(batch, 17.0).endsWith("The lines hold no time."));
    batch.refusal.clear();
    batch.last_good = atSecond(16.9);
    EXPECT_EQ(advice(batch, 17.0),
              "The robot is heard, but since 13:58:01 it has not said how it moves.");
    batch.last_good.reset();
    batch.status->faults = 0b10'0000'1100;
    EXPECT_EQ(advice(batch, 10.5), "The robot reports a fault: gyro, battery low, number 9.");
    batch.status->faults = 0;
    batch.port = PortState::kGone;
    EXPECT_TRUE(advice(batch, 10.1).contains("unplugged"));
    batch.address = TcpListenAddress{};
    EXPECT_TRUE(advice(batch, 10.1).contains("connection to the robot has ended"));
    batch.address = SerialAddress{"/dev/ttyUSB0", 57600};
    batch.port_error = Error{ErrorCode::kPortPermission, "/dev/ttyUSB0", ""};
    EXPECT_TRUE(advice(batch, 10.1).contains("dialout"));
    batch.last_frame.reset();
    batch.port_error = Error{ErrorCode::kPortMissing, "/dev/ttyUSB0", ""};
    EXPECT_TRUE(advice(batch, 10.1).contains("There is no port"));
    batch.address = TcpListenAddress{"", 4501};
    batch.port_error = Error{ErrorCode::kPeerMissing, "tcp://:4501", "nobody has connected yet"};
    EXPECT_EQ(advice(batch, 10.1), "Waiting for the robot to connect to port 4501.");
    batch.port = PortState::kClosed;
    batch.port_error = Error{ErrorCode::kPortMissing, "/dev/ttyUSB9", ""};
    EXPECT_TRUE(advice(batch, 10.1).contains("/dev/ttyUSB9"));
}

}  // namespace
}  // namespace hedr
