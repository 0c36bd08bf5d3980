// Whatever comes over the line, and however it is cut: no crash, and what decodes encodes again.
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "radio/firmware/hedr_robot.h"
#include "radio/wire/codec.h"
#include "radio/wire/frame_decoder.h"

namespace {

using hedr::Frame;
using hedr::FrameDecoder;

void demand(bool holds) {
    if (!holds) {
        std::abort();
    }
}

void decodeBoth(const Frame& frame) {
    if (const auto report = hedr::decodeReport(frame)) {
        const auto again = hedr::encodeReport(*report, frame.sequence);
        demand(again.has_value());
        FrameDecoder decoder;
        decoder.feed(again->view(),
                     [](const Frame& f) { demand(hedr::decodeReport(f).has_value()); });
        demand(decoder.counters().good_frames == 1);
    }
    if (const auto request = hedr::decodeRequest(frame)) {
        const auto again = hedr::encodeRequest(*request, frame.sequence);
        FrameDecoder decoder;
        decoder.feed(again.view(),
                     [&](const Frame& f) { demand(hedr::decodeRequest(f) == request); });
        demand(decoder.counters().good_frames == 1);
    }
}

void robotHears(std::span<const std::uint8_t> bytes) {
    const hedr_config config = hedr_default_config();
    hedr_robot robot;
    hedr_robot_init(&robot, &config);
    hedr_decoder decoder;
    hedr_decoder_init(&decoder);
    hedr_request request{};
    std::vector<std::uint8_t> frame(HEDR_FRAME_MAX);
    for (const std::uint8_t byte : bytes) {
        if (hedr_decoder_push(&decoder, byte, &request)) {
            hedr_robot_answer(&robot, &request, 1, frame.data(), 1);
            hedr_robot_update(&robot, request.token, request.value, request.x_mm, request.heading);
        }
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span<const std::uint8_t> bytes(data, size);
    FrameDecoder whole;
    whole.feed(bytes, decodeBoth);
    FrameDecoder cut;
    for (const std::uint8_t byte : bytes) {
        cut.feed(std::span(&byte, 1), [](const Frame&) {});
    }
    demand(whole.counters() == cut.counters());
    // Without the checksum in the way, so that the codec sees more than what chance lets through.
    if (size >= 3) {
        const auto payload = bytes.subspan(3).first(std::min(size - 3, hedr::kMaxPayloadBytes));
        decodeBoth({.id = data[0], .sequence = data[1], .payload = payload});
    }
    robotHears(bytes);
    return 0;
}
