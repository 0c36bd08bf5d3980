#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "radio/wire/hedr_reports.h"
#include "radio/wire/reports.h"
#include "radio/wire/request.h"

namespace hedr {

enum class RobotLanguage : std::uint8_t { kUnknown, kHedr, kMavlink, kText };

// What a robot says, in whichever language: it is found out from the bytes alone, and the same
// bytes give the same reports, however they are cut. Once known, the language stays until the port
// is opened again.
class RobotSpeech {
  public:
    void feed(std::span<const std::uint8_t> bytes, const OnReport& on_report);
    // Bytes that follow do not continue those before: another robot may be at the other end.
    void portOpened();

    RobotLanguage language() const { return language_; }
    WireCounters counters() const;
    // The robot's clock wraps at it; infinite: never.
    double clockPeriod_s() const;
    // A request in its language, protocol 1 where none is known yet; empty where it has no words
    // for it.
    std::vector<std::uint8_t> spoken(const Request& request);

  private:
    HedrReports hedr_;
    std::uint16_t request_sequence_ = 0;
    RobotLanguage language_ = RobotLanguage::kUnknown;
};

}  // namespace hedr
