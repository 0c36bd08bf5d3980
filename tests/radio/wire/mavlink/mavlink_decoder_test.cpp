#include "radio/wire/mavlink/mavlink_decoder.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>

#include "radio/wire/mavlink/mavlink_codec.h"
#include "tests/radio/wire/mavlink/golden_frames.h"
#include "tests/radio/wire/mavlink/received_frames.h"

namespace hedr {
namespace {

using test::append;
using test::attitude;
using test::Bytes;
using test::receive;
using test::Received;
using test::unknown;

Bytes allGolden() {
    Bytes stream;
    for (const test::GoldenMavlink& golden : test::goldenMavlink()) append(stream, golden.bytes);
    return stream;
}

TEST(MavlinkDecoder, FindsTheSameHoweverTheBytesAreCut) {
    Bytes stream{0xFE, 3, 0xFD, 0xFD, 9};
    append(stream, allGolden());
    append(stream, unknown(4));
    append(stream, attitude(5));
    const Received whole = receive(stream);
    EXPECT_EQ(whole.counters.good_frames, test::goldenMavlink().size() + 1);
    EXPECT_EQ(whole.counters.bytes, stream.size());
    for (std::size_t piece = 1; piece < 300; ++piece) EXPECT_EQ(receive(stream, piece), whole);
    for (std::size_t cut = 0; cut <= stream.size(); ++cut) {
        int frames = 0;
        MavlinkDecoder decoder;
        const auto count = [&](const MavlinkFrame&) { ++frames; };
        decoder.feed(std::span(stream).first(cut), count);
        decoder.feed(std::span(stream).subspan(cut), count);
        ASSERT_EQ(decoder.counters(), whole.counters) << cut;
        ASSERT_EQ(frames, static_cast<int>(whole.ids.size())) << cut;
    }
}

RC_GTEST_PROP(MavlinkDecoder, LosesNoGoodFrameInNoise, ()) {
    // Noise that looks like frames as often as it can.
    const auto byte = rc::gen::oneOf(rc::gen::arbitrary<std::uint8_t>(),
                                     rc::gen::element<std::uint8_t>(0xFD, 0xFE, 0, 1, 30, 255));
    Bytes stream;
    std::vector<std::uint32_t> sent;
    for (unsigned i = 0; i < 20; ++i) {
        append(stream, *rc::gen::container<Bytes>(byte));
        append(stream, attitude(i, *rc::gen::inRange(1, 3)));
        sent.push_back(i);
    }
    // The last candidates want to know what follows.
    stream.resize(stream.size() + 2 * kMaxMavlinkFrameBytes);
    const Received got = receive(stream);
    RC_ASSERT(got.times_ms == sent);
    RC_ASSERT(receive(stream, *rc::gen::inRange<std::size_t>(1, 400)) == got);
}

// What a parser that trusts lengths loses its frames by: a magic byte and the largest length.
TEST(MavlinkDecoder, FindsEveryFrameBehindEveryFalseHeader) {
    for (const Bytes& false_header :
         {Bytes{0xFD, 255, 0, 0, 0, 1, 1, 30, 0, 0}, Bytes{0xFD, 255, 1, 0, 0, 1, 1, 99, 0, 0},
          Bytes{0xFE, 28, 0, 1, 1, 30}, Bytes{0xFE, 255, 0, 1, 1, 200}, Bytes{0xFD}, Bytes{0xFE},
          Bytes{0xFD, 3, 0x82, 0, 0, 1, 1, 30, 0, 0}}) {
        for (std::size_t cut = 1; cut <= false_header.size(); ++cut) {
            Bytes stream;
            std::vector<std::uint32_t> sent;
            for (unsigned i = 0; i < 60; ++i) {
                append(stream, std::span(false_header).first(cut));
                append(stream, attitude(i));
                sent.push_back(i);
            }
            stream.resize(stream.size() + 2 * kMaxMavlinkFrameBytes);
            EXPECT_EQ(receive(stream).times_ms, sent) << false_header.size() << " " << cut;
        }
    }
}

// Seven bytes of noise in every fifty messages, by which the usual parsers lose some; then worse.
TEST(MavlinkDecoder, LosesNoFrameInALongNoisyStream) {
    std::mt19937 random(7);
    for (const unsigned every : {50U, 5U, 1U}) {
        Bytes stream;
        constexpr unsigned kFrames = 20000;
        for (unsigned i = 0; i < kFrames; ++i) {
            for (int k = 0; i % every == 0 && k < 7; ++k) {
                stream.push_back(
                    static_cast<std::uint8_t>(k == 0 ? 0xFD + random() % 2 : random()));
            }
            append(stream, attitude(i));
        }
        stream.resize(stream.size() + 2 * kMaxMavlinkFrameBytes);
        const Received got = receive(stream, 1000);
        EXPECT_EQ(got.counters.good_frames, kFrames);
        EXPECT_EQ(got.counters.lost_frames, 0U);
        // Each of them is one, but what passes for a frame of an id that is not known.
        EXPECT_NEAR(static_cast<double>(got.counters.bad_frames + got.counters.unknown_frames),
                    static_cast<double>(kFrames / every + 1), 0.01 * kFrames / every);
    }
}

TEST(MavlinkDecoder, CountsADamagedFrameAndWhatIsMissing) {
    Bytes stream = attitude(0);
    Bytes damaged = attitude(1);
    damaged[20] ^= 0x10;
    append(stream, damaged);
    append(stream, attitude(2));
    append(stream, attitude(6));
    const Received got = receive(stream);
    EXPECT_EQ(got.times_ms, (std::vector<std::uint32_t>{0, 2, 6}));
    EXPECT_EQ(got.counters.bad_frames, 1U);
    EXPECT_EQ(got.counters.lost_frames, 1U + 3U);
}

TEST(MavlinkDecoder, RefusesEveryFlippedBit) {
    for (const int version : {1, 2}) {
        const Bytes good = attitude(300, version);
        for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
            Bytes bad = good;
            bad[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
            bad.resize(bad.size() + 2 * kMaxMavlinkFrameBytes);
            const Received got = receive(bad);
            EXPECT_EQ(got.counters.good_frames, 0U) << version << " " << bit;
        }
    }
}

TEST(MavlinkDecoder, TellsAWrapAndAStepBackFromALoss) {
    Bytes stream;
    for (const unsigned number : {254U, 255U, 256U, 257U}) append(stream, attitude(number));
    append(stream, attitude(257));  // repeated
    append(stream, attitude(160));  // restarted
    append(stream, attitude(161));
    EXPECT_EQ(receive(stream).counters.lost_frames, 0U);
}

TEST(MavlinkDecoder, ForgivesFramesThatWereOvertaken) {
    Bytes stream;
    for (const unsigned number : {1U, 2U, 5U, 3U, 3U, 6U}) append(stream, attitude(number));
    EXPECT_EQ(receive(stream).counters.lost_frames, 1U);
    append(stream, attitude(4));
    append(stream, attitude(4));
    append(stream, attitude(127));
    EXPECT_EQ(receive(stream).counters.lost_frames, 120U);
    append(stream, attitude(64));
    EXPECT_EQ(receive(stream).counters.lost_frames, 119U);
    append(stream, attitude(63));  // too late: a restart
    append(stream, attitude(64));
    EXPECT_EQ(receive(stream).counters.lost_frames, 119U);
}

TEST(MavlinkDecoder, CountsTheGapsOfEachSenderAlone) {
    Bytes stream;
    for (std::uint8_t i = 0; i < 10; ++i) {
        for (std::uint8_t component = 1; component < 4; ++component) {
            const MavlinkBytes bytes = encodeMavlink(
                MavlinkHeartbeat{}, {.sequence = static_cast<std::uint8_t>(i * component),
                                     .system = 9,
                                     .component = component});
            append(stream, bytes.view());
        }
    }
    EXPECT_EQ(receive(stream).counters.lost_frames, 9U * (0 + 1 + 2));
}

TEST(MavlinkDecoder, CountsUnknownFramesAsNeitherBadNorLost) {
    Bytes stream = attitude(0);
    append(stream, unknown(1));
    append(stream, unknown(2, 255));
    append(stream, unknown(3, 0));
    append(stream, attitude(4));
    append(stream, unknown(5));
    append(stream, attitude(8));
    const Received got = receive(stream);
    EXPECT_EQ(got.times_ms, (std::vector<std::uint32_t>{0, 4, 8}));
    EXPECT_EQ(got.counters.unknown_frames, 4U);
    EXPECT_EQ(got.counters.bad_frames, 0U);
    EXPECT_EQ(got.counters.lost_frames, 2U);
}

TEST(MavlinkDecoder, LooksThroughAnUnknownFrameWithoutTakingItForNoise) {
    Bytes carrier = unknown(1, 60);
    const Bytes damaged{0xFE, 28, 0, 1, 1, 30, 7, 7, 7};  // the beginning of an attitude
    std::ranges::copy(damaged, carrier.begin() + 20);
    carrier[40] = kMavlinkMagic2;
    Bytes stream = attitude(0);
    append(stream, carrier);
    append(stream, attitude(2));
    const Received got = receive(stream);
    EXPECT_EQ(got.counters.good_frames, 2U);
    EXPECT_EQ(got.counters.unknown_frames, 1U);
    EXPECT_EQ(got.counters.bad_frames + got.counters.lost_frames, 0U);
}

// A length of noise must not swallow what lies in it.
TEST(MavlinkDecoder, FindsAFrameInsideWhatLookedLikeAnUnknownOne) {
    Bytes stream = attitude(0);
    append(stream, Bytes{kMavlinkMagic2, 255, 0, 0, 1, 1, 1, 24, 0, 0});
    for (unsigned i = 1; i < 9; ++i) append(stream, attitude(i));
    const Received got = receive(stream);
    EXPECT_EQ(got.counters.good_frames, 9U);
    EXPECT_EQ(got.counters.unknown_frames, 0U);
    EXPECT_EQ(got.counters.bad_frames, 1U);
}

TEST(MavlinkDecoder, TakesFlagsThatItDoesNotKnowForAnUnknownFrame) {
    Bytes flagged = attitude(1);
    flagged[2] = 0x02;
    Bytes stream = attitude(0);
    append(stream, flagged);
    append(stream, attitude(2));
    const Received got = receive(stream);
    EXPECT_EQ(got.counters.good_frames, 2U);
    EXPECT_EQ(got.counters.unknown_frames, 1U);
    EXPECT_EQ(got.counters.bad_frames + got.counters.lost_frames, 0U);
}

Bytes signedGolden() {
    for (const test::GoldenMavlink& golden : test::goldenMavlink()) {
        if (golden.name == "attitude_signed") return golden.bytes;
    }
    return {};
}

TEST(MavlinkDecoder, RecognisesSignedFrames) {
    Bytes stream;
    for (int i = 0; i < 5; ++i) append(stream, signedGolden());
    const Received got = receive(stream);
    EXPECT_EQ(got.counters.good_frames, 5U);
    EXPECT_EQ(got.signed_frames, 5U);
    EXPECT_EQ(got.counters.bad_frames, 0U);
}

TEST(MavlinkDecoder, FindsTheFrameBehindASignatureThatWasCut) {
    for (std::size_t missing = 1; missing <= kMavlinkSignatureBytes; ++missing) {
        Bytes stream = signedGolden();
        ASSERT_FALSE(stream.empty());
        stream.resize(stream.size() - missing);
        append(stream, attitude(1));
        const Received got = receive(stream);
        EXPECT_EQ(got.counters.good_frames, 2U) << missing;
        EXPECT_EQ(got.counters.bad_frames, 1U) << missing;
    }
}

TEST(MavlinkDecoder, TakesNothingFromNoise) {
    std::mt19937 random(3);
    Bytes noise(1U << 20);
    for (std::uint8_t& byte : noise) byte = static_cast<std::uint8_t>(random());
    const Received got = receive(noise);
    EXPECT_EQ(got.counters.good_frames, 0U);
    EXPECT_GT(got.counters.bad_frames, 0U);
}

}  // namespace
}  // namespace hedr
