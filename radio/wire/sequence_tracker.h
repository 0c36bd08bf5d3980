#pragma once

#include <bitset>
#include <cstdint>
#include <optional>

namespace hedr {

enum class Arrival : std::uint8_t {
    kInOrder,   // later than every one before
    kLate,      // overtaken by others: what it says is old
    kRepeated,  // has been here
    kRestarted  // the sender counts from a new beginning
};

// Tells loss, overtaking, repetition and a restart of the sender apart by the 16-bit numbers of
// its frames. A frame that is overtaken counts as lost until it comes.
class SequenceTracker {
  public:
    // As many numbers back as a late frame is still known; further back is a restart.
    static constexpr int kWindow = 512;
    // So many numbers in a row that seemed late, each after the one before: a restart, too.
    static constexpr int kRestartAfterLate = 16;
    static constexpr int kLongStep = 1000;

    Arrival note(std::uint16_t sequence);
    // The sender was restarted, or the line was opened again: the next number begins anew. What
    // seemed a long loss since the last confirm() was the restart.
    void startAgain();
    // The sender is still the one that it was.
    void confirm() { suspected_ = 0; }

    std::uint64_t lost() const { return lost_; }
    std::uint64_t late() const { return late_; }
    std::uint64_t repeated() const { return repeated_; }

  private:
    Arrival begin(std::uint16_t sequence);
    Arrival advance(std::uint16_t sequence, int step);
    Arrival lookBack(int back);
    bool countsAnew(std::uint16_t sequence);

    std::optional<std::uint16_t> last_{};
    std::bitset<kWindow> seen_{};  // bit n: last - n
    std::optional<std::uint16_t> last_late_{};
    int late_in_a_row_ = 0;
    std::uint64_t suspected_ = 0;  // of lost_: by a step so long that it may be a restart
    std::uint64_t lost_ = 0;
    std::uint64_t late_ = 0;
    std::uint64_t repeated_ = 0;
};

}  // namespace hedr
