#include "radio/wire/signing/frame_verifier.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <iostream>
#include <random>

#include "tests/radio/wire/signing/signing_fixture.h"

namespace hedr {
namespace {

using test::atlas;
using test::boris;
using test::kAtlasKey;
using test::KeptFrame;
using test::plainFrame;
using test::signedFrame;

std::optional<RejectReason> reasonOf(FrameVerifier& verifier, const KeptFrame& frame) {
    return verifier.judge(frame.frame()).rejected;
}

RC_GTEST_PROP(FrameVerifier, GivesBackThePlainFrame, ()) {
    const Report report = test::anyReport();
    FrameSigner signer(kAtlasKey, 0);
    FrameVerifier verifier({boris(), atlas()});
    const KeptFrame frame = signedFrame(signer, report);
    const Judgement judgement = verifier.judge(frame.frame());
    RC_ASSERT(judgement.is_signed);
    RC_ASSERT(!judgement.rejected);
    RC_ASSERT(test::keep(judgement.frame) == plainFrame(report));
    RC_ASSERT(verifier.robot()->name == "atlas");
}

TEST(FrameVerifier, AcceptsUnsignedFramesWithoutAKeyAndNoSignedOnes) {
    FrameVerifier verifier;
    FrameSigner signer(kAtlasKey, 0);
    EXPECT_FALSE(reasonOf(verifier, plainFrame(test::helloOf("atlas"))));
    EXPECT_EQ(reasonOf(verifier, signedFrame(signer)), RejectReason::kNoKey);
    EXPECT_FALSE(reasonOf(verifier, plainFrame(StatusReport{})));
    EXPECT_EQ(verifier.counters(), (SigningCounters{.unsigned_frames = 2, .no_key = 1}));
    EXPECT_EQ(verifier.robot(), nullptr);
}

TEST(FrameVerifier, RefusesAnyBitThatWasChangedOnTheWay) {
    FrameSigner signer(kAtlasKey, 0);
    const KeptFrame good = signedFrame(signer, PoseReport{.robot_time_s = 3.5});
    const std::size_t bits = 8 * (kFrameHeaderBytes + good.payload.size());
    for (std::size_t bit = 0; bit < bits; ++bit) {
        KeptFrame bad = good;
        const auto flip = static_cast<std::uint8_t>(1U << bit % 8);
        if (bit < 8) {
            bad.id ^= flip;
        } else if (bit < 24) {
            bad.sequence = static_cast<std::uint16_t>(bad.sequence ^ 1U << (bit - 8));
        } else {
            bad.payload[bit / 8 - kFrameHeaderBytes] ^= flip;
        }
        FrameVerifier verifier({atlas()}, FrameVerifier::Policy::kSignedOnly);
        ASSERT_TRUE(reasonOf(verifier, bad)) << "bit " << bit;
        ASSERT_FALSE(reasonOf(verifier, good)) << "bit " << bit;
    }
}

TEST(FrameVerifier, RefusesAFrameOfAnotherKeyAndOneTooShortForATag) {
    FrameVerifier verifier({atlas()});
    FrameSigner stranger(test::kBorisKey, 0);
    EXPECT_EQ(reasonOf(verifier, signedFrame(stranger)), RejectReason::kBadTag);
    for (std::size_t size = 0; size < kSignatureBytes; ++size) {
        EXPECT_EQ(reasonOf(verifier, {0x42, 1, std::vector<std::uint8_t>(size)}),
                  RejectReason::kBadTag);
    }
    EXPECT_FALSE(verifier.demandsSigning()) << "a forger must not lock an unsigned link";
}

TEST(FrameVerifier, AcceptsAReorderedFrameOnceAndNoneFromBeyondTheWindow) {
    FrameSigner signer(kAtlasKey, 0);
    std::vector<KeptFrame> frames;
    for (int i = 0; i < 100; ++i) frames.push_back(signedFrame(signer));
    FrameVerifier verifier({atlas()});
    EXPECT_FALSE(reasonOf(verifier, frames[99]));
    EXPECT_EQ(reasonOf(verifier, frames[99]), RejectReason::kReplayed);
    EXPECT_FALSE(reasonOf(verifier, frames[36]));
    EXPECT_EQ(reasonOf(verifier, frames[36]), RejectReason::kReplayed);
    EXPECT_EQ(reasonOf(verifier, frames[35]), RejectReason::kReplayed);
    EXPECT_EQ(verifier.counters(), (SigningCounters{.signed_frames = 2, .replayed = 3}));
}

TEST(FrameVerifier, RefusesOurOwnRequestsThatComeBack) {
    FrameSigner ours(kAtlasKey, 900);
    FrameSigner robots(kAtlasKey, 0);
    FrameVerifier verifier({atlas()});
    const FrameBytes request = ours.sign(encodeRequest(TimeRequest{4}, 1)).value();
    EXPECT_EQ(reasonOf(verifier, test::framesIn(request.view()).at(0)), RejectReason::kReplayed);
    EXPECT_FALSE(reasonOf(verifier, signedFrame(robots))) << "their counters are no matter here";
}

TEST(FrameVerifier, DoesNotComeDownFromSigned) {
    FrameVerifier verifier({atlas(), boris()});
    FrameSigner signer(kAtlasKey, 0);
    FrameSigner other(test::kBorisKey, 0);
    EXPECT_FALSE(reasonOf(verifier, plainFrame(StatusReport{})));
    EXPECT_FALSE(reasonOf(verifier, signedFrame(signer)));
    EXPECT_EQ(reasonOf(verifier, plainFrame(StatusReport{})), RejectReason::kUnsigned);
    EXPECT_EQ(reasonOf(verifier, signedFrame(other)), RejectReason::kBadTag) << "another robot";
    EXPECT_FALSE(reasonOf(verifier, signedFrame(signer)));
}

TEST(FrameVerifier, RefusesEveryUnsignedFrameWhereThePolicySaysSo) {
    FrameVerifier verifier({}, FrameVerifier::Policy::kSignedOnly);
    EXPECT_EQ(reasonOf(verifier, plainFrame(StatusReport{})), RejectReason::kUnsigned);
}

TEST(FrameVerifier, RefusesAnUnsignedLinkInTheNameOfARobotThatHasAKey) {
    FrameVerifier verifier({atlas()});
    EXPECT_FALSE(reasonOf(verifier, plainFrame(test::helloOf("packbot"))));
    EXPECT_EQ(reasonOf(verifier, plainFrame(test::helloOf("atlas"))), RejectReason::kUnsigned);
    EXPECT_EQ(reasonOf(verifier, plainFrame(StatusReport{})), RejectReason::kUnsigned);
}

// However it ends, what was accepted once is not accepted by the next run.
TEST(FrameVerifier, AcceptsNothingTwiceAfterACrashIfItsLimitWasKept) {
    FrameSigner signer(kAtlasKey, 0);
    FrameVerifier first({atlas()});
    std::vector<KeptFrame> frames;
    std::uint32_t kept = 0;
    int writes = 0;
    for (std::uint32_t i = 0; i < 1000; ++i) {
        frames.push_back(signedFrame(signer));
        ASSERT_FALSE(reasonOf(first, frames.back()));
        if (const auto limit = first.takeHeardLimit()) {
            kept = *limit;
            ++writes;
        }
        ASSERT_GE(kept, first.heard());
    }
    EXPECT_EQ(writes, 4) << "every 256 frames";
    FrameVerifier second({atlas(kept)});
    for (const KeptFrame& frame : frames) {
        ASSERT_EQ(reasonOf(second, frame), RejectReason::kReplayed);
    }
    EXPECT_EQ(second.robot(), nullptr) << "a recording must not choose the robot";
    FrameVerifier after_close({atlas(first.heard())});
    EXPECT_FALSE(reasonOf(after_close, signedFrame(signer))) << "a proper end costs no frame";
}

// Frames as a forger makes them: right in everything but the tag, and pure noise.
int acceptedForgeries(int forgeries, unsigned seed) {
    std::mt19937_64 random(seed);
    FrameSigner signer(kAtlasKey, 0);
    FrameVerifier verifier({atlas()});
    EXPECT_FALSE(reasonOf(verifier, signedFrame(signer)));
    KeptFrame forged = signedFrame(signer, PoseReport{});
    int accepted = 0;
    for (int i = 0; i < forgeries; ++i) {
        const std::size_t first = i % 2 == 0 ? forged.payload.size() - 8 : 0;
        for (std::size_t at = first; at < forged.payload.size(); ++at) {
            forged.payload[at] = static_cast<std::uint8_t>(random());
        }
        forged.id = static_cast<std::uint8_t>(i % 4 < 2 ? 0x42 : random());
        forged.sequence = static_cast<std::uint16_t>(random());
        accepted += reasonOf(verifier, forged) ? 0 : 1;
    }
    std::cout << accepted << " of " << forgeries << " forgeries accepted\n";
    return accepted;
}

TEST(FrameVerifier, AcceptsNoneOfAMillionForgeries) {
    EXPECT_EQ(acceptedForgeries(1'000'000, 1), 0);
}

TEST(FrameVerifier, DISABLED_AcceptsNoneOfTenMillionForgeries) {
    EXPECT_EQ(acceptedForgeries(10'000'000, 2), 0);
}

// What a mission keeps of a link with everything in it gives the same frames without the key.
RC_GTEST_PROP(FrameVerifier, JudgesARecordingAsItWasJudged, ()) {
    FrameSigner signer(kAtlasKey, 0);
    FrameSigner stranger(test::kBorisKey, 0);
    FrameVerifier live({atlas()});
    std::vector<KeptFrame> line;
    std::vector<KeptFrame> accepted;
    std::vector<RejectedFrame> rejected;
    for (const int kind : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 4))) {
        if (kind == 0) line.push_back(plainFrame(StatusReport{}));
        if (kind == 1) line.push_back(signedFrame(signer));
        if (kind == 2) line.push_back(signedFrame(stranger));
        if (kind == 3 && !line.empty()) line.push_back(KeptFrame(line[line.size() / 2]));
    }
    for (const KeptFrame& frame : line) {
        const Judgement judgement = live.judge(frame.frame());
        if (judgement.rejected) {
            rejected.push_back({judgement.index, *judgement.rejected});
        } else {
            accepted.push_back(test::keep(judgement.frame));
        }
    }
    FrameVerifier again = FrameVerifier::recomputing(rejected);
    std::vector<KeptFrame> accepted_again;
    for (const KeptFrame& frame : line) {
        const Judgement judgement = again.judge(frame.frame());
        if (!judgement.rejected) accepted_again.push_back(test::keep(judgement.frame));
    }
    RC_ASSERT(accepted_again == accepted);
    RC_ASSERT(again.counters() == live.counters());
}

TEST(FrameVerifier, OutlivesAListThatIsNotTheMissions) {
    FrameVerifier verifier = FrameVerifier::recomputing({{7, RejectReason::kUnsigned}});
    EXPECT_EQ(reasonOf(verifier, {0x42, 1, {1, 2, 3}}), RejectReason::kBadTag);
}

}  // namespace
}  // namespace hedr
