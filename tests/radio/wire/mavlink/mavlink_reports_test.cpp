#include "radio/wire/mavlink/mavlink_reports.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>

#include "tests/radio/wire/mavlink/circle_drive.h"
#include "tests/radio/wire/mavlink/golden_frames.h"
#include "tests/radio/wire/mavlink/spoken_mavlink.h"

namespace hedr {
namespace {

using test::heartbeat;
using test::SpokenMavlink;

MavlinkStatustext text(std::string_view words, std::uint8_t severity = 6, std::uint16_t id = 0,
                       std::uint8_t chunk = 0) {
    MavlinkStatustext m{.severity = severity, .id = id, .chunk_seq = chunk};
    std::ranges::copy(words, m.text.begin());
    return m;
}

std::vector<std::string> textsOf(SpokenMavlink& robot) {
    std::vector<std::string> texts;
    for (const EventReport& event : robot.take<EventReport>()) texts.push_back(event.text);
    return texts;
}

TEST(MavlinkReports, SayHelloWithEachHeartbeat) {
    SpokenMavlink robot;
    robot.say(heartbeat(3));
    const auto hello = robot.take<HelloReport>();
    ASSERT_EQ(hello.size(), 1U);
    EXPECT_EQ(hello[0].vehicle, "MAVLink system 7");
    EXPECT_EQ(hello[0].firmware, "ArduPilot");
    EXPECT_EQ(hello[0].geometry, VehicleGeometry{});
    EXPECT_EQ(hello[0].capabilities, kCapabilityNoGeometry | kCapabilityRequests);
    EXPECT_EQ(robot.reports().vehicle(), (MavlinkAddress{7, 1}));
    robot.say(heartbeat(3));
    EXPECT_EQ(robot.take<HelloReport>(), hello);
    const std::vector<std::pair<std::uint8_t, std::string>> names{
        {0, "generic autopilot"}, {12, "PX4"}, {8, "no autopilot"}, {77, "autopilot 77"}};
    for (const auto& [autopilot, name] : names) {
        robot.say(heartbeat(autopilot));
        EXPECT_EQ(robot.take<HelloReport>().at(0).firmware, name);
    }
}

TEST(MavlinkReports, IgnoreGroundStations) {
    SpokenMavlink station({255, 190});
    station.say(MavlinkHeartbeat{.type = 6});
    station.say(MavlinkSysStatus{});
    EXPECT_TRUE(station.take().empty());
    EXPECT_FALSE(station.reports().vehicle());
}

TEST(MavlinkReports, FollowTheFirstSystemThatHasAnAutopilot) {
    SpokenMavlink air;
    air.sayAs({3, 154}, heartbeat());  // a gimbal
    EXPECT_EQ(air.reports().vehicle(), (MavlinkAddress{3, 154}));
    const auto gimbal = air.take<HelloReport>().at(0);
    air.sayAs({9, 1}, heartbeat());
    EXPECT_EQ(air.reports().vehicle(), (MavlinkAddress{9, 1}));
    EXPECT_NE(air.take<HelloReport>().at(0).boot_id, gimbal.boot_id);
    for (const MavlinkAddress other : {MavlinkAddress{3, 154}, MavlinkAddress{4, 1}}) {
        air.sayAs(other, heartbeat());
        air.sayAs(other, MavlinkSysStatus{.voltage_battery = 1});
        air.sayAs(other, text("not this one"));
    }
    EXPECT_TRUE(air.take().empty());
    air.sayAs({9, 1}, MavlinkSysStatus{.voltage_battery = 1});
    EXPECT_EQ(air.take<StatusReport>().size(), 1U);
}

TEST(MavlinkReports, WaitForAHeartbeat) {
    SpokenMavlink robot;
    robot.say(MavlinkSysStatus{.voltage_battery = 12000});
    robot.say(text("who am I?"));
    EXPECT_TRUE(robot.take().empty());
}

TEST(MavlinkReports, TellBatteryFaultsAndRadio) {
    SpokenMavlink robot;
    robot.say(heartbeat());
    (void)robot.take();
    robot.say(MavlinkSysStatus{.onboard_control_sensors_enabled = 1, .voltage_battery = 12345});
    EXPECT_EQ(robot.take<StatusReport>().at(0),
              (StatusReport{.battery_v = 12.345, .faults = 1U << 2}));
    // The modem is a system of its own.
    robot.sayAs({51, 68}, MavlinkRadioStatus{.rssi = 190});
    EXPECT_EQ(robot.take<StatusReport>().at(0),
              (StatusReport{.battery_v = 12.345, .faults = 1U << 2, .radio_dbm = -27}));
    robot.say(MavlinkSysStatus{.voltage_battery = 65535});
    EXPECT_EQ(robot.take<StatusReport>().at(0), (StatusReport{.battery_v = 0.0, .radio_dbm = -27}));
    robot.sayAs({51, 68}, MavlinkRadioStatus{.rssi = 255});
    EXPECT_EQ(robot.take<StatusReport>().at(0), StatusReport{});
}

TEST(MavlinkReports, TakeTheStateOfTheAutopilotOnly) {
    SpokenMavlink robot;
    robot.say(heartbeat());
    (void)robot.take();
    robot.sayAs({7, 191}, MavlinkSysStatus{.voltage_battery = 5000});
    robot.sayAs({7, 191}, text("from the companion"));
    EXPECT_TRUE(robot.take().empty());
}

TEST(MavlinkReports, PutTheSeverityInFrontWhereItMatters) {
    SpokenMavlink robot;
    robot.say(heartbeat());
    for (std::uint8_t severity = 0; severity < 9; ++severity) robot.say(text("x", severity));
    EXPECT_EQ(textsOf(robot),
              (std::vector<std::string>{"Emergency: x", "Alert: x", "Critical: x", "Error: x",
                                        "Warning: x", "x", "x", "x", "x"}));
}

TEST(MavlinkReports, JoinTheChunksOfAText) {
    const std::string fifty(50, 'a');
    SpokenMavlink robot;
    robot.say(heartbeat());
    robot.say(text(fifty, 3, 8, 0));
    robot.say(text(fifty, 3, 8, 1));
    EXPECT_TRUE(textsOf(robot).empty());
    robot.say(text("end", 3, 8, 2));
    EXPECT_EQ(textsOf(robot), std::vector{"Error: " + fifty + fifty + "end"});
    robot.say(text(fifty));  // no chunk, though it is full
    EXPECT_EQ(textsOf(robot), std::vector{fifty});
}

TEST(MavlinkReports, GiveATextAsFarAsItCame) {
    const std::string fifty(50, 'a');
    SpokenMavlink robot;
    robot.say(heartbeat());
    robot.say(text(fifty, 6, 8, 0));
    robot.say(text("end", 6, 8, 2));  // the middle is lost, and so is where the end belongs
    EXPECT_EQ(textsOf(robot), std::vector{fifty + "…"});
    robot.say(text(fifty, 6, 9, 0));
    robot.say(text("new"));
    EXPECT_EQ(textsOf(robot), (std::vector<std::string>{fifty + "…", "new"}));
    robot.say(text(fifty, 6, 10, 0));
    for (int i = 0; i < 3; ++i) robot.say(heartbeat());
    EXPECT_EQ(textsOf(robot), std::vector{fifty + "…"});
}

TEST(MavlinkReports, HoldNoTextWithoutEnd) {
    const std::string fifty(50, 'a');
    SpokenMavlink robot;
    robot.say(heartbeat());
    for (unsigned chunk = 0; chunk < 256; ++chunk) {
        robot.say(text(fifty, 6, 8, static_cast<std::uint8_t>(chunk)));
    }
    robot.say(text("new"));
    const auto texts = textsOf(robot);
    ASSERT_EQ(texts.size(), 2U);
    EXPECT_LE(texts[0].size(), 560U);
}

TEST(MavlinkReports, AnswerRequests) {
    SpokenMavlink robot;
    robot.say(heartbeat());
    (void)robot.take();
    MavlinkParamValue value{.param_value = std::bit_cast<float>(412'345), .param_type = 6};
    std::ranges::copy(std::string_view("HEDR_BASE_UM"), value.param_id.begin());
    robot.say(value);
    EXPECT_EQ(robot.take<ParameterReport>().at(0), (ParameterReport{3, 412'345}));
    robot.say(MavlinkCommandAck{.command = 31010, .result = 2});
    EXPECT_EQ(robot.take<AcknowledgeReport>().at(0), (AcknowledgeReport{1, 3}));
    robot.say(MavlinkTimesync{.tc1 = 12'345'678'000, .ts1 = 0xDEADBEEF});
    EXPECT_EQ(robot.take<TimeEchoReport>().at(0), (TimeEchoReport{0xDEADBEEF, 12.345678}));
}

TEST(MavlinkReports, LeaveWhatIsNoAnswerToUs) {
    SpokenMavlink robot;
    robot.say(heartbeat());
    (void)robot.take();
    robot.say(MavlinkTimesync{.tc1 = 0, .ts1 = 5});  // the robot asks
    robot.say(MavlinkTimesync{.tc1 = 1000, .ts1 = 1'767'268'800'000'000'000});
    robot.say(MavlinkTimesync{.tc1 = 1000, .ts1 = -1});
    robot.say(MavlinkTimesync{.tc1 = 1000, .ts1 = 5, .target_system = 3});
    robot.say(MavlinkParamValue{});
    robot.say(MavlinkCommandAck{.command = 400});
    robot.say(MavlinkCommandLong{.command = 31010});
    robot.say(MavlinkParamSet{});
    EXPECT_TRUE(robot.take().empty());
}

TEST(MavlinkReports, CountFramesAndSignatures) {
    MavlinkReports reports;
    std::uint64_t frames = 0;
    for (const test::GoldenMavlink& golden : test::goldenMavlink()) {
        reports.feed(golden.bytes, [](const Report&) {});
        ++frames;
    }
    EXPECT_EQ(reports.counters().good_frames, frames);
    EXPECT_EQ(reports.signedFrames(), 3U);
}

RC_GTEST_PROP(MavlinkReports, GivesTheSameReportsHoweverTheBytesAreCut, ()) {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    std::vector<std::uint8_t> stream;
    std::uint8_t sequence = 0;
    const auto send = [&](const auto& m) {
        const MavlinkBytes bytes =
            encodeMavlink(m, {.sequence = sequence++, .system = 7, .component = 1});
        stream.insert(stream.end(), bytes.view().begin(), bytes.view().end());
        if (random() % 10 == 0) stream.push_back(static_cast<std::uint8_t>(random()));
    };
    for (int i = 0; i < 60; ++i) {
        const double t = 0.1 * i;
        if (i % 10 == 0) send(heartbeat());
        send(test::attitudeAt(t));
        send(test::odometryAt(t));
        send(test::wheelsAt(t));
    }
    const auto hear = [&](std::size_t longest) {
        std::vector<Report> reports;
        MavlinkReports mavlink;
        for (std::size_t at = 0; at < stream.size();) {
            const std::size_t piece = std::min(1 + random() % longest, stream.size() - at);
            mavlink.feed(std::span(stream).subspan(at, piece),
                         [&](const Report& report) { reports.push_back(report); });
            at += piece;
        }
        return std::pair(reports, mavlink.counters());
    };
    const auto whole = hear(1U << 30);
    RC_ASSERT(whole.first.size() > 80U);
    RC_ASSERT(hear(1) == whole);
    RC_ASSERT(hear(100) == whole);
}

}  // namespace
}  // namespace hedr
