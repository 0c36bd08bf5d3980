#include "radio/wire/codec.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "radio/wire/frame_decoder.h"
#include "radio/wire/frame_encoder.h"
#include "radio/wire/signing/signed_frame.h"
#include "tests/radio/wire/arbitrary_messages.h"

namespace hedr {
namespace {

using test::KeptFrame;

std::vector<KeptFrame> framesIn(std::span<const std::uint8_t> bytes) {
    std::vector<KeptFrame> frames;
    FrameDecoder decoder;
    decoder.feed(bytes, [&](const Frame& frame) { frames.push_back(test::keep(frame)); });
    return frames;
}

KeptFrame sent(const Report& report, std::uint16_t sequence = 0) {
    const auto bytes = encodeReport(report, sequence);
    return bytes ? framesIn(bytes->view()).at(0) : KeptFrame{};
}

template <class Message>
Message received(const Message& message) {
    return std::get<Message>(decodeReport(sent(message).frame()).value());
}

RC_GTEST_PROP(Codec, GivesBackEveryReport, ()) {
    const Report report = test::anyReport();
    const auto sequence = test::anyInteger<std::uint16_t>();
    const KeptFrame frame = sent(report, sequence);
    RC_ASSERT(frame.sequence == sequence);
    const auto decoded = decodeReport(frame.frame());
    RC_ASSERT(decoded.has_value());
    RC_ASSERT(*decoded == report);
}

RC_GTEST_PROP(Codec, GivesBackEveryRequest, ()) {
    const Request request = test::anyRequest();
    const auto frames = framesIn(encodeRequest(request, 7).view());
    RC_ASSERT(frames.size() == 1U);
    const auto decoded = decodeRequest(frames[0].frame());
    RC_ASSERT(decoded.has_value());
    RC_ASSERT(*decoded == request);
}

RC_GTEST_PROP(Codec, ReadsALongerPayloadOfANewerRobot, ()) {
    const Report report = test::anyReport();
    const auto* sensors = std::get_if<SensorReport>(&report);
    // The magnetometer is sensors' own growth: nothing else may follow without it.
    const bool may_grow = sensors == nullptr || sensors->magnetic_field.has_value();
    RC_PRE(may_grow);
    KeptFrame frame = sent(report);
    frame.payload.insert(frame.payload.end(), {1, 2, 3, 4, 5, 6, 7});
    RC_ASSERT(decodeReport(frame.frame()).value() == report);
}

RC_GTEST_PROP(Codec, RefusesAReportThatIsCutAnywhere, ()) {
    const Report report = test::anyReport();
    KeptFrame frame = sent(report);
    const auto* sensors = std::get_if<SensorReport>(&report);
    const std::size_t needed = sensors != nullptr ? 18 : frame.payload.size();
    for (std::size_t size = 0; size < needed; ++size) {
        frame.payload.resize(size);
        RC_ASSERT(decodeReport(frame.frame()) == tl::make_unexpected(DecodeFailure::kTooShort));
        frame = sent(report);
    }
}

TEST(Codec, ToldApartFromDamageSkipsAnUnknownId) {
    const Frame frame{.id = 0x3F, .sequence = 1, .payload = {}};
    EXPECT_EQ(decodeReport(frame).error(), DecodeFailure::kUnknownId);
    EXPECT_EQ(decodeRequest(frame).error(), DecodeFailure::kUnknownId);
}

TEST(Codec, TakesAReportForNoRequest) {
    EXPECT_EQ(decodeRequest(sent(StatusReport{}).frame()).error(), DecodeFailure::kUnknownId);
}

TEST(Codec, ReadsANewerEnumerationAsItsZero) {
    KeptFrame frame = sent(PoseReport{});
    frame.payload[20] = 0x7F;  // state 3, reason 7
    const auto pose = std::get<PoseReport>(decodeReport(frame.frame()).value());
    EXPECT_EQ(pose.hedr, HedrState::kOff);
    EXPECT_EQ(pose.reason, SuspendReason::kNone);
    EXPECT_TRUE(pose.standing);
    EXPECT_TRUE(pose.calibrated);
}

TEST(Codec, WrapsTheRobotsTimeAndCounts) {
    SensorReport m;
    m.robot_time_s = kRobotClockPeriod_s + 1.5;
    m.odometry = WheelTicks{(std::int64_t{1} << 32) + 5, -7};
    const SensorReport got = received(m);
    EXPECT_DOUBLE_EQ(got.robot_time_s, 1.5);
    EXPECT_EQ(got.odometry, Odometry(WheelTicks{5, -7}));
}

TEST(Codec, KeepsFullTurnsToAThousandthOfADegree) {
    PoseReport m;
    m.pose.heading_rad = radFromDeg(360.0 * 1000 + 12.3456);
    EXPECT_NEAR(degFromRad(received(m).pose.heading_rad), 360.0 * 1000 + 12.3456, 0.0005);
}

TEST(Codec, SaturatesWhatDoesNotFit) {
    StatusReport status;
    status.battery_v = 1000.0;
    status.radio_dbm = -500;
    EXPECT_DOUBLE_EQ(received(status).battery_v, 65.535);
    EXPECT_EQ(received(status).radio_dbm, -127);
    PoseReport pose;
    pose.pose.position = {1e12, -std::numeric_limits<double>::infinity()};
    pose.pose.heading_rad = std::nan("");
    pose.drift_rad_s = -9.0;
    const PoseReport got = received(pose);
    EXPECT_NEAR(got.pose.position.x, 2147483.647, 1e-6);
    EXPECT_NEAR(got.pose.position.y, -2147483.648, 1e-6);
    EXPECT_EQ(got.pose.heading_rad, 0.0);
    EXPECT_NEAR(got.drift_rad_s, -0.32768, 1e-9);
}

TEST(Codec, CutsALongTextBetweenTwoCharacters) {
    EventReport m;
    m.text = std::string(119, 'x') + "\xC3\xA4";  // 121 bytes, the last character has two
    EXPECT_EQ(received(m).text, std::string(119, 'x'));
}

TEST(Codec, HasNoPlaceForSensorsWithoutCounts) {
    EXPECT_FALSE(encodeReport(SensorReport{}, 0).has_value());
    SensorReport rate;
    rate.odometry = WheelTicks{};
    EXPECT_TRUE(encodeReport(rate, 0).has_value());
    rate.gyro = GyroRate{0.1};
    EXPECT_FALSE(encodeReport(rate, 0).has_value());
}

TEST(Codec, StepsOverTheAngleThatMeansNoGyro) {
    SensorReport m;
    m.odometry = WheelTicks{};
    m.gyro = GyroAngle{0x80000000U};
    EXPECT_EQ(received(m).gyro, Gyro(GyroAngle{0x80000001U}));
    m.gyro = std::monostate{};
    EXPECT_EQ(received(m).gyro, Gyro());
}

// DESIGN: pose at 20 Hz and sensors at 100 Hz leave at least 40 % of 57,600 baud (8N1) free.
TEST(Budget, LeavesFortyPercentOfTheLineFree) {
    SensorReport sensors;
    sensors.odometry = WheelTicks{};
    HelloReport hello;
    hello.vehicle = "packbot-payload-7";
    hello.firmware = "hedr 1.0.0";
    const auto size = [](const Report& report) {
        return static_cast<double>(encodeReport(report, 1).value().size);
    };
    const double bytes_per_s =
        20 * size(PoseReport{}) + 100 * size(sensors) + size(hello) + size(StatusReport{});
    EXPECT_EQ(size(PoseReport{}), 31);  // as radio/README.md says
    EXPECT_EQ(size(sensors), 27);
    EXPECT_LE(bytes_per_s, 0.6 * 5760);
    // Signed, as radio/README.md says: 15 %, and 57 % of 115,200 baud.
    const double signed_bytes_per_s = bytes_per_s + 122.0 * static_cast<double>(kSignatureBytes);
    EXPECT_LE(signed_bytes_per_s, 0.85 * 5760);
    EXPECT_LE(signed_bytes_per_s, 0.43 * 11520);
}

}  // namespace
}  // namespace hedr
