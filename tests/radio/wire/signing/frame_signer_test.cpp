#include "radio/wire/signing/frame_signer.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "radio/wire/frame_encoder.h"
#include "tests/radio/wire/signing/signing_fixture.h"

namespace hedr {
namespace {

using test::framesIn;

RC_GTEST_PROP(FrameSigner, AddsTwelveBytesThatComeOffAgain, ()) {
    const Report report = test::anyReport();
    const FrameBytes plain = encodeReport(report, test::anyInteger<std::uint16_t>()).value();
    FrameSigner signer(test::kAtlasKey, 41);
    const FrameBytes result = signer.sign(plain).value();
    RC_ASSERT(result.size == plain.size + 12);
    const auto kept = framesIn(result.view()).at(0);
    RC_ASSERT(isSigned(kept.frame()));
    RC_ASSERT(counterOf(kept.frame()) == 42U);
    RC_ASSERT(test::keep(withoutSignature(kept.frame())) == framesIn(plain.view()).at(0));
}

TEST(FrameSigner, KeepsTheZeroInFrontOfRequests) {
    FrameSigner signer(test::kAtlasKey, 0);
    const FrameBytes result = signer.sign(encodeRequest(ParameterGet{3}, 7)).value();
    EXPECT_EQ(result.bytes[0], 0);
    EXPECT_EQ(framesIn(result.view()).at(0).id, 0xC1);
    EXPECT_NE(signer.sign(encodeReport(StatusReport{}, 7).value()).value().bytes[0], 0);
}

TEST(FrameSigner, SignsTheLongestHelloAndRefusesWhatHasNoRoom) {
    FrameSigner signer(test::kAtlasKey, 0);
    HelloReport longest = test::helloOf(std::string(63, 'v'));
    longest.firmware = std::string(63, 'f');
    EXPECT_TRUE(signer.sign(encodeReport(longest, 1).value()));
    const std::vector<std::uint8_t> payload(kMaxSignedPayloadBytes + 1);
    const auto fits = std::span(payload).first(kMaxSignedPayloadBytes);
    EXPECT_TRUE(signer.sign(encodeFrame({.id = 0x30, .sequence = 1, .payload = fits})));
    EXPECT_FALSE(signer.sign(encodeFrame({.id = 0x30, .sequence = 1, .payload = payload})));
}

TEST(FrameSigner, ReservesCountersBeforeItUsesThem) {
    FrameSigner signer(test::kAtlasKey, 100);
    EXPECT_FALSE(signer.takeReserved());
    std::uint32_t reserved = 100;
    for (std::uint32_t i = 0; i < 2 * FrameSigner::kBlock + 1; ++i) {
        ASSERT_TRUE(signer.sign(encodeRequest(ParameterGet{3}, 7)));
        reserved = signer.takeReserved().value_or(reserved);
        ASSERT_GE(reserved, signer.said());
    }
    EXPECT_EQ(reserved, 100 + 3 * FrameSigner::kBlock);
}

TEST(FrameSigner, NeverUsesACounterTwiceButEnds) {
    FrameSigner signer(test::kAtlasKey, UINT32_MAX - FrameSigner::kBlock - 1);
    EXPECT_TRUE(signer.sign(encodeRequest(ParameterGet{3}, 7)));
    EXPECT_FALSE(signer.sign(encodeRequest(ParameterGet{3}, 7)));
    EXPECT_EQ(signer.said(), UINT32_MAX - FrameSigner::kBlock);
}

}  // namespace
}  // namespace hedr
