#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "radio/wire/frame_decoder.h"
#include "radio/wire/reports.h"
#include "radio/wire/sequence_tracker.h"
#include "radio/wire/signing/frame_verifier.h"

namespace hedr {

// What a robot says that speaks protocol 1: frames that are whole, known, believed, and not
// overtaken by later ones.
class HedrReports {
  public:
    explicit HedrReports(FrameVerifier verifier = FrameVerifier())
        : verifier_(std::move(verifier)) {}

    void feed(std::span<const std::uint8_t> bytes, const OnReport& on_report);
    // Bytes that follow do not continue those before.
    void portOpened();
    WireCounters counters() const;
    FrameVerifier& verifier() { return verifier_; }
    const FrameVerifier& verifier() const { return verifier_; }
    // Since the last call.
    std::vector<RejectedFrame> takeRejected() { return std::exchange(rejected_, {}); }

  private:
    void take(const Frame& frame, const OnReport& on_report);
    Arrival arrivalOf(const Frame& frame, const Report& report);

    FrameDecoder decoder_;
    FrameVerifier verifier_;
    std::vector<RejectedFrame> rejected_;
    SequenceTracker sequence_;
    std::optional<std::uint32_t> boot_id_{};
    bool other_protocol_ = false;  // by its hello, which is all that is read then
    std::uint64_t too_short_ = 0;
    std::uint64_t unknown_ = 0;
};

}  // namespace hedr
