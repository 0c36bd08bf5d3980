#include "radio/receiver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "radio/wire/frame_decoder.h"
#include "tests/radio/spoken_drive.h"

namespace hedr {
namespace {

using Tracks = std::map<std::string, std::vector<TrackPoint>>;

// Feeds the bytes in pieces of `piece` bytes.
Tracks hear(Receiver& receiver, const std::vector<std::uint8_t>& bytes, std::size_t piece) {
    Tracks tracks;
    for (std::size_t at = 0; at < bytes.size(); at += piece) {
        receiver.feed(std::span(bytes).subspan(at, std::min(piece, bytes.size() - at)));
        for (NamedPoints& part : receiver.takePoints()) {
            auto& track = tracks[part.name];
            track.insert(track.end(), part.points.begin(), part.points.end());
        }
    }
    return tracks;
}

// The longest way between two neighbouring points.
double longestStep_m(const std::vector<TrackPoint>& track) {
    double longest = 0.0;
    for (std::size_t i = 1; i < track.size(); ++i) {
        longest = std::max(longest, (track[i].pose.position - track[i - 1].pose.position).length());
    }
    return longest;
}

TEST(Receiver, RunsEveryEstimatorAndTheRobotsOwnPose) {
    Receiver receiver({});
    const Tracks tracks = hear(receiver, spoken(straightDrive(20.0)), 64);
    for (const char* name : {"odometry", "gyro", "gyrodometry", "hedr", "robot"}) {
        ASSERT_TRUE(tracks.contains(name)) << name;
        EXPECT_NEAR(tracks.at(name).back().pose.position.x, 9.0, 0.05) << name;
    }
    EXPECT_EQ(receiver.health().lost_frames, 0u);
    EXPECT_EQ(receiver.health().bad_frames, 0u);
    EXPECT_NEAR(receiver.speed_m_s(), 0.5, 0.02);
}

TEST(Receiver, RunsWhatNeedsAMagnetometerOrADriftModelWhereTheVehicleFileHasThem) {
    std::vector<SensorReport> reports = straightDrive(20.0);
    for (std::size_t i = 0; i < reports.size(); i += 10)
        reports[i].magnetic_field = {0.5, 0.1, 0.2};
    Receiver without({});
    const Tracks fewer = hear(without, spoken(reports), 64);
    EXPECT_FALSE(fewer.contains("gh_combined"));
    EXPECT_FALSE(fewer.contains("gyro_kalman"));
    Vehicle vehicle = spokenVehicle();
    vehicle.magnetometer = {0.0, 0.0, 500.0, 500.0};  // thousandths: see simulated_robot.cpp
    vehicle.gyro_drift = {0.0, 0.001, 300.0};
    Receiver with({.vehicle = vehicle});
    const Tracks more = hear(with, spoken(reports), 64);
    for (const char* name : {"gh_gyro", "gh_magnetometer", "gh_combined", "gyro_kalman"}) {
        ASSERT_TRUE(more.contains(name)) << name;
        EXPECT_NEAR(more.at(name).back().pose.position.x, 9.0, 0.05) << name;
    }
    Receiver again({.vehicle = vehicle});
    EXPECT_EQ(hear(again, spoken(reports), 7), more);
}

TEST(Receiver, GivesTheSameBitsHoweverTheBytesAreCut) {
    const auto bytes = spoken(straightDrive(10.0), {.loss = 0.05, .corrupt = 0.01, .noise = 0.2});
    Receiver whole_receiver({});
    const Tracks whole = hear(whole_receiver, bytes, bytes.size());
    for (const std::size_t piece : {1u, 7u, 4096u}) {
        Receiver receiver({});
        EXPECT_EQ(hear(receiver, bytes, piece), whole) << piece;
    }
}

TEST(Receiver, ABadRadioMakesNoJumpAndLosesNoWay) {
    const RadioFaults faults{.loss = 0.05, .corrupt = 0.01, .noise = 0.3};
    Receiver receiver({});
    const Tracks tracks = hear(receiver, spoken(straightDrive(60.0), faults), 100);
    EXPECT_NEAR(tracks.at("odometry").back().pose.position.x, 29.0, 0.2);
    EXPECT_LT(longestStep_m(tracks.at("odometry")), 0.2);
    EXPECT_LT(longestStep_m(tracks.at("robot")), 0.5);
    EXPECT_GT(receiver.health().bad_frames, 100u);
    EXPECT_EQ(receiver.health().restarts, 0u);
}

TEST(Receiver, CountsExactlyTheFramesThatAreMissing) {
    const auto reports = straightDrive(30.0);
    Receiver all({});
    hear(all, spoken(reports), 64);
    Receiver some({});
    hear(some, spoken(reports, {.loss = 0.05}), 64);
    // Frames lost before the first and after the last that came cannot be seen.
    EXPECT_NEAR(static_cast<double>(some.health().good_frames + some.health().lost_frames),
                static_cast<double>(all.health().good_frames), 3.0);
    EXPECT_NEAR(some.health().lossRatio(), 0.05, 0.02);
}

TEST(Receiver, SequenceNumbersWrapWithoutLoss) {
    Receiver receiver({});
    hear(receiver, spoken(straightDrive(1000.0)), 4096);  // 70,000 frames and more
    EXPECT_GT(receiver.health().good_frames, 65536u);
    EXPECT_EQ(receiver.health().lost_frames, 0u);
}

TEST(Receiver, ARestartOfTheRobotMakesNoJump) {
    Receiver receiver({});
    const Tracks tracks = hear(receiver, spoken(straightDrive(40.0), {}, 1000), 64);
    EXPECT_EQ(receiver.health().restarts, 1u);
    EXPECT_NEAR(tracks.at("odometry").back().pose.position.x, 19.0, 0.1);
    EXPECT_LT(longestStep_m(tracks.at("odometry")), 0.05);
    EXPECT_LT(longestStep_m(tracks.at("robot")), 0.1);
    for (const auto& [name, track] : tracks) {
        EXPECT_TRUE(std::is_sorted(track.begin(), track.end(), [](const auto& a, const auto& b) {
            return a.t_s < b.t_s;
        })) << name;
    }
}

std::uint8_t idOf(std::span<const std::uint8_t> frame_bytes) {
    std::uint8_t id = 0;
    FrameDecoder().feed(frame_bytes, [&](const Frame& frame) { id = frame.id; });
    return id;
}

// What reaches the laptop of a drive. `comes` says it of each frame by the number of its report
// and its id.
std::vector<std::uint8_t> heardOf(const std::vector<SensorReport>& reports, int restart_at,
                                  const std::function<bool(int, std::uint8_t)>& comes) {
    std::vector<std::uint8_t> bytes;
    SimulatedRobot robot(spokenVehicle(), {});
    int index = 0;
    for (const SensorReport& report : reports) {
        if (index == restart_at) robot.restart();
        robot.sense(report, [&](std::span<const std::uint8_t> frame) {
            if (comes(index, idOf(frame))) bytes.insert(bytes.end(), frame.begin(), frame.end());
        });
        ++index;
    }
    return bytes;
}

constexpr std::uint8_t kHelloId = 0x01;
constexpr int kRestart = 1001;  // the report, after 20 s

// Its clock stood at `uptime_s` when the laptop began to listen.
std::vector<SensorReport> driveAfter(double uptime_s) {
    std::vector<SensorReport> reports{straightDrive(0.0)};
    for (SensorReport report : straightDrive(40.0)) {
        report.robot_time_s += uptime_s;
        reports.push_back(report);
    }
    return reports;
}

// The first hello after the restart is not heard, and the clock may seem to have gone on: from 40
// minutes to zero is as far as to its wrap.
TEST(Receiver, ARestartThatTheNextHelloTellsMakesNoJump) {
    for (const double uptime_s : {0.02, 600.0, 2400.0}) {
        const auto bytes = heardOf(driveAfter(uptime_s), kRestart, [](int index, std::uint8_t) {
            return index > 0 && (index < kRestart || index > kRestart + 25);
        });
        Receiver receiver({});
        const Tracks tracks = hear(receiver, bytes, 64);
        EXPECT_EQ(receiver.health().restarts, 1u) << uptime_s;
        for (const auto& [name, track] : tracks) {
            EXPECT_LT(longestStep_m(track), 0.1) << name << " after " << uptime_s;
            EXPECT_NEAR(track.back().pose.position.x, 18.6, 0.5) << name << " after " << uptime_s;
        }
    }
}

TEST(Receiver, ARestartMakesNoJumpWhereNoHelloComesAnyMore) {
    const auto bytes = heardOf(driveAfter(600.0), kRestart, [](int index, std::uint8_t id) {
        return index > 0 && (index < kRestart || id != kHelloId);
    });
    Receiver receiver({});
    const Tracks tracks = hear(receiver, bytes, 64);
    for (const auto& [name, track] : tracks) {
        EXPECT_LT(longestStep_m(track), 0.1) << name;
        EXPECT_NEAR(track.back().pose.position.x, 19.0, 0.3) << name;
    }
}

// 75 m, more than could be told from a restart without the hello.
TEST(Receiver, LosesNoWayInALongSilence) {
    const auto bytes = heardOf(straightDrive(200.0), -1, [](int index, std::uint8_t) {
        return index < 1000 || index > 8500;
    });
    Receiver receiver({});
    const Tracks tracks = hear(receiver, bytes, 64);
    EXPECT_EQ(receiver.health().restarts, 0u);
    for (const auto& [name, track] : tracks)
        EXPECT_NEAR(track.back().pose.position.x, 99.0, 0.5) << name;
}

TEST(Receiver, StartsWhereTheRobotSaysItIs) {
    const Pose<World> start{{10.0, 20.0}, 1.5};
    Receiver receiver({});
    const Tracks tracks = hear(receiver, spoken(straightDrive(5.0), {}, -1, start), 64);
    EXPECT_NEAR(tracks.at("hedr").front().pose.position.x, 10.0, 1e-3);
    EXPECT_NEAR(tracks.at("hedr").front().pose.heading_rad, 1.5, 1e-4);
}

std::map<std::string, HedrStatus> statusesOf(const Receiver& receiver) {
    std::map<std::string, HedrStatus> statuses;
    for (const NamedStatus& named : receiver.statuses()) statuses[named.name] = named.status;
    return statuses;
}

TEST(Receiver, TellsOfEachTrackThatChecksItsHeadingHowItIsChecked) {
    Receiver receiver({});
    EXPECT_TRUE(receiver.statuses().empty());
    hear(receiver, spoken(straightDrive(60.0)), 64);
    auto statuses = statusesOf(receiver);
    ASSERT_EQ(statuses.size(), 3u);
    for (const char* name : {"hedr", "hedr_bayes", "robot"}) {
        EXPECT_EQ(statuses.at(name).state, HedrState::kActive) << name;
        EXPECT_LT(statuses.at(name).seconds_since_active, 0.1) << name;
        EXPECT_FALSE(statuses.at(name).lost) << name;
    }
}

TEST(Receiver, CountsForEachTrackForHowLongNothingHasCheckedIt) {
    auto reports = straightDrive(60.0);
    const auto last = reports.back();
    for (int i = 1; i <= 1000; ++i) {  // then it stands 20 s
        reports.push_back(last);
        reports.back().robot_time_s += 0.02 * i;
    }
    Receiver receiver({});
    hear(receiver, spoken(reports), 64);
    for (const auto& [name, status] : statusesOf(receiver)) {
        EXPECT_EQ(status.state, HedrState::kSuspended) << name;
        EXPECT_EQ(status.reason, SuspendReason::kStanding) << name;
        EXPECT_NEAR(status.seconds_since_active, 20.0, 1.5) << name;
    }
}

TEST(Receiver, AFrameCutByAPulledCableIsNotJoinedToWhatComesLater) {
    const auto bytes = spoken(straightDrive(5.0));
    Receiver receiver({});
    receiver.portOpened();
    receiver.feed(std::span(bytes).first(1000));
    receiver.portOpened();
    receiver.feed(std::span(bytes).subspan(1000));
    EXPECT_EQ(receiver.health().reconnects, 1u);
    EXPECT_LE(receiver.health().bad_frames, 1u);
    EXPECT_EQ(receiver.health().bytes, bytes.size());
}

}  // namespace
}  // namespace hedr
