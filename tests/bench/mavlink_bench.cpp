#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <vector>

#include "radio/wire/mavlink/mavlink_codec.h"
#include "radio/wire/mavlink/mavlink_decoder.h"
#include "radio/wire/mavlink/mavlink_reports.h"

namespace hedr {
namespace {

constexpr unsigned kFrames = 25600;  // the sequence number is where it was after all of them

// A megabyte of ATTITUDE in version 2: 40 bytes each on the line.
std::vector<std::uint8_t> attitudes() {
    std::vector<std::uint8_t> stream;
    for (unsigned i = 0; i < kFrames; ++i) {
        const float t = 0.01F * static_cast<float>(i);
        const MavlinkAttitude m{10 * i, 0.01F, 0.02F, t, 0.1F, 0.2F, 1.0F + t};
        const MavlinkBytes frame = encodeMavlink(
            m, {.sequence = static_cast<std::uint8_t>(i), .system = 1, .component = 1});
        stream.insert(stream.end(), frame.view().begin(), frame.view().end());
    }
    return stream;
}

// Seven bytes of noise in every fifty messages.
std::vector<std::uint8_t> noisy(std::vector<std::uint8_t> stream) {
    constexpr std::size_t kFrame = 40;
    std::vector<std::uint8_t> result;
    std::uint32_t random = 1;
    for (std::size_t at = 0; at < stream.size(); at += kFrame) {
        for (int i = 0; at % (50 * kFrame) == 0 && i < 7; ++i) {
            random = random * 1664525U + 1013904223U;
            result.push_back(static_cast<std::uint8_t>(random >> 24));
        }
        const auto frame = stream.begin() + static_cast<std::ptrdiff_t>(at);
        result.insert(result.end(), frame, frame + kFrame);
    }
    return result;
}

// What MAVLink's own parsers do: a byte at a time through a state machine, and a frame that fails
// is gone with all that it had swallowed.
class BytewiseParser {
  public:
    bool take(std::uint8_t byte) {
        if (size_ == 0 && byte != kMavlinkMagic2) return false;
        frame_[size_++] = byte;
        if (size_ == 2) end_ = kMavlinkHeader2Bytes + byte;
        if (size_ > 1 && size_ <= end_) accumulate(byte);
        if (size_ == end_ && size_ > 2) accumulate(kAttitudeExtra);
        if (size_ < 2 || size_ < end_ + kMavlinkChecksumBytes) return false;
        const bool good = frame_[end_] == (crc_ & 0xFFU) && frame_[end_ + 1] == crc_ >> 8;
        size_ = 0;
        crc_ = 0xFFFF;
        return good;
    }

  private:
    static constexpr std::uint8_t kAttitudeExtra = 39;
    void accumulate(std::uint8_t byte) {
        unsigned mixed = byte ^ (crc_ & 0xFFU);
        mixed = (mixed ^ (mixed << 4)) & 0xFFU;
        crc_ = ((crc_ >> 8) ^ (mixed << 8) ^ (mixed << 3) ^ (mixed >> 4)) & 0xFFFFU;
    }

    std::array<std::uint8_t, kMaxMavlinkFrameBytes> frame_{};
    std::size_t size_ = 0;
    std::size_t end_ = 0;
    unsigned crc_ = 0xFFFF;
};

void setBytes(benchmark::State& state, std::size_t bytes) {
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * bytes));
}

// Budget: at least 273 MB/s; in pieces of so many bytes.
void mavlinkDecode(benchmark::State& state) {
    const std::vector<std::uint8_t> stream = attitudes();
    const auto piece = static_cast<std::size_t>(state.range(0));
    MavlinkDecoder decoder;
    for (auto _ : state) {
        for (std::size_t at = 0; at < stream.size(); at += piece) {
            decoder.feed(
                std::span(stream).subspan(at, std::min(piece, stream.size() - at)),
                [](const MavlinkFrame& frame) { benchmark::DoNotOptimize(frame.payload.data()); });
        }
    }
    const WireCounters& counters = decoder.counters();
    if (counters.bad_frames + counters.lost_frames != 0) {
        state.SkipWithError("a good frame was refused");
    }
    setBytes(state, stream.size());
}
BENCHMARK(mavlinkDecode)->Arg(4096)->Arg(64)->Arg(1);

void mavlinkDecodeNoise(benchmark::State& state) {
    const std::vector<std::uint8_t> stream = noisy(attitudes());
    for (auto _ : state) {
        MavlinkDecoder decoder;
        decoder.feed(stream, [](const MavlinkFrame&) {});
        if (decoder.counters().good_frames != kFrames) state.SkipWithError("a good frame was lost");
    }
    setBytes(state, stream.size());
}
BENCHMARK(mavlinkDecodeNoise);

void referenceParse(benchmark::State& state, const std::vector<std::uint8_t>& stream) {
    std::uint64_t good = 0;
    for (auto _ : state) {
        BytewiseParser parser;
        good = 0;
        for (const std::uint8_t byte : stream) good += parser.take(byte) ? 1 : 0;
    }
    state.counters["good"] = static_cast<double>(good);  // of 25,600
    setBytes(state, stream.size());
}
void mavlinkReference(benchmark::State& state) { referenceParse(state, attitudes()); }
BENCHMARK(mavlinkReference);
void mavlinkReferenceNoise(benchmark::State& state) { referenceParse(state, noisy(attitudes())); }
BENCHMARK(mavlinkReferenceNoise);

// From bytes to reports in SI units.
void mavlinkReports(benchmark::State& state) {
    std::vector<std::uint8_t> stream = attitudes();
    const MavlinkBytes heartbeat = encodeMavlink(MavlinkHeartbeat{}, {.system = 1, .component = 1});
    stream.insert(stream.begin(), heartbeat.view().begin(), heartbeat.view().end());
    for (auto _ : state) {
        MavlinkReports reports;
        reports.feed(stream, [](const Report& report) { benchmark::DoNotOptimize(&report); });
    }
    setBytes(state, stream.size());
}
BENCHMARK(mavlinkReports);

}  // namespace
}  // namespace hedr
