#include <benchmark/benchmark.h>

#include <array>
#include <vector>

#include "radio/wire/codec.h"
#include "radio/wire/frame_decoder.h"
#include "radio/wire/frame_encoder.h"

namespace hedr {
namespace {

// One megabyte of frames that are 40 bytes long on the line, with payloads like a robot's: small
// numbers and many zeros.
std::vector<std::uint8_t> goodFrames() {
    std::vector<std::uint8_t> stream;
    std::uint32_t random = 1;
    for (std::uint16_t sequence = 0; sequence < 25000; ++sequence) {
        std::array<std::uint8_t, 31> payload{};
        for (std::uint8_t& byte : payload) {
            random = random * 1664525U + 1013904223U;
            byte = (random >> 29) < 3 ? std::uint8_t{0} : static_cast<std::uint8_t>(random >> 20);
        }
        const FrameBytes frame = encodeFrame({.id = 3, .sequence = sequence, .payload = payload});
        stream.insert(stream.end(), frame.view().begin(), frame.view().end());
    }
    return stream;
}

void setBytes(benchmark::State& state, std::size_t bytes) {
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * bytes));
}

// Budget: at least 300 MB/s.
void decodeGoodFrames(benchmark::State& state) {
    const std::vector<std::uint8_t> stream = goodFrames();
    const std::size_t piece = static_cast<std::size_t>(state.range(0));
    FrameDecoder decoder;
    for (auto _ : state) {
        for (std::size_t at = 0; at < stream.size(); at += piece) {
            decoder.feed(
                std::span(stream).subspan(at, std::min(piece, stream.size() - at)),
                [](const Frame& frame) { benchmark::DoNotOptimize(frame.payload.data()); });
        }
    }
    if (decoder.counters().bad_frames != 0) {
        state.SkipWithError("a good frame was refused");
    }
    setBytes(state, stream.size());
}
BENCHMARK(decodeGoodFrames)->Arg(4096)->Arg(64)->Arg(1);

// The reference beside it: only a bytewise table CRC-16 (CCITT) over the same bytes.
void referenceCrc16(benchmark::State& state) {
    const std::vector<std::uint8_t> stream = goodFrames();
    std::array<std::uint16_t, 256> table{};
    for (unsigned byte = 0; byte < 256; ++byte) {
        unsigned crc = byte << 8;
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc << 1) ^ ((crc & 0x8000U) != 0 ? 0x1021U : 0U);
        }
        table[byte] = static_cast<std::uint16_t>(crc);
    }
    for (auto _ : state) {
        std::uint16_t crc = 0xFFFF;
        for (const std::uint8_t byte : stream) {
            crc = static_cast<std::uint16_t>(crc << 8 ^ table[(crc >> 8 ^ byte) & 0xFF]);
        }
        benchmark::DoNotOptimize(crc);
    }
    setBytes(state, stream.size());
}
BENCHMARK(referenceCrc16);

// From bytes to reports in SI units.
void decodeSensorReports(benchmark::State& state) {
    std::vector<std::uint8_t> stream;
    for (std::uint16_t sequence = 0; sequence < 25000; ++sequence) {
        SensorReport report;
        report.robot_time_s = 0.01 * sequence;
        report.odometry = WheelTicks{sequence * 13, sequence * 12};
        report.gyro = GyroAngle{sequence * 171U};
        const FrameBytes frame = encodeReport(report, sequence).value();
        stream.insert(stream.end(), frame.view().begin(), frame.view().end());
    }
    FrameDecoder decoder;
    for (auto _ : state) {
        decoder.feed(stream, [](const Frame& frame) {
            auto report = decodeReport(frame);
            benchmark::DoNotOptimize(report);
        });
    }
    setBytes(state, stream.size());
}
BENCHMARK(decodeSensorReports);

}  // namespace
}  // namespace hedr
