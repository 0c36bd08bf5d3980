#include "radio/wire/mavlink/mavlink_clock.h"

#include <algorithm>

namespace hedr {
namespace {

constexpr std::uint64_t kUnixFrom_us = 1'000'000'000'000'000;  // September 2001; 31 years of uptime
constexpr std::int64_t kLatest_us = std::int64_t{1} << 60;
constexpr std::int64_t kOvertaking_us = 3'000'000;

}  // namespace

double MavlinkClock::ofBoot_s(std::uint8_t component, std::uint32_t time_boot_ms) {
    std::int64_t stamp_ms = time_boot_ms;
    if (const Clock* clock = find(component, false)) {
        const std::int64_t last_ms = clock->last_us / 1000;
        const auto step_ms =
            static_cast<std::int32_t>(time_boot_ms - static_cast<std::uint32_t>(last_ms));
        if (last_ms + step_ms > stamp_ms) stamp_ms = last_ms + step_ms;  // it has wrapped
    }
    return take(component, false, 1000 * stamp_ms);
}

double MavlinkClock::ofMicroseconds_s(std::uint8_t component, std::uint64_t time_us) {
    return take(component, time_us >= kUnixFrom_us,
                static_cast<std::int64_t>(std::min<std::uint64_t>(time_us, kLatest_us)));
}

bool MavlinkClock::restarted(std::uint8_t component) const {
    return std::ranges::any_of(clocks_, [&](const Clock& clock) {
        return clock.component == component && clock.went_back && !clock.is_unix;
    });
}

MavlinkClock::Clock* MavlinkClock::find(std::uint8_t component, bool is_unix) {
    const auto end = clocks_.begin() + static_cast<std::ptrdiff_t>(count_);
    const auto found = std::find_if(clocks_.begin(), end, [&](const Clock& clock) {
        return clock.component == component && clock.is_unix == is_unix;
    });
    return found != end ? &*found : nullptr;
}

double MavlinkClock::take(std::uint8_t component, bool is_unix, std::int64_t stamp_us) {
    Clock* clock = find(component, is_unix);
    if (clock == nullptr) {
        const bool first = count_ == 0;
        clock = &clocks_[std::min(count_, clocks_.size() - 1)];
        count_ = std::min(count_ + 1, clocks_.size());
        const std::int64_t offset_us = first && !is_unix ? 0 : latest_us_ - stamp_us;
        *clock = {component, is_unix, false, stamp_us, offset_us};
    }
    if (stamp_us < clock->last_us - kOvertaking_us) {
        clock->went_back = true;
        clock->last_us = stamp_us;
        clock->offset_us = latest_us_ - stamp_us;
    }
    clock->last_us = std::max(clock->last_us, stamp_us);
    const std::int64_t time_us = stamp_us + clock->offset_us;
    if (time_us > kLatest_us) {  // no robot runs for so long: begin again
        *this = {};
        return take(component, is_unix, stamp_us);
    }
    latest_us_ = std::max(latest_us_, time_us);
    return 1e-6 * static_cast<double>(time_us);
}

}  // namespace hedr
