// The robot's signing against the laptop's: each verifies what the other one signs.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>

#include "radio/wire/frame_encoder.h"
#include "tests/radio/wire/firmware_frames.h"
#include "tests/radio/wire/signing/signing_fixture.h"

namespace hedr {
namespace {

using Bytes = std::vector<std::uint8_t>;
using test::FirmwareSigner;
using test::kAtlasKey;

Bytes bytesOf(const FrameBytes& frame) { return {frame.view().begin(), frame.view().end()}; }

Bytes signedRequest(FrameSigner& signer, const Request& request) {
    return bytesOf(signer.sign(encodeRequest(request, 5)).value());
}

RC_GTEST_PROP(FirmwareSigning, WritesTheSameBytesAsTheLaptop, ()) {
    const Report report = test::anyReport();
    const auto sequence = test::anyInteger<std::uint16_t>();
    const auto said = *rc::gen::inRange<std::uint32_t>(0, 4'000'000'000U);
    FrameSigner laptop(kAtlasKey, said);
    const Bytes signed_by_robot =
        FirmwareSigner(kAtlasKey, said).sign(test::FirmwareEncoder(sequence).encode(report));
    RC_ASSERT(signed_by_robot ==
              bytesOf(laptop.sign(encodeReport(report, sequence).value()).value()));
    RC_ASSERT(signed_by_robot.size() <= HEDR_SIGNED_FRAME_MAX);
}

RC_GTEST_PROP(FirmwareSigning, HeedsEverySignedRequest, ()) {
    const Request request = test::anyRequest();
    FrameSigner laptop(kAtlasKey, test::anyInteger<std::uint32_t>() / 2);
    const auto heard = FirmwareSigner(kAtlasKey, 0).hear(signedRequest(laptop, request));
    RC_ASSERT(heard.size() == 1U);
    RC_ASSERT(heard[0].sequence == 5);
    RC_ASSERT(test::asRequest(heard[0]) == request);
}

TEST(FirmwareSigning, HeedsNoUnsignedRequestAndNoneOfAnotherKey) {
    FirmwareSigner robot(kAtlasKey, 0);
    FrameSigner stranger(test::kBorisKey, 0);
    EXPECT_TRUE(robot.hear(bytesOf(encodeRequest(ParameterGet{3}, 1))).empty());
    EXPECT_TRUE(robot.hear(signedRequest(stranger, ParameterGet{3})).empty());
}

TEST(FirmwareSigning, HeedsNoRequestTwiceAndNoOlderOne) {
    FirmwareSigner robot(kAtlasKey, 0);
    FrameSigner laptop(kAtlasKey, 0);
    const Bytes first = signedRequest(laptop, TimeRequest{1});
    const Bytes second = signedRequest(laptop, TimeRequest{2});
    EXPECT_EQ(robot.hear(second).size(), 1U);
    EXPECT_TRUE(robot.hear(second).empty());
    EXPECT_TRUE(robot.hear(first).empty());
}

TEST(FirmwareSigning, DoesNoCommandAgainAfterARestart) {
    FirmwareSigner robot(kAtlasKey, 0);
    FrameSigner laptop(kAtlasKey, 0);
    const Bytes command = signedRequest(laptop, RobotCommand{CommandKind::kHedrOff, {}});
    const Bytes set = signedRequest(laptop, ParameterSet{1, 150000});
    EXPECT_EQ(robot.hear(command).size(), 1U);
    EXPECT_EQ(robot.hear(set).size(), 1U);
    robot.restart();
    EXPECT_TRUE(robot.hear(command).empty());
    EXPECT_TRUE(robot.hear(set).empty());
    EXPECT_EQ(robot.hear(signedRequest(laptop, ParameterGet{1})).size(), 1U);
}

TEST(FirmwareSigning, HeedsNothingOfTheRobotsThatComesBack) {
    FirmwareSigner robot(kAtlasKey, 0);
    EXPECT_TRUE(robot.hear(robot.sign(test::FirmwareEncoder(1).encode(TimeEchoReport{}))).empty());
}

TEST(FirmwareSigning, GrowsItsCounterOverRestarts) {
    FirmwareSigner robot(kAtlasKey, 0);
    FrameVerifier laptop({test::atlas()});
    for (int restart = 0; restart < 5; ++restart) {
        for (int i = 0; i < 10; ++i) {
            const Bytes bytes = robot.sign(test::FirmwareEncoder(1).encode(StatusReport{}));
            ASSERT_FALSE(laptop.judge(test::framesIn(bytes).at(0).frame()).rejected);
        }
        robot.restart();
    }
    EXPECT_EQ(FirmwareSigner::eeprom.reserved, 5 * HEDR_COUNTER_BLOCK);
}

TEST(FirmwareSigning, ReservesBeforeItSays) {
    FirmwareSigner robot(kAtlasKey, 0);
    const Bytes plain = test::FirmwareEncoder(1).encode(TimeEchoReport{});
    FirmwareSigner::writes = 0;
    for (std::uint32_t i = 0; i <= HEDR_COUNTER_BLOCK; ++i) robot.sign(plain);
    EXPECT_EQ(FirmwareSigner::writes, 2);
    EXPECT_EQ(FirmwareSigner::eeprom.reserved, 2 * HEDR_COUNTER_BLOCK);
}

TEST(FirmwareSigning, BeginsWithANewEepromAndEndsWithTheCounters) {
    FirmwareSigner robot(kAtlasKey, UINT32_MAX, UINT32_MAX);
    const Bytes plain = test::FirmwareEncoder(1).encode(TimeEchoReport{});
    EXPECT_EQ(counterOf(test::framesIn(robot.sign(plain)).at(0).frame()), 1U);
    FirmwareSigner last(kAtlasKey, UINT32_MAX - HEDR_COUNTER_BLOCK);
    EXPECT_TRUE(last.sign(plain).empty());
}

TEST(FirmwareSigning, HeedsNoForgedOrDamagedRequest) {
    std::mt19937_64 random(1);
    FirmwareSigner robot(kAtlasKey, 0);
    FrameSigner laptop(kAtlasKey, 0);
    const auto good = test::framesIn(signedRequest(laptop, ParameterSet{1, 150000})).at(0);
    for (int i = 0; i < 100'000; ++i) {
        auto forged = good;
        if (i < 8 * 17) {
            forged.payload[static_cast<std::size_t>(i / 8)] ^=
                static_cast<std::uint8_t>(1U << i % 8);
        } else {
            for (std::size_t at = 9; at < 17; ++at) {
                forged.payload[at] = static_cast<std::uint8_t>(random());
            }
        }
        ASSERT_TRUE(robot.hear(encodeFrame(forged.frame()).view()).empty()) << i;
    }
}

}  // namespace
}  // namespace hedr
