#pragma once

#include <string>
#include <vector>

#include "radio/wire/codec.h"
#include "radio/wire/frame_decoder.h"
#include "radio/wire/signing/frame_signer.h"
#include "radio/wire/signing/frame_verifier.h"
#include "tests/radio/wire/arbitrary_messages.h"

namespace hedr::test {

inline constexpr SigningKey kAtlasKey{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
inline constexpr SigningKey kBorisKey{0xB0, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};

inline FrameVerifier::Key atlas(std::uint32_t heard = 0) { return {"atlas", kAtlasKey, heard}; }
inline FrameVerifier::Key boris() { return {"boris", kBorisKey, 0}; }

// The frames in bytes as they come off the line.
inline std::vector<KeptFrame> framesIn(std::span<const std::uint8_t> bytes) {
    std::vector<KeptFrame> frames;
    FrameDecoder().feed(bytes, [&](const Frame& frame) { frames.push_back(keep(frame)); });
    return frames;
}

inline KeptFrame plainFrame(const Report& report, std::uint16_t sequence = 1) {
    return framesIn(encodeReport(report, sequence).value().view()).at(0);
}

inline KeptFrame signedFrame(FrameSigner& signer, const Report& report = StatusReport{}) {
    return framesIn(signer.sign(encodeReport(report, 1).value()).value().view()).at(0);
}

// Of a robot that calls itself so.
inline HelloReport helloOf(const std::string& name) {
    HelloReport hello;
    hello.vehicle = name;
    return hello;
}

}  // namespace hedr::test
