#include "radio/wire/robot_speech.h"

#include "radio/wire/codec.h"

namespace hedr {

void RobotSpeech::feed(std::span<const std::uint8_t> bytes, const OnReport& on_report) {
    hedr_.feed(bytes, on_report);
    if (hedr_.recognised()) language_ = RobotLanguage::kHedr;
}

void RobotSpeech::portOpened() { hedr_.portOpened(); }

WireCounters RobotSpeech::counters() const { return hedr_.counters(); }

double RobotSpeech::clockPeriod_s() const { return kRobotClockPeriod_s; }

std::vector<std::uint8_t> RobotSpeech::spoken(const Request& request) {
    const FrameBytes frame = encodeRequest(request, request_sequence_++);
    return {frame.view().begin(), frame.view().end()};
}

}  // namespace hedr
