#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace hedr {

// Counts the frames that are missing between the sequence numbers of each sender. One that was
// overtaken is no longer missing when it comes; repetitions and a step back, which is a restart,
// are no loss. Of a restart that looks like a step forward, up to 127 frames are counted: eight
// bits cannot tell.
class MavlinkSequences {
  public:
    // How many more frames are missing now; -1 where one of them has come after all.
    int heard(std::uint8_t system, std::uint8_t component, std::uint8_t sequence) {
        if (Sender* sender = find(system, component)) return step(*sender, sequence);
        if (count_ < senders_.size()) senders_[count_++] = {system, component, sequence};
        return 0;
    }
    bool knows(std::uint8_t system, std::uint8_t component) {
        return find(system, component) != nullptr;
    }

  private:
    static constexpr int kWindow = 64;
    struct Sender {
        std::uint8_t system = 0;
        std::uint8_t component = 0;
        std::uint8_t newest = 0;
        std::uint64_t came = ~std::uint64_t{0};  // bit k: newest - k has come, or was not awaited
    };

    static int step(Sender& sender, std::uint8_t sequence) {
        const int ahead = static_cast<std::uint8_t>(sequence - sender.newest);
        const int behind = 256 - ahead;
        if (ahead == 0) return 0;
        if (ahead < 128) {
            sender.newest = sequence;
            sender.came = (ahead < kWindow ? sender.came << ahead : 0U) | 1U;
            return ahead - 1;
        }
        if (behind >= kWindow) {
            sender.newest = sequence;
            sender.came = ~std::uint64_t{0};
            return 0;
        }
        const std::uint64_t bit = std::uint64_t{1} << behind;
        const bool repeated = (sender.came & bit) != 0;
        sender.came |= bit;
        return repeated ? 0 : -1;
    }

    Sender* find(std::uint8_t system, std::uint8_t component) {
        const auto end = senders_.begin() + static_cast<std::ptrdiff_t>(count_);
        const auto found = std::find_if(senders_.begin(), end, [&](const Sender& s) {
            return s.system == system && s.component == component;
        });
        return found != end ? &*found : nullptr;
    }

    std::array<Sender, 64> senders_{};  // the losses of further ones are not counted
    std::size_t count_ = 0;
};

}  // namespace hedr
