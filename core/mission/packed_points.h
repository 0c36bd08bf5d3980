#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "core/track/track.h"

namespace hedr {

// Track points as little-endian doubles t, x, y, heading, bias. Variances can be computed again.
inline constexpr std::size_t kPackedPointBytes = 5 * sizeof(double);
static_assert(std::endian::native == std::endian::little, "missions hold little-endian numbers");

inline std::vector<std::uint8_t> packPoints(std::span<const TrackPoint> points) {
    std::vector<std::uint8_t> bytes(kPackedPointBytes * points.size());
    std::uint8_t* out = bytes.data();
    for (const TrackPoint& point : points) {
        const auto& [position, heading_rad] = point.pose;
        const double values[] = {point.t_s, position.x, position.y, heading_rad,
                                 point.gyro_bias_rad_s};
        std::memcpy(out, values, sizeof values);
        out += sizeof values;
    }
    return bytes;
}

// Appends whole points; a rest of fewer bytes than a point needs is not read.
inline void unpackPoints(std::span<const std::uint8_t> bytes, std::vector<TrackPoint>& points) {
    for (; bytes.size() >= kPackedPointBytes; bytes = bytes.subspan(kPackedPointBytes)) {
        double values[5];
        std::memcpy(values, bytes.data(), sizeof values);
        points.push_back({values[0], {{values[1], values[2]}, values[3]}, values[4]});
    }
}

}  // namespace hedr
