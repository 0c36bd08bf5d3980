#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace hedr {

// One robot time of the stamps of a vehicle's messages: milliseconds since boot, which wrap, and
// microseconds since boot or, told by their size, of the Unix clock; of several components, each
// with a boot of its own. The first clock heard is robot time (a Unix one counts from zero).
// Another one is laid on it where it is first heard, and stays: it is late by the age that the
// message before it had then.
class MavlinkClock {
  public:
    double ofBoot_s(std::uint8_t component, std::uint32_t time_boot_ms);
    double ofMicroseconds_s(std::uint8_t component, std::uint64_t time_us);

    double latest_s() const { return 1e-6 * static_cast<double>(latest_us_); }
    // A component's time since boot has gone back, by more than messages overtake one another.
    bool restarted(std::uint8_t component) const;

  private:
    struct Clock {
        std::uint8_t component = 0;
        bool is_unix = false;
        bool went_back = false;
        std::int64_t last_us = 0;
        std::int64_t offset_us = 0;
    };
    Clock* find(std::uint8_t component, bool is_unix);
    double take(std::uint8_t component, bool is_unix, std::int64_t stamp_us);

    std::array<Clock, 16> clocks_{};  // what is too much is taken for the last one
    std::size_t count_ = 0;
    std::int64_t latest_us_ = 0;
};

}  // namespace hedr
