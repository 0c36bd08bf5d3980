#include "radio/wire/hedr_reports.h"

#include <variant>

#include "radio/wire/codec.h"

namespace hedr {

namespace {

// Whether a later report of its kind has made it worthless. Answers and events stand for
// themselves.
bool growsOld(const Report& report) {
    return std::holds_alternative<HelloReport>(report) ||
           std::holds_alternative<PoseReport>(report) ||
           std::holds_alternative<SensorReport>(report) ||
           std::holds_alternative<StatusReport>(report);
}

}  // namespace

void HedrReports::feed(std::span<const std::uint8_t> bytes, const OnReport& on_report) {
    decoder_.feed(bytes, [&](const Frame& frame) { take(frame, on_report); });
}

void HedrReports::portOpened() {
    decoder_.startAgain();
    sequence_.startAgain();
}

void HedrReports::take(const Frame& frame, const OnReport& on_report) {
    const Judgement judgement = verifier_.judge(frame);
    if (judgement.rejected) {
        rejected_.push_back({judgement.index, *judgement.rejected});
        return;
    }
    const auto report = decodeReport(judgement.frame);
    if (!report) {
        ++(report.error() == DecodeFailure::kUnknownId ? unknown_ : too_short_);
        sequence_.note(frame.sequence);
        return;
    }
    const Arrival arrival = arrivalOf(frame, *report);
    if (other_protocol_ && !std::holds_alternative<HelloReport>(*report)) {
        ++unknown_;
        return;
    }
    const bool old =
        arrival == Arrival::kRepeated || (arrival == Arrival::kLate && growsOld(*report));
    if (!old) on_report(*report);
}

Arrival HedrReports::arrivalOf(const Frame& frame, const Report& report) {
    if (const auto* hello = std::get_if<HelloReport>(&report)) {
        if (boot_id_ && *boot_id_ != hello->boot_id) {
            sequence_.startAgain();
        } else {
            sequence_.confirm();
        }
        boot_id_ = hello->boot_id;
        other_protocol_ = hello->protocol != kProtocol;
    }
    return sequence_.note(frame.sequence);
}

WireCounters HedrReports::counters() const {
    const FrameCounters& frames = decoder_.counters();
    return {.bytes = frames.bytes,
            .good_frames = frames.good_frames,
            .bad_frames = frames.bad_frames + too_short_,
            .lost_frames = sequence_.lost(),
            .late_frames = sequence_.late() + sequence_.repeated(),
            .unknown_frames = unknown_};
}

}  // namespace hedr
