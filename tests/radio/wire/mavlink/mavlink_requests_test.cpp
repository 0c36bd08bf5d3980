#include "radio/wire/mavlink/mavlink_requests.h"

#include <gtest/gtest.h>

#include <bit>
#include <set>

#include "radio/wire/mavlink/mavlink_decoder.h"
#include "radio/wire/mavlink/mavlink_text.h"

namespace hedr {
namespace {

constexpr MavlinkAddress kVehicle{7, 1};
constexpr auto kBits = MavlinkParameterCoding::kBits;
constexpr auto kValue = MavlinkParameterCoding::kValue;

template <class Message>
Message read(const MavlinkBytes& bytes) {
    Message message;
    int frames = 0;
    MavlinkDecoder decoder;
    decoder.feed(bytes.view(), [&](const MavlinkFrame& frame) {
        EXPECT_EQ(frame.version, 2);
        EXPECT_EQ(frame.message_id, Message::kId);
        EXPECT_EQ(frame.sequence, 42);
        EXPECT_EQ(frame.system, 255);
        EXPECT_EQ(frame.component, 190);
        message = readMavlink<Message>(frame.payload);
        ++frames;
    });
    EXPECT_EQ(frames, 1);
    EXPECT_EQ(message.target_system, 7);
    EXPECT_EQ(message.target_component, 1);
    return message;
}

template <class Message>
Message sent(const Request& request, MavlinkParameterCoding coding = kBits) {
    return read<Message>(encodeMavlinkRequest(request, 42, kVehicle, coding).value());
}

TEST(MavlinkRequests, AskForAParameterByName) {
    const auto m = sent<MavlinkParamRequestRead>(ParameterGet{3});
    EXPECT_EQ(mavlinkText(m.param_id), "HEDR_BASE_UM");
    EXPECT_EQ(m.param_index, -1);
}

TEST(MavlinkRequests, SetAParameterBitByBit) {
    for (const std::int32_t value : {0, 1, -1, 400'000, 0x7FFFFFFF, -0x7FFFFFFF, 0x7FA00001}) {
        const auto m = sent<MavlinkParamSet>(ParameterSet{4, value});
        EXPECT_EQ(mavlinkText(m.param_id), "HEDR_TICKS_MILLI");  // 16 characters, no zero
        EXPECT_EQ(m.param_type, 6);
        EXPECT_EQ(std::bit_cast<std::int32_t>(m.param_value), value);
    }
}

TEST(MavlinkRequests, SetAParameterOfArduPilotByItsValue) {
    const auto m = sent<MavlinkParamSet>(ParameterSet{3, -400'000}, kValue);
    EXPECT_EQ(m.param_type, 9);
    EXPECT_EQ(m.param_value, -400'000.0F);
}

TEST(MavlinkRequests, AskForAMessageSoOften) {
    const auto m = read<MavlinkCommandLong>(encodeMessageInterval(9000, 0.05, 42, kVehicle));
    EXPECT_EQ(m.command, 511);
    EXPECT_EQ(m.param, (std::array<float, 7>{9000.0F, 50'000.0F}));
}

TEST(MavlinkRequests, SendCommandsInTheAxesOfMavlink) {
    const auto m =
        sent<MavlinkCommandLong>(RobotCommand{CommandKind::kResetPose, {{3.0, -2.0}, 0.5}});
    EXPECT_EQ(m.command, 31011);
    EXPECT_EQ(m.param, (std::array<float, 7>{3.0F, 2.0F, -0.5F}));
    const auto on = sent<MavlinkCommandLong>(RobotCommand{CommandKind::kHedrOn, {{3.0, 2.0}, 1.0}});
    EXPECT_EQ(on.command, 31012);
    EXPECT_EQ(on.param, (std::array<float, 7>{}));
}

TEST(MavlinkRequests, SendATokenToComeBack) {
    const auto m = sent<MavlinkTimesync>(TimeRequest{0xDEADBEEF});
    EXPECT_EQ(m.tc1, 0);
    EXPECT_EQ(m.ts1, 0xDEADBEEFLL);
}

TEST(MavlinkRequests, RefuseWhatHasNoWord) {
    for (const int id : {0, 8, 255}) {
        const auto parameter = static_cast<std::uint8_t>(id);
        EXPECT_FALSE(encodeMavlinkRequest(ParameterGet{parameter}, 0, kVehicle, kBits));
        EXPECT_FALSE(encodeMavlinkRequest(ParameterSet{parameter, 1}, 0, kVehicle, kBits));
    }
    EXPECT_FALSE(encodeMavlinkRequest(RobotCommand{}, 0, kVehicle, kBits));
}

MavlinkParamValue valueOf(std::string_view name, float value, std::uint8_t type) {
    MavlinkParamValue m{.param_value = value, .param_type = type};
    std::ranges::copy(name, m.param_id.begin());
    return m;
}

TEST(MavlinkRequests, KnowEveryParameterByItsName) {
    std::set<std::string_view> names;
    for (std::uint8_t id = 1; id <= 7; ++id) {
        const std::string_view name = mavlinkParameterName(RobotParameter{id});
        EXPECT_TRUE(!name.empty() && name.size() <= 16) << name;
        names.insert(name);
        EXPECT_EQ(parameterOf(valueOf(name, std::bit_cast<float>(-123456), 6), kBits),
                  (ParameterReport{id, -123456}));
    }
    EXPECT_EQ(names.size(), 7U);
}

TEST(MavlinkRequests, ReadAParameterThatIsAFloat) {
    EXPECT_EQ(parameterOf(valueOf("HEDR_GAIN_URAD", -436.0F, 9), kBits),
              (ParameterReport{5, -436}));
    EXPECT_FALSE(parameterOf(valueOf("HEDR_GAIN_URAD", 3e9F, 9), kBits));
    EXPECT_FALSE(parameterOf(valueOf("HEDR_GAIN_URAD", std::nanf(""), 9), kBits));
    EXPECT_FALSE(parameterOf(valueOf("HEDR_GAIN_URAD", 1.0F, 4), kBits));  // of another type
    EXPECT_EQ(parameterOf(valueOf("HEDR_BASE_UM", 400'000.0F, 6), kValue),
              (ParameterReport{3, 400'000}))
        << "as ArduPilot sends its integers";
    EXPECT_FALSE(parameterOf(valueOf("SYSID_THISMAV", 1.0F, 9), kBits));
}

TEST(MavlinkRequests, TranslateTheResults) {
    const std::vector<std::pair<int, AcknowledgeResult>> results{
        {0, AcknowledgeResult::kDone},         {1, AcknowledgeResult::kNotWhileMoving},
        {2, AcknowledgeResult::kOutOfRange},   {3, AcknowledgeResult::kUnknownCommand},
        {4, AcknowledgeResult::kNotSupported}, {6, AcknowledgeResult::kNotSupported},
        {99, AcknowledgeResult::kNotSupported}};
    for (const auto& [mav, ours] : results) {
        const auto got =
            acknowledgeOf({.command = 31013, .result = static_cast<std::uint8_t>(mav)});
        EXPECT_EQ(got, (AcknowledgeReport{4, static_cast<std::uint8_t>(ours)})) << mav;
    }
    EXPECT_FALSE(acknowledgeOf({.command = 31013, .result = 5}));  // still at it
    EXPECT_FALSE(acknowledgeOf({.command = 31009}));
    EXPECT_FALSE(acknowledgeOf({.command = 31014}));
    EXPECT_FALSE(acknowledgeOf({.command = 31013, .target_system = 254}));
    EXPECT_TRUE(acknowledgeOf({.command = 31013, .target_system = 255}));
}

}  // namespace
}  // namespace hedr
