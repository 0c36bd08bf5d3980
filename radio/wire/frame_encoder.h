#pragma once

#include "radio/wire/frame.h"

namespace hedr {

// The payload must not be longer than kMaxPayloadBytes.
FrameBytes encodeFrame(const Frame& frame);

// The same after a 0x00, which keeps noise on a quiet line away from it: for the way to the robot,
// where requests are few and the receiver is simple.
FrameBytes encodeFrameAfterSilence(const Frame& frame);

}  // namespace hedr
