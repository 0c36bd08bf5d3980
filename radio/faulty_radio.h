#pragma once

#include <cstdint>
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
    std::uint64_t seed = 1;
};

// Sets one of loss, corrupt, noise, lump, seed. Errors: kUnknownName (lists them), kBadValue.
Result<void> setRadioFault(RadioFaults& faults, std::string_view key, std::string_view value);

class FaultyRadio {
  public:
    using Deliver = std::function<void(std::span<const std::uint8_t>)>;

    explicit FaultyRadio(const RadioFaults& faults);

    void send(std::span<const std::uint8_t> frame, const Deliver& deliver);
    // What is still held back for a lump.
    void flush(const Deliver& deliver);

  private:
    void addNoise();
    void addCorrupted(std::span<const std::uint8_t> frame);

    RadioFaults faults_;
    Random random_;
    std::vector<std::uint8_t> waiting_;
};

}  // namespace hedr
