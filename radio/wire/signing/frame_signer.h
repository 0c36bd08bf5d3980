#pragma once

#include <optional>

#include "radio/wire/signing/signed_frame.h"

namespace hedr {

// Signs what goes out. Its counter must never be used twice with one key, over all restarts: it
// reserves counters in blocks, and what takeReserved() gives is to be kept (radio/robot_key.h)
// before the frame goes out; the next start begins behind it.
class FrameSigner {
  public:
    static constexpr std::uint32_t kBlock = 4096;

    // The first counter is `said` + 1.
    FrameSigner(const SigningKey& key, std::uint32_t said)
        : key_(key), counter_(said), reserved_(said) {}

    // The signed form of what encodeRequest or encodeReport gave. Nothing where the counters are
    // used up, which takes decades, or the payload is longer than kMaxSignedPayloadBytes.
    std::optional<FrameBytes> sign(const FrameBytes& plain);

    // Once after each change: every counter up to this may have been used.
    std::optional<std::uint32_t> takeReserved();

    std::uint32_t said() const { return counter_; }  // the last counter that was used

  private:
    FrameBytes signedFrame(const Frame& frame, bool after_silence) const;

    SigningKey key_;
    std::uint32_t counter_;
    std::uint32_t reserved_;
    bool reserved_changed_ = false;
};

}  // namespace hedr
