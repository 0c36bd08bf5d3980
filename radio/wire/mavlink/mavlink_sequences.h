#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace hedr {

// Counts the frames that are missing between the sequence numbers of each sender. A step back is a
// repetition or a restart and no loss; of a restart that looks like a step forward, up to 127
// frames are counted: eight bits cannot tell.
class MavlinkSequences {
  public:
    // Frames lost since the sender's last one.
    int heard(std::uint8_t system, std::uint8_t component, std::uint8_t sequence) {
        Sender* sender = find(system, component);
        if (sender == nullptr) {
            if (count_ < senders_.size()) senders_[count_++] = {system, component, sequence};
            return 0;
        }
        const int missing = static_cast<std::uint8_t>(sequence - sender->sequence - 1);
        sender->sequence = sequence;
        return missing < 128 ? missing : 0;
    }
    bool knows(std::uint8_t system, std::uint8_t component) {
        return find(system, component) != nullptr;
    }

  private:
    struct Sender {
        std::uint8_t system = 0;
        std::uint8_t component = 0;
        std::uint8_t sequence = 0;
    };
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
