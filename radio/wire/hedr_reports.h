#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "radio/wire/frame_decoder.h"
#include "radio/wire/reports.h"
#include "radio/wire/sequence_tracker.h"

namespace hedr {

// What a robot says that speaks protocol 1: frames that are whole, known, and not overtaken by
// later ones.
class HedrReports {
  public:
    void feed(std::span<const std::uint8_t> bytes, const OnReport& on_report);
    // Bytes that follow do not continue those before.
    void portOpened();
    WireCounters counters() const;
    bool recognised() const { return decoder_.counters().good_frames > 0; }

  private:
    void take(const Frame& frame, const OnReport& on_report);
    Arrival arrivalOf(const Frame& frame, const Report& report);

    FrameDecoder decoder_;
    SequenceTracker sequence_;
    std::optional<std::uint32_t> boot_id_{};
    std::uint64_t too_short_ = 0;
    std::uint64_t unknown_ = 0;
};

}  // namespace hedr
