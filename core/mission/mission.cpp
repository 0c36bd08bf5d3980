#include "core/mission/mission.h"

#include <bit>
#include <cmath>
#include <cstring>

namespace hedr {

static_assert(std::endian::native == std::endian::little, "missions hold little-endian numbers");

std::vector<std::uint8_t> packDirection(std::optional<double> direction_rad) {
    if (!direction_rad) return {};
    std::vector<std::uint8_t> data(sizeof(double));
    std::memcpy(data.data(), &*direction_rad, sizeof(double));
    return data;
}

std::optional<double> unpackDirection(std::span<const std::uint8_t> data) {
    double direction_rad = 0.0;
    if (data.size() != sizeof direction_rad) return std::nullopt;
    std::memcpy(&direction_rad, data.data(), sizeof direction_rad);
    return std::isfinite(direction_rad) ? std::optional(direction_rad) : std::nullopt;
}

}  // namespace hedr
