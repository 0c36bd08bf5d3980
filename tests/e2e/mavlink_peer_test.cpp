// A robot of other people's making: node-mavlink at the other end of a pseudo-terminal.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/geometry/angle.h"
#include "radio/wire/mavlink/mavlink_codec.h"
#include "radio/wire/mavlink/mavlink_decoder.h"
#include "radio/wire/mavlink/mavlink_reports.h"
#include "tests/e2e/mavlink_peer/link_to_peer.h"

namespace hedr {
namespace {

constexpr double kFloatError = 2e-6;  // of what is rounded to a float, up to 10

// Each field by its name.
class FieldList {
  public:
    template <class T>
    void operator()(const std::string& name, const T& value) {
        values.emplace_back(name, static_cast<double>(value));
    }
    template <class T, std::size_t N>
    void operator()(const std::string& name, const std::array<T, N>& all) {
        for (const T& value : all) (*this)(name, value);
    }
    void extensions() {}

    std::vector<std::pair<std::string, double>> values;
};

template <class Message>
void expectFields(const MavlinkFrame& frame, std::map<std::uint32_t, int>& seen) {
    if (frame.message_id != Message::kId) return;
    ++seen[Message::kId];
    const auto message = readMavlink<Message>(frame.payload);
    Message expected;
    expectedAt(momentOf(message), expected);
    FieldList came;
    FieldList wanted;
    mavlinkFields(came, message);
    mavlinkFields(wanted, expected);
    ASSERT_EQ(came.values.size(), wanted.values.size());
    for (std::size_t i = 0; i < came.values.size(); ++i) {
        EXPECT_NEAR(came.values[i].second, wanted.values[i].second, kFloatError)
            << findMavlinkMessage(Message::kId)->name << '.' << came.values[i].first;
    }
}

TEST_F(LinkToMavlinkPeer, BringsEveryFieldOfEveryMessage) {
    begin({"--say",
           "HIGHRES_IMU,SCALED_IMU,RAW_IMU,ATTITUDE,ODOMETRY,LOCAL_POSITION_NED,WHEEL_DISTANCE"});
    ASSERT_TRUE(waitFor([&] { return words_.size() >= 3 && last_.link.good_frames > 900; }));
    end();
    MavlinkDecoder decoder;
    std::map<std::uint32_t, int> seen;
    int signed_frames = 0;
    forEachBytes([&](const StreamRow& row) {
        decoder.feed(row.data, [&](const MavlinkFrame& frame) {
            signed_frames += frame.is_signed ? 1 : 0;
            expectFields<MavlinkHeartbeat>(frame, seen);
            expectFields<MavlinkSysStatus>(frame, seen);
            expectFields<MavlinkRadioStatus>(frame, seen);
            expectFields<MavlinkAttitude>(frame, seen);
            expectFields<MavlinkLocalPositionNed>(frame, seen);
            expectFields<MavlinkOdometry>(frame, seen);
            expectFields<MavlinkWheelDistance>(frame, seen);
            expectFields<MavlinkScaledImu>(frame, seen);
            expectFields<MavlinkRawImu>(frame, seen);
            expectFields<MavlinkHighresImu>(frame, seen);
        });
    });
    EXPECT_EQ(seen.size(), 10U);
    EXPECT_EQ(signed_frames, 1);
    const std::vector<std::string> said{"Warning: Wheel slips", std::string(50, 'x'), "Signed"};
    EXPECT_EQ(words_, said);
    EXPECT_EQ(last_.link.good_frames, decoder.counters().good_frames);
    EXPECT_EQ(last_.link.bad_frames, 0U);
    EXPECT_EQ(last_.link.lost_frames, 0U);
    EXPECT_EQ(last_.link.unknown_frames, 0U);
    EXPECT_EQ(last_.link.bytes, decoder.counters().bytes);
}

// What a robot says, and what is made of it.
struct Robot {
    const char* name;
    QStringList options;
    int version;
    bool wheels;
    std::optional<double> temperature_c;
    std::optional<MagneticField> field;  // gauss, forward left up
};

void PrintTo(const Robot& robot, std::ostream* out) { *out << robot.name; }

class MavlinkPeers : public LinkToMavlinkPeer, public ::testing::WithParamInterface<Robot> {
  protected:
    void expectSensors(const SensorReport& report) {
        const double s = report.robot_time_s - kPeerStart_s;
        EXPECT_NEAR(std::get<GyroRate>(report.gyro).rad_s, -kPeerRate_rad_s, 1e-8);
        EXPECT_EQ(report.temperature_c, GetParam().temperature_c);
        ASSERT_EQ(report.magnetic_field.has_value(), GetParam().field.has_value());
        if (report.magnetic_field) {
            EXPECT_NEAR(report.magnetic_field->x, GetParam().field->x, 1e-12);
            EXPECT_NEAR(report.magnetic_field->y, GetParam().field->y, 1e-12);
            EXPECT_NEAR(report.magnetic_field->z, GetParam().field->z, 1e-12);
        }
        if (const auto* travel = std::get_if<WheelTravel>(&report.odometry)) {
            ++odometries_;
            EXPECT_TRUE(GetParam().wheels);
            // The tick has what came last, 20 ms ago or at its own time.
            EXPECT_NEAR(travel->left_m, peerLeft_m(s), 0.0211);
            EXPECT_NEAR(travel->left_m / travel->right_m, peerLeft_m(1.0) / peerRight_m(1.0), 1e-9);
        }
        if (const auto* pose = std::get_if<OdometryPose>(&report.odometry)) {
            ++odometries_;
            EXPECT_FALSE(GetParam().wheels);
            EXPECT_NEAR(std::hypot(pose->x_m, pose->y_m + kPeerRadius_m), kPeerRadius_m, 1e-5);
            EXPECT_NEAR(pose->heading_rad, -peerYaw_rad(s), 0.0041);
        }
    }
    void expectPose(const PoseReport& report) {
        ++poses_;
        const double s = report.robot_time_s - kPeerStart_s;
        EXPECT_NEAR(report.pose.position.x, peerNorth_m(s), kFloatError);
        EXPECT_NEAR(report.pose.position.y, -peerEast_m(s), kFloatError);
        EXPECT_NEAR(report.pose.heading_rad, -peerYaw_rad(s), kFloatError);
        EXPECT_NEAR(report.yaw_rate_rad_s, -kPeerRate_rad_s, 1e-8);
    }
    void expectStatus(const StatusReport& report) {
        EXPECT_DOUBLE_EQ(report.battery_v, 12.34);
        EXPECT_EQ(report.faults, (1U << 2) | (1U << 3));  // gyro, battery low; not the drive
        EXPECT_EQ(report.radio_dbm.value_or(-27), -27);
    }
    // Of the mission's bytes.
    void expectReports() {
        MavlinkDecoder decoder;
        MavlinkReports reports;
        forEachBytes([&](const StreamRow& row) {
            decoder.feed(row.data, [](const MavlinkFrame& frame) {
                EXPECT_EQ(frame.version, frame.is_signed ? 2 : GetParam().version);
            });
            reports.feed(row.data, [&](const Report& report) {
                if (const auto* some = std::get_if<SensorReport>(&report)) expectSensors(*some);
                if (const auto* some = std::get_if<PoseReport>(&report)) expectPose(*some);
                if (const auto* some = std::get_if<StatusReport>(&report)) expectStatus(*some);
            });
        });
        EXPECT_GE(poses_, 20);
        EXPECT_GE(odometries_, 20);
    }

    // A circle to the right: below the x axis, seen with y to the left, and clockwise.
    void expectCircle(const std::string& track) {
        EXPECT_GE(tracks_[track].size(), 20U) << track;
        for (const TrackPoint& point : tracks_[track]) {
            const auto [x, y] = point.pose.position;
            EXPECT_NEAR(std::hypot(x, y + kPeerRadius_m), kPeerRadius_m, 0.01) << track;
            const double along_rad = -std::atan2(x, y + kPeerRadius_m);
            EXPECT_NEAR(wrapAngle(point.pose.heading_rad - along_rad), 0.0, 0.01) << track;
        }
    }

    int poses_ = 0;
    int odometries_ = 0;
};

TEST_P(MavlinkPeers, AreFollowedInSiAndInTheRightAxes) {
    begin(GetParam().options);
    ASSERT_TRUE(waitFor([&] { return tracks_["hedr"].size() >= 25 && words_.size() >= 2; }));
    end();
    EXPECT_EQ(last_.language, RobotLanguage::kMavlink);
    EXPECT_EQ(last_.robot->vehicle, "MAVLink system 7");
    EXPECT_EQ(words_[0], "Warning: Wheel slips");
    ASSERT_TRUE(last_.status && last_.status->radio_dbm);
    expectStatus(*last_.status);
    EXPECT_EQ(last_.link.bad_frames + last_.link.lost_frames + last_.link.unknown_frames, 0U);

    expectReports();
    expectCircle("odometry");
    expectCircle(kRobotTrack);
    expectTheSameBitsAgain();
}

INSTANTIATE_TEST_SUITE_P(
    OfEveryKind, MavlinkPeers,
    ::testing::Values(Robot{"HighresImuAndOdometry",
                            {"--say", "HIGHRES_IMU,ODOMETRY"},
                            2,
                            false,
                            36.5,
                            MagneticField{0.25, -0.125, 0.5}},
                      Robot{"ScaledImuPositionAndWheels",
                            {"--say", "SCALED_IMU,ATTITUDE,LOCAL_POSITION_NED,WHEEL_DISTANCE"},
                            2,
                            true,
                            21.5,
                            MagneticField{0.21, -0.03, 0.43}},
                      Robot{"ArduPilotOfVersion1",
                            {"--v1", "--autopilot", "3", "--say",
                             "RAW_IMU,ATTITUDE,LOCAL_POSITION_NED"},
                            1,
                            false,
                            -3.5,
                            MagneticField{0.22, 0.04, -0.44}},
                      Robot{"AttitudeAndPositionAlone",
                            {"--say", "ATTITUDE,LOCAL_POSITION_NED"},
                            2,
                            false,
                            std::nullopt,
                            std::nullopt}),
    [](const auto& robot) { return robot.param.name; });

TEST_F(LinkToMavlinkPeer, WritesParametersAndReadsThemBack) {
    const auto id = [](RobotParameter which) { return static_cast<std::uint8_t>(which); };
    begin({"--say", "SCALED_IMU,ODOMETRY"});
    ASSERT_TRUE(waitFor([&] { return last_.robot.has_value(); }));
    link_->ask(1, ParameterSet{id(RobotParameter::kWheelbaseUm), 512345});
    link_->ask(2, ParameterSet{id(RobotParameter::kDominantOffset), -12345});
    link_->ask(3, ParameterSet{id(RobotParameter::kHedrGainUradS2), 250});  // as a float
    link_->ask(4, ParameterGet{id(RobotParameter::kWheelbaseUm)});
    link_->ask(5, ParameterSet{id(RobotParameter::kDominantDirections), 8});
    ASSERT_TRUE(waitFor([&] { return requests_.contains(5) && isOver(stateOf(5)); }));
    end();
    const std::map<std::uint64_t, int> values{{1, 512345}, {2, -12345}, {3, 250}, {4, 512345}};
    for (const auto& [ticket, value] : values) {
        EXPECT_EQ(stateOf(ticket), RequestState::kDone) << ticket;
        EXPECT_EQ(requests_[ticket].value, value) << ticket;
    }
    EXPECT_EQ(stateOf(5), RequestState::kDiffers) << "it keeps its 4 directions";
    EXPECT_EQ(requests_[5].value, 4);
    const auto events = MissionReader::open(mission()).value().events().value();
    EXPECT_EQ(std::ranges::count(events, kRequestEvent, &MissionEvent::kind), 5);
}

TEST_F(LinkToMavlinkPeer, WritesParametersOfArduPilotByTheirValue) {
    const auto base = static_cast<std::uint8_t>(RobotParameter::kWheelbaseUm);
    begin({"--autopilot", "3", "--say", "RAW_IMU,ATTITUDE,LOCAL_POSITION_NED"});
    ASSERT_TRUE(waitFor([&] { return last_.robot.has_value(); }));
    link_->ask(1, ParameterGet{base});
    ASSERT_TRUE(waitFor([&] { return requests_.contains(1) && isOver(stateOf(1)); }));
    EXPECT_EQ(requests_[1].value, 400000) << "an integer, says its type";
    link_->ask(2, ParameterSet{base, 512345});
    ASSERT_TRUE(waitFor([&] { return requests_.contains(2) && isOver(stateOf(2)); }));
    end();
    EXPECT_EQ(stateOf(2), RequestState::kDone);
    EXPECT_EQ(requests_[2].value, 512345);
}

TEST_F(LinkToMavlinkPeer, IsAskedForMoreWhereItSaysTooLittle) {
    begin({"--slow", "--autopilot", "3", "--say", "RAW_IMU,ATTITUDE,LOCAL_POSITION_NED"});
    ASSERT_TRUE(waitFor([&] { return tracks_["odometry"].size() >= 8; }));
    ASSERT_TRUE(waitFor([&] { return last_.frames_per_s > 100.0; })) << last_.frames_per_s;
    end();
    EXPECT_TRUE(last_.warnings.empty());
    expectTheSameBitsAgain();
}

TEST_F(LinkToMavlinkPeer, IsNotLiveByItsHeartbeatAlone) {
    begin({});
    ASSERT_TRUE(waitFor([&] { return last_.robot && last_.link.good_frames > 10; }));
    end();
    EXPECT_TRUE(last_.last_good);
    EXPECT_FALSE(last_.last_frame);
}

TEST_F(LinkToMavlinkPeer, IsObeyedAndSaysTheTime) {
    begin({"--say", "SCALED_IMU,ODOMETRY"});
    ASSERT_TRUE(waitFor([&] { return words_.size() >= 3; }));
    link_->ask(1, RobotCommand{CommandKind::kMeasureBias});
    link_->ask(2, RobotCommand{CommandKind::kResetPose, {{1.5, 2.5}, 0.75}});
    link_->ask(3, RobotCommand{CommandKind::kHedrOn});
    link_->ask(4, RobotCommand{CommandKind::kHedrOff});
    const auto measured = [&] { return !samples_.empty() && samples_.back().clock_offset_s; };
    ASSERT_TRUE(waitFor([&] {
        return measured() && words_.size() >= 4 && requests_.contains(4) && isOver(stateOf(3)) &&
               isOver(stateOf(4));
    }));
    end();
    EXPECT_EQ(stateOf(1), RequestState::kDone);
    EXPECT_EQ(stateOf(2), RequestState::kDone);
    EXPECT_EQ(words_.back(), "at 1.50 -2.50 yaw -0.75") << "north, east, clockwise";
    EXPECT_EQ(stateOf(3), RequestState::kRefused);
    EXPECT_EQ(requests_[3].reason, AcknowledgeResult::kNotWhileMoving);
    EXPECT_EQ(stateOf(4), RequestState::kRefused);
    EXPECT_EQ(requests_[4].reason, AcknowledgeResult::kUnknownCommand);

    // No stamp can be ahead of the robot's clock when it arrives, and few are long on their way.
    MavlinkReports reports;
    double ahead_s = -1e9;
    forEachBytes([&](const StreamRow& row) {
        reports.feed(row.data, [&](const Report& report) {
            const auto* pose = std::get_if<PoseReport>(&report);
            if (pose) ahead_s = std::max(ahead_s, pose->robot_time_s - row.receive_time_s);
        });
    });
    const LinkSample& sample = samples_.back();
    ASSERT_TRUE(sample.round_trip_s);
    EXPECT_GT(*sample.round_trip_s, 0.0);
    EXPECT_LT(*sample.round_trip_s, 0.5);
    EXPECT_GT(*sample.clock_offset_s, ahead_s - *sample.round_trip_s);
    EXPECT_LT(*sample.clock_offset_s, ahead_s + 0.1);
    EXPECT_EQ(sample.radio_dbm, -27);
}

}  // namespace
}  // namespace hedr
