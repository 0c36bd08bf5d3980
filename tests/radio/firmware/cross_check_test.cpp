// The C header and the C++ codec are written apart: each reads what the other one writes.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "tests/radio/wire/arbitrary_messages.h"
#include "tests/radio/wire/firmware_frames.h"

namespace hedr {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes lineOf(const Request& request, std::uint16_t sequence) {
    const FrameBytes bytes = encodeRequest(request, sequence);
    return {bytes.view().begin(), bytes.view().end()};
}

RC_GTEST_PROP(FirmwareEncoder, WritesTheSameBytesAsTheCodec, ()) {
    const Report report = test::anyReport();
    const auto sequence = test::anyInteger<std::uint16_t>();
    const FrameBytes expected = encodeReport(report, sequence).value();
    const Bytes bytes = test::FirmwareEncoder(sequence).encode(report);
    RC_ASSERT(std::ranges::equal(bytes, expected.view()));
}

TEST(FirmwareEncoder, FillsItsLongestFrameWithTheLongestHello) {
    HelloReport hello;
    hello.vehicle = std::string(70, 'v');
    hello.firmware = std::string(62, 'f') + "\xC3\xA4";
    const Bytes bytes = test::FirmwareEncoder(1).encode(hello);
    EXPECT_TRUE(std::ranges::equal(bytes, encodeReport(hello, 1).value().view()));
    EXPECT_EQ(bytes.size(), HEDR_FRAME_MAX - 1U);
}

RC_GTEST_PROP(FirmwareDecoder, ReadsEveryRequest, ()) {
    const Request request = test::anyRequest();
    const auto sequence = test::anyInteger<std::uint16_t>();
    const auto got = test::firmwareRequests(lineOf(request, sequence));
    RC_ASSERT(got.size() == 1U);
    RC_ASSERT(got[0].sequence == sequence);
    RC_ASSERT(test::asRequest(got[0]) == request);
}

RC_GTEST_PROP(FirmwareDecoder, FindsARequestAfterNoise, (Bytes noise)) {
    const Bytes line = lineOf(TimeRequest{17}, 3);
    noise.insert(noise.end(), line.begin(), line.end());
    const auto got = test::firmwareRequests(noise);
    RC_ASSERT(got.size() == 1U);
    RC_ASSERT(got[0].token == 17U);
}

TEST(FirmwareDecoder, NeverObeysACorruptedRequest) {
    const Bytes good = lineOf(RobotCommand{CommandKind::kResetPose, {{1.5, -2.0}, 1.0}}, 9);
    for (std::size_t at = 1; at < good.size(); ++at) {
        for (unsigned change = 1; change < 256; ++change) {
            Bytes bad = good;
            bad[at] = static_cast<std::uint8_t>(bad[at] ^ change);
            ASSERT_TRUE(test::firmwareRequests(bad).empty()) << "byte " << at << " ^ " << change;
        }
    }
}

TEST(FirmwareDecoder, OutlivesAnEndlessRun) {
    Bytes bytes(100000, 0x33);
    const Bytes line = lineOf(ParameterGet{5}, 1);
    bytes.insert(bytes.end(), line.begin(), line.end());
    const auto got = test::firmwareRequests(bytes);
    ASSERT_EQ(got.size(), 1U);
    EXPECT_EQ(got[0].number, 5);
}

TEST(FirmwareDecoder, SkipsReportsAndShortRequests) {
    EXPECT_TRUE(test::firmwareRequests(encodeReport(TimeEchoReport{}, 1).value().view()).empty());
}

TEST(FirmwareHeader, NumbersThingsAsTheLaptopDoes) {
    EXPECT_EQ(HEDR_HAS_GYRO, kCapabilityGyro);
    EXPECT_EQ(HEDR_HAS_MAGNETOMETER, kCapabilityMagnetometer);
    EXPECT_EQ(HEDR_HAS_TEMPERATURE, kCapabilityTemperature);
    EXPECT_EQ(HEDR_HAS_HEDR, kCapabilityHedr);
    EXPECT_EQ(HEDR_DEMANDS_SIGNED, kCapabilityDemandsSigned);
    EXPECT_EQ(HEDR_NOT_SUPPORTED, static_cast<int>(AcknowledgeResult::kNotSupported));
    EXPECT_EQ(HEDR_COMMAND_HEDR_OFF, static_cast<int>(CommandKind::kHedrOff));
    EXPECT_EQ(HEDR_SUSPENDED, static_cast<int>(HedrState::kSuspended));
    EXPECT_EQ(HEDR_WHY_TURNING, static_cast<int>(SuspendReason::kTurning));
}

}  // namespace
}  // namespace hedr
