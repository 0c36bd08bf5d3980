#include "radio/wire/sequence_tracker.h"

#include <algorithm>

namespace hedr {

Arrival SequenceTracker::note(std::uint16_t sequence) {
    if (!last_) {
        begin(sequence);
        return Arrival::kInOrder;
    }
    const auto step = static_cast<std::int16_t>(static_cast<std::uint16_t>(sequence - *last_));
    if (step > 0) return advance(sequence, step);
    if (-step >= kWindow || countsAnew(sequence)) return begin(sequence);
    return lookBack(-step);
}

void SequenceTracker::startAgain() {
    lost_ -= suspected_;
    suspected_ = 0;
    last_.reset();
}

Arrival SequenceTracker::begin(std::uint16_t sequence) {
    last_ = sequence;
    last_late_.reset();
    late_in_a_row_ = 0;
    // What came before the beginning is not missing: were it to come late, it was no loss.
    seen_.set();
    return Arrival::kRestarted;
}

Arrival SequenceTracker::advance(std::uint16_t sequence, int step) {
    const auto missing = static_cast<std::uint64_t>(step - 1);
    lost_ += missing;
    if (step >= kLongStep) suspected_ += missing;
    last_ = sequence;
    seen_ = step < kWindow ? seen_ << static_cast<std::size_t>(step) : std::bitset<kWindow>{};
    seen_.set(0);
    last_late_.reset();
    late_in_a_row_ = 0;
    return Arrival::kInOrder;
}

Arrival SequenceTracker::lookBack(int back) {
    const auto place = static_cast<std::size_t>(back);
    if (seen_.test(place)) {
        ++repeated_;
        return Arrival::kRepeated;
    }
    seen_.set(place);
    --lost_;
    suspected_ = std::min(suspected_, lost_);
    ++late_;
    return Arrival::kLate;
}

// A sender that was restarted early in its count seems to send late frames, but one after the other
// and none between them.
bool SequenceTracker::countsAnew(std::uint16_t sequence) {
    const bool follows = last_late_ && static_cast<std::uint16_t>(sequence - *last_late_) == 1;
    late_in_a_row_ = follows ? late_in_a_row_ + 1 : 0;
    last_late_ = sequence;
    return late_in_a_row_ >= kRestartAfterLate;
}

}  // namespace hedr
