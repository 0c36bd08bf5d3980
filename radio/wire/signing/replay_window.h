#pragma once

#include <cstdint>

namespace hedr {

// Takes each counter once, in any order as long as it is less than 64 behind the highest.
class ReplayWindow {
  public:
    // Nothing up to `heard` will be taken.
    explicit ReplayWindow(std::uint32_t heard = 0) : highest_(heard) {}

    bool take(std::uint32_t counter) {
        if (counter > highest_) {
            const std::uint32_t step = counter - highest_;
            seen_ = (step < 64 ? seen_ << step : 0) | 1U;
            highest_ = counter;
            return true;
        }
        const std::uint32_t age = highest_ - counter;
        const bool fresh = age < 64 && (seen_ >> age & 1U) == 0;
        if (fresh) {
            seen_ |= std::uint64_t{1} << age;
        }
        return fresh;
    }

    std::uint32_t highest() const { return highest_; }

  private:
    std::uint32_t highest_;
    std::uint64_t seen_ = ~std::uint64_t{0};  // bit n: highest_ - n
};

}  // namespace hedr
