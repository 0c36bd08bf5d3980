// Everything that a radio, a cable and a robot do wrong, over a pseudo-terminal and over UDP: the
// counters that come out, tracks that do not jump, and a mission that holds every byte.
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QUdpSocket>
#include <QtTest/QTest>
#include <cmath>
#include <iostream>
#include <thread>

#include "core/mission/mission_reader.h"
#include "radio/live_link.h"
#include "radio/recomputation.h"
#include "radio/robot_line.h"
#include "radio/wire/codec.h"
#include "radio/wire/frame_encoder.h"
#include "tests/e2e/gathered_tracks.h"
#include "tests/radio/spoken_drive.h"

namespace hedr {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Packets = std::vector<Bytes>;

// What reaches the laptop, datagram by datagram, and what the radio has done to it.
struct Sent {
    Packets packets;
    RadioDeeds deeds{};
    std::uint64_t frames = 0;
};

// The first and the last frames come whole, so that every loss lies between two numbers.
Sent drive(const RadioFaults& faults) {
    constexpr std::size_t kSafe = 50;
    Sent sent;
    FaultyRadio radio(faults);
    SimulatedRobot robot(spokenVehicle(), {});
    const auto deliver = [&](std::span<const std::uint8_t> bytes) {
        sent.packets.emplace_back(bytes.begin(), bytes.end());
    };
    const auto reports = straightDrive(40.0);
    for (std::size_t i = 0; i < reports.size(); ++i) {
        const bool safe = i < kSafe || i + kSafe >= reports.size();
        if (i + kSafe == reports.size()) radio.flush(deliver);
        radio.passTime(reports[i].robot_time_s, deliver);
        robot.sense(reports[i], [&](std::span<const std::uint8_t> frame) {
            ++sent.frames;
            safe ? deliver(frame) : radio.send(frame, deliver);
        });
    }
    sent.deeds = radio.deeds();
    return sent;
}

struct Case {
    const char* name;
    RadioFaults faults;
    bool datagrams_only = false;
};

void PrintTo(const Case& each, std::ostream* out) { *out << each.name; }

const Case kCases[] = {
    {"nothing", {}},
    {"loss_10", {.loss = 0.1}},
    {"loss_50", {.loss = 0.5, .seed = 3}},
    {"burst_5_s", {.burst_at_s = 12.0, .burst_s = 5.0}},
    {"corrupt_1", {.corrupt = 0.01}},
    {"corrupt_10", {.corrupt = 0.1, .seed = 5}},
    {"noise", {.noise = 0.5}},
    {"duplicates", {.duplicate = 0.2}},
    {"truncated", {.truncate = 0.2}},
    {"late_2_s", {.delay_s = 2.0}},
    {"reordered", {.reorder = 0.1}, true},
    {"all", {.loss = 0.1, .noise = 0.1, .duplicate = 0.1, .reorder = 0.1}, true},
};

class FaultMatrix : public ::testing::TestWithParam<Case> {
  protected:
    std::filesystem::path mission() const { return folder_.filePath("m.hedr").toStdString(); }

    std::unique_ptr<LiveLink> makeLink() {
        auto link = std::make_unique<LiveLink>(LiveLink::Setup{
            .vehicle = {},
            .mission = mission(),
            .header = {.start = std::chrono::system_clock::now(), .program_version = "test"}});
        QObject::connect(link.get(), &LiveLink::batchReady, [this](const LiveBatch& batch) {
            last_ = batch;
            gather(tracks_, batch);
            for (const EventReport& event : batch.robot_events) events_.push_back(event.text);
        });
        return link;
    }

    void throughPty(const Packets& packets) {
        const QString port = folder_.filePath("robot");
        RobotLine line = RobotLine::openPseudoTerminal(port.toStdString()).value();
        auto link = makeLink();
        link->open(SerialAddress{port, 57600});
        ASSERT_TRUE(QTest::qWaitFor([&] { return line.someoneListens(); }, 5000));
        std::thread robot([&] {
            for (const Bytes& packet : packets) line.send(packet);
        });
        waitForAll(packets);
        robot.join();
        link->close();
    }

    void throughUdp(const Packets& packets) {
        QUdpSocket robot;
        ASSERT_TRUE(robot.bind(QHostAddress::LocalHost));
        std::uint16_t port = 0;
        {
            QUdpSocket free;
            ASSERT_TRUE(free.bind(QHostAddress::LocalHost));
            port = free.localPort();
        }
        auto link = makeLink();
        link->open(UdpListenAddress{"127.0.0.1", port});
        std::size_t in_a_row = 0;
        for (const Bytes& packet : packets) {
            robot.writeDatagram(reinterpret_cast<const char*>(packet.data()),
                                static_cast<qint64>(packet.size()), QHostAddress::LocalHost, port);
            if (++in_a_row % 50 == 0) QCoreApplication::processEvents();
        }
        waitForAll(packets);
        link->close();
    }

    void waitForAll(const Packets& packets) {
        std::size_t size = 0;
        for (const Bytes& packet : packets) size += packet.size();
        EXPECT_TRUE(QTest::qWaitFor([&] { return last_.link.bytes >= size; }, 10000));
    }

    // Every byte is there, in order, and says again what it said.
    void expectAllRecorded(const Packets& packets) const {
        Bytes said;
        for (const Bytes& packet : packets) said.insert(said.end(), packet.begin(), packet.end());
        Bytes kept;
        const auto reader = MissionReader::open(mission());
        ASSERT_TRUE(reader);
        ASSERT_TRUE(reader->forEachStreamRow([&](const StreamRow& row) {
            if (row.kind == StreamKind::kBytes)
                kept.insert(kept.end(), row.data.begin(), row.data.end());
            return true;
        }));
        EXPECT_TRUE(kept == said) << kept.size() << " of " << said.size() << " bytes";
        std::cout << kept.size() << " of " << said.size() << " bytes recorded\n";
        const auto again = recomputeTracks(mission(), {});
        ASSERT_TRUE(again);
        EXPECT_EQ(again->tracks.size(), tracks_.size());
        for (const RecomputedTrack& track : again->tracks) {
            EXPECT_TRUE(track.as_live) << track.name;
            ASSERT_EQ(track.points.size(), tracks_.at(track.name).size()) << track.name;
        }
    }

    void expectNoJump() const {
        for (const auto& [name, points] : tracks_) {
            for (std::size_t i = 1; i < points.size(); ++i) {
                const auto step = points[i].pose.position - points[i - 1].pose.position;
                const double dt_s = points[i].t_s - points[i - 1].t_s;
                ASSERT_LE(std::hypot(step.x, step.y), 0.6 * dt_s + 0.02) << name << " " << i;
            }
        }
    }

    void expectCounters(const Sent& sent) const {
        const RadioDeeds& deeds = sent.deeds;
        const LinkHealth& link = last_.link;
        const auto& faults = GetParam().faults;
        const bool overtaken = faults.reorder > 0.0;
        const std::uint64_t gone = deeds.lost + deeds.corrupted + deeds.truncated;
        EXPECT_EQ(link.lost_frames, gone);
        EXPECT_EQ(link.good_frames, sent.frames - gone + deeds.duplicated);
        if (overtaken) {
            EXPECT_GT(link.late_frames, 0U);
            EXPECT_LE(link.late_frames, deeds.reordered + deeds.duplicated);
        } else {
            EXPECT_EQ(link.late_frames, deeds.duplicated);
        }
        EXPECT_EQ(link.restarts, 0U);
        EXPECT_EQ(link.reconnects, 0U);
        EXPECT_EQ(link.unknown_frames, 0U);
        const bool clean = faults.corrupt + faults.noise + faults.truncate == 0.0;
        EXPECT_EQ(link.bad_frames == 0, clean) << link.bad_frames;
    }

    QTemporaryDir folder_;
    LiveBatch last_;
    GatheredTracks tracks_;
    std::vector<std::string> events_;
};

TEST_P(FaultMatrix, OverAPseudoTerminal) {
    if (GetParam().datagrams_only) GTEST_SKIP() << "a serial line does not reorder";
    const Sent sent = drive(GetParam().faults);
    throughPty(sent.packets);
    expectCounters(sent);
    expectNoJump();
    expectAllRecorded(sent.packets);
}

TEST_P(FaultMatrix, OverUdp) {
    const Sent sent = drive(GetParam().faults);
    throughUdp(sent.packets);
    expectCounters(sent);
    expectNoJump();
    expectAllRecorded(sent.packets);
}

INSTANTIATE_TEST_SUITE_P(Radio, FaultMatrix, ::testing::ValuesIn(kCases),
                         [](const auto& each) { return std::string(each.param.name); });

// Faults of the robot's own.
class StrangeRobot : public FaultMatrix {};

Bytes frameOf(const Report& report, std::uint16_t sequence) {
    const auto frame = encodeReport(report, sequence);
    return {frame->view().begin(), frame->view().end()};
}

TEST_F(StrangeRobot, WhoseTextIsHostileIsShownAndRecordedClean) {
    Sent sent = drive({});
    auto sequence = static_cast<std::uint16_t>(sent.frames);
    for (const char* text : {"\x1b[2J\r\nowned", "\xff\xfe\xc0\xaf", "%s%n%x", "exe\u202Egpj"})
        sent.packets.push_back(frameOf(EventReport{40.0, text}, sequence++));
    throughPty(sent.packets);
    EXPECT_EQ(events_, (std::vector<std::string>{" [2J  owned", "\uFFFD\uFFFD\uFFFD\uFFFD",
                                                 "%s%n%x", "exe\uFFFDgpj"}));
    std::vector<std::string> kept;
    const auto events = MissionReader::open(mission()).value().events().value();
    for (const MissionEvent& event : events) {
        if (event.kind == kRobotEvent) kept.push_back(event.text);
    }
    EXPECT_EQ(kept, events_);
    expectAllRecorded(sent.packets);
}

TEST_F(StrangeRobot, WhoseMessagesAreUnknownOrTooLongDoesNoHarm) {
    Sent sent = drive({});
    auto sequence = static_cast<std::uint16_t>(sent.frames);
    const Bytes payload(200, 0x55);
    for (const int id : {0x3F, 0x20, 0x3E}) {
        const FrameBytes frame = encodeFrame({static_cast<std::uint8_t>(id), sequence++, payload});
        sent.packets.emplace_back(frame.view().begin(), frame.view().end());
    }
    Bytes endless(5000, 0x11);  // no end of a frame for longer than one can be
    endless.push_back(0);
    sent.packets.push_back(endless);
    sent.packets.push_back(frameOf(StatusReport{.battery_v = 12.0}, sequence));
    throughPty(sent.packets);
    EXPECT_EQ(last_.link.unknown_frames, 3U);
    EXPECT_EQ(last_.link.bad_frames, 1U);
    EXPECT_EQ(last_.link.lost_frames, 0U);
    ASSERT_TRUE(last_.status);
    EXPECT_EQ(last_.status->battery_v, 12.0);
    expectNoJump();
    expectAllRecorded(sent.packets);
}

TEST_F(StrangeRobot, WhichIsRestartedInMidDriveIsToldFromALoss) {
    Sent sent;
    SimulatedRobot robot(spokenVehicle(), {});
    const auto send = [&](std::span<const std::uint8_t> frame) {
        sent.packets.emplace_back(frame.begin(), frame.end());
    };
    for (const SensorReport& report : straightDrive(40.0)) {
        if (report.robot_time_s == 0.02 * 1000) robot.restart();
        robot.sense(report, send);
    }
    throughPty(sent.packets);
    EXPECT_EQ(last_.link.restarts, 1U);
    EXPECT_EQ(last_.link.lost_frames, 0U);
    EXPECT_EQ(last_.link.late_frames, 0U);
    EXPECT_NEAR(last_.driven_m, 19.0, 0.1);
    expectNoJump();
    expectAllRecorded(sent.packets);
}

TEST_F(StrangeRobot, WhoseClockRunsBackwardsForAWhileMakesNoJump) {
    Sent sent;
    SimulatedRobot robot(spokenVehicle(), {});
    const auto send = [&](std::span<const std::uint8_t> frame) {
        sent.packets.emplace_back(frame.begin(), frame.end());
    };
    for (SensorReport report : straightDrive(40.0)) {
        if (report.robot_time_s > 20.0) report.robot_time_s -= 5.0;
        robot.sense(report, send);
    }
    throughPty(sent.packets);
    EXPECT_EQ(last_.link.lost_frames, 0U);
    const std::vector<TrackPoint>& hedr = tracks_["hedr"];
    for (std::size_t i = 1; i < hedr.size(); ++i) ASSERT_GE(hedr[i].t_s, hedr[i - 1].t_s);
    EXPECT_NEAR(last_.driven_m, 19.0, 0.2);
    expectAllRecorded(sent.packets);
}

TEST_F(StrangeRobot, UnpluggedAndPluggedInAHundredTimesLosesNothing) {
    const Sent sent = drive({});
    const std::size_t share = sent.packets.size() / 101 + 1;
    const QString port = folder_.filePath("robot");
    auto link = makeLink();
    std::size_t next = 0;
    std::size_t size = 0;
    for (int round = 0; round <= 100; ++round) {
        // The source is opened anew, as after its retry: a hundred waits of 250 ms are not the
        // test.
        RobotLine line = RobotLine::openPseudoTerminal(port.toStdString()).value();
        link->open(SerialAddress{port, 57600});
        ASSERT_TRUE(QTest::qWaitFor([&] { return line.someoneListens(); }, 5000));
        for (std::size_t i = 0; i < share && next < sent.packets.size(); ++i, ++next) {
            line.send(sent.packets[next]);
            size += sent.packets[next].size();
        }
        ASSERT_TRUE(QTest::qWaitFor([&] { return last_.link.bytes == size; }, 5000)) << round;
    }
    link->close();
    EXPECT_EQ(last_.link.reconnects, 100U);
    EXPECT_EQ(last_.link.lost_frames, 0U);
    EXPECT_EQ(last_.link.restarts, 0U);
    expectNoJump();
    expectAllRecorded(sent.packets);
}

}  // namespace
}  // namespace hedr
