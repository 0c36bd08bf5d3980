#include "radio/wire/frame_decoder.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "radio/wire/crc32c.h"
#include "radio/wire/frame_encoder.h"
#include "tests/radio/wire/arbitrary_messages.h"

namespace hedr {
namespace {

using test::KeptFrame;
using Bytes = std::vector<std::uint8_t>;

struct Decoded {
    std::vector<KeptFrame> frames;
    FrameCounters counters;
    friend bool operator==(const Decoded&, const Decoded&) = default;
};

Decoded receive(const std::vector<Bytes>& pieces) {
    Decoded result;
    FrameDecoder decoder;
    for (const Bytes& piece : pieces) {
        decoder.feed(piece, [&](const Frame& f) { result.frames.push_back(test::keep(f)); });
    }
    result.counters = decoder.counters();
    return result;
}

Bytes line(const KeptFrame& frame) {
    const FrameBytes bytes = encodeFrame(frame.frame());
    return {bytes.view().begin(), bytes.view().end()};
}

void append(Bytes& to, const Bytes& more) { to.insert(to.end(), more.begin(), more.end()); }

KeptFrame someFrame(std::uint16_t sequence) {
    return {0x02, sequence, {0, 1, 2, 0, 0, 0x11, 0xFF, 9, 0}};
}

KeptFrame anyFrame() {
    return {*rc::gen::arbitrary<std::uint8_t>(), *rc::gen::arbitrary<std::uint16_t>(),
            *rc::gen::resize(static_cast<int>(kMaxPayloadBytes), rc::gen::arbitrary<Bytes>())};
}

TEST(FrameDecoder, FindsFramesOfEveryLength) {
    for (std::size_t size = 0; size <= kMaxPayloadBytes; ++size) {
        for (const int fill : {0x00, 0x01, 0x55, 0xFF}) {
            const KeptFrame frame{9, 1, Bytes(size, static_cast<std::uint8_t>(fill))};
            const Decoded got = receive({line(frame)});
            ASSERT_EQ(got.frames, std::vector{frame});
            ASSERT_EQ(line(frame).size(), size + 9);  // nine bytes of overhead, always
        }
    }
}

RC_GTEST_PROP(FrameDecoder, GivesTheSameHoweverTheBytesAreCut, ()) {
    Bytes stream;
    for (int i = *rc::gen::inRange(1, 8); i > 0; --i) {
        append(stream, *rc::gen::arbitrary<Bytes>());
        append(stream, line(anyFrame()));
    }
    std::vector<Bytes> pieces;
    for (std::size_t at = 0; at < stream.size();) {
        const std::size_t step =
            std::min(*rc::gen::inRange<std::size_t>(1, 40), stream.size() - at);
        const auto begin = stream.begin() + static_cast<std::ptrdiff_t>(at);
        pieces.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(step));
        at += step;
    }
    std::vector<Bytes> single;
    for (const std::uint8_t byte : stream) {
        single.push_back({byte});
    }
    const Decoded whole = receive({stream});
    RC_ASSERT(receive(pieces) == whole);
    RC_ASSERT(receive(single) == whole);
}

RC_GTEST_PROP(FrameDecoder, LosesNoGoodFrameToNoiseInFrontOrBetween, ()) {
    Bytes stream;
    std::vector<KeptFrame> sent;
    for (int i = *rc::gen::inRange(1, 6); i > 0; --i) {
        append(stream, *rc::gen::resize(400, rc::gen::arbitrary<Bytes>()));
        sent.push_back(anyFrame());
        append(stream, line(sent.back()));
    }
    RC_ASSERT(receive({stream}).frames == sent);
}

TEST(FrameDecoder, FindsTheNextGoodFrameAfterNoise) {
    Bytes stream{0x55, 0x07, 0xFF, 0x01};
    append(stream, line(someFrame(1)));
    const Decoded got = receive({stream});
    EXPECT_EQ(got.frames, std::vector{someFrame(1)});
    EXPECT_EQ(got.counters.good_frames, 1U);
    EXPECT_EQ(got.counters.bad_frames, 1U);
    EXPECT_EQ(got.counters.bytes, stream.size());
}

TEST(FrameDecoder, TakesEmptyFramesForSilence) {
    Bytes stream{0, 0, 0};
    append(stream, line(someFrame(1)));
    append(stream, {0, 0});
    const Decoded got = receive({stream});
    EXPECT_EQ(got.counters.good_frames, 1U);
    EXPECT_EQ(got.counters.bad_frames, 0U);
}

TEST(FrameDecoder, CountsAnEndlessRunOnceAndFindsTheFrameBehindIt) {
    FrameDecoder decoder;
    std::vector<KeptFrame> frames;
    const auto keep = [&](const Frame& frame) { frames.push_back(test::keep(frame)); };
    for (int i = 0; i < 1000; ++i) {
        decoder.feed(Bytes(1000, 0x42), keep);
    }
    EXPECT_EQ(decoder.counters().bad_frames, 1U);
    decoder.feed(line(someFrame(3)), keep);
    EXPECT_EQ(frames, std::vector{someFrame(3)});
    decoder.feed(line(someFrame(4)), keep);
    EXPECT_EQ(decoder.counters().bad_frames, 1U);
    EXPECT_EQ(decoder.counters().good_frames, 2U);
}

TEST(FrameDecoder, NeverTakesACorruptedFrameForAGoodOne) {
    const Bytes good = line(someFrame(1));
    for (std::size_t at = 0; at + 1 < good.size(); ++at) {
        for (unsigned change = 1; change < 256; ++change) {
            Bytes bad = good;
            bad[at] = static_cast<std::uint8_t>(bad[at] ^ change);
            append(bad, line(someFrame(2)));
            const Decoded got = receive({bad});
            ASSERT_EQ(got.frames, std::vector{someFrame(2)}) << "byte " << at << " ^ " << change;
            ASSERT_GE(got.counters.bad_frames, 1U);
        }
    }
}

TEST(FrameDecoder, SurvivesTheCorruptionOfADelimiter) {
    Bytes stream = line(someFrame(1));
    stream.back() = 0x21;
    append(stream, line(someFrame(2)));
    EXPECT_EQ(receive({stream}).frames, std::vector{someFrame(2)});
}

TEST(FrameDecoder, FindsTheNextFrameWhereverOneIsCutOff) {
    const Bytes good = line(someFrame(1));
    for (std::size_t size = 0; size < good.size(); ++size) {
        Bytes stream(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size));
        append(stream, line(someFrame(2)));
        ASSERT_EQ(receive({stream}).frames, std::vector{someFrame(2)}) << "cut at " << size;
    }
}

TEST(FrameDecoder, ForgetsAnUnfinishedFrameWhenItStartsAgain) {
    FrameDecoder decoder;
    const Bytes bytes = line(someFrame(1));
    const auto ignore = [](const Frame&) {};
    decoder.feed(std::span(bytes).first(5), ignore);
    decoder.startAgain();
    decoder.feed(std::span(bytes).subspan(5), ignore);
    EXPECT_EQ(decoder.counters().good_frames, 0U);
    EXPECT_EQ(decoder.counters().bytes, bytes.size());
}

TEST(FrameEncoder, StartsARequestWithAZero) {
    const FrameBytes quiet = encodeFrameAfterSilence(someFrame(1).frame());
    EXPECT_EQ(quiet.view().front(), 0);
    EXPECT_TRUE(std::ranges::equal(quiet.view().subspan(1), line(someFrame(1))));
}

}  // namespace
}  // namespace hedr
