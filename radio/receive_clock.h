#pragma once

#include <chrono>
#include <ctime>

namespace hedr {

// The clock by which packets are stamped and ages are told. It never jumps with the wall clock, and
// goes on while the computer sleeps: what was heard before is as old as it is.
struct ReceiveClock {
    // NOLINTBEGIN(readability-identifier-naming): the standard asks for these names
    using duration = std::chrono::nanoseconds;
    using rep = duration::rep;
    using period = duration::period;
    using time_point = std::chrono::time_point<ReceiveClock>;
    static constexpr bool is_steady = true;
    // NOLINTEND(readability-identifier-naming)

    static time_point now() {
        timespec time{};
        ::clock_gettime(CLOCK_BOOTTIME, &time);
        return time_point(std::chrono::seconds(time.tv_sec) +
                          std::chrono::nanoseconds(time.tv_nsec));
    }
};

}  // namespace hedr
