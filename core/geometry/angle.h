#pragma once

#include <cmath>
#include <numbers>

namespace hedr {

inline constexpr double kPi = std::numbers::pi;

constexpr double radFromDeg(double deg) { return deg * (kPi / 180.0); }
constexpr double degFromRad(double rad) { return rad * (180.0 / kPi); }

// The same direction in [-pi, pi].
inline double wrapAngle(double rad) { return std::remainder(rad, 2.0 * kPi); }

// The signed angle from the nearest multiple of `interval_rad` to `rad`, in ±interval/2. Not
// std::remainder, which is exact but several times as slow.
inline double deviationFromGrid(double rad, double interval_rad) {
    return rad - interval_rad * std::floor(rad / interval_rad + 0.5);
}

}  // namespace hedr
