#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "core/simulation/random.h"

namespace hedr {

// What a bad radio does to frames on their way, for tests and demonstrations.
struct RadioFaults {
    double loss = 0.0;           // share of frames that vanish
    double corrupt = 0.0;        // share of bytes that are changed
    double noise = 0.0;          // share of frames with noise bytes in front
    std::size_t lump_bytes = 0;  // bytes delivered at once; 0: as they come
    double duplicate = 0.0;      // share of frames that come twice
    double truncate = 0.0;       // share of frames whose end is missing
    double reorder = 0.0;        // share of frames that one to five later ones overtake: datagrams
    double delay_s = 0.0;        // each frame is late by up to this, in order; needs passTime
    double burst_at_s = 0.0;     // from then on a silence of burst_s; needs passTime
    double burst_s = 0.0;
    std::uint64_t seed = 1;
};

// What became of the frames.
struct RadioDeeds {
    std::uint64_t lost = 0;
    std::uint64_t corrupted = 0;
    std::uint64_t duplicated = 0;
    std::uint64_t truncated = 0;
    std::uint64_t reordered = 0;
};

// Sets one of loss, corrupt, noise, lump, duplicate, truncate, reorder, delay_s, burst_at_s,
// burst_s, seed. Errors: kUnknownName (lists them), kBadValue.
Result<void> setRadioFault(RadioFaults& faults, std::string_view key, std::string_view value);

class FaultyRadio {
  public:
    using Deliver = std::function<void(std::span<const std::uint8_t>)>;

    explicit FaultyRadio(const RadioFaults& faults);

    void send(std::span<const std::uint8_t> frame, const Deliver& deliver);
    // It is so late now, by the robot's clock: what was delayed until then comes.
    void passTime(double time_s, const Deliver& deliver);
    // What is still held back.
    void flush(const Deliver& deliver);

    const RadioDeeds& deeds() const { return deeds_; }

  private:
    struct Held {
        double due_s = 0.0;
        int frames_first = 0;  // so many others overtake it
        std::vector<std::uint8_t> bytes;
    };

    bool happens(double share) { return share > 0.0 && random_.uniform() < share; }
    bool inBurst() const;
    void carry(std::span<const std::uint8_t> frame, const Deliver& deliver);
    void releaseOvertaken(const Deliver& deliver);
    void hand(const Deliver& deliver);
    void addNoise();
    std::vector<std::uint8_t> damaged(std::span<const std::uint8_t> frame);

    RadioFaults faults_;
    Random random_;
    RadioDeeds deeds_{};
    double time_s_ = 0.0;
    double last_due_s_ = 0.0;
    std::vector<std::uint8_t> waiting_;  // for a lump
    std::deque<Held> delayed_;
    std::vector<Held> overtaken_;
};

}  // namespace hedr
