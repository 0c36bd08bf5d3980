#include "core/robot/vehicle_keys.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text/number.h"

namespace hedr {

namespace {

using KeyRange = VehicleKey::Range;
using KeyNeed = VehicleKey::Need;

constexpr double kSmallest = 1e-12;
// The worst gyros have a thousandth of it, as white noise and as walk of the bias.
constexpr double kNoisiestGyro = 10.0;

constexpr std::array kNumberKeys = {
    VehicleKey{"left_wheel_diameter_m", KeyRange::kPositive, KeyNeed::kRequired,
               [](Vehicle& v) -> double& { return v.geometry.left_wheel_diameter_m; }},
    VehicleKey{"right_wheel_diameter_m", KeyRange::kPositive, KeyNeed::kRequired,
               [](Vehicle& v) -> double& { return v.geometry.right_wheel_diameter_m; }},
    VehicleKey{"wheelbase_m", KeyRange::kPositive, KeyNeed::kRequired,
               [](Vehicle& v) -> double& { return v.geometry.wheelbase_m; }},
    VehicleKey{"ticks_per_revolution", KeyRange::kPositive, KeyNeed::kRequired,
               [](Vehicle& v) -> double& { return v.geometry.ticks_per_revolution; }},
    VehicleKey{"gyro_scale", KeyRange::kPositive, KeyNeed::kOptional,
               [](Vehicle& v) -> double& { return v.gyro_scale; }},
    VehicleKey{"gyro_noise_rad_s_sqrthz", KeyRange::kNotNegative, KeyNeed::kOptional,
               [](Vehicle& v) -> double& { return v.gyro_noise_rad_s_sqrthz; }, kNoisiestGyro},
    VehicleKey{"gyro_bias_walk_rad_s_sqrts", KeyRange::kNotNegative, KeyNeed::kOptional,
               [](Vehicle& v) -> double& { return v.gyro_bias_walk_rad_s_sqrts; }, kNoisiestGyro},
    VehicleKey{"max_speed_m_s", KeyRange::kPositive, KeyNeed::kOptional,
               [](Vehicle& v) -> double& { return v.max_speed_m_s; }},
};
constexpr std::array kGyroDriftKeys = {
    VehicleKey{"gyro_drift_c1_rad_s", KeyRange::kAny, KeyNeed::kRequired,
               [](Vehicle& v) -> double& { return v.gyro_drift->c1_rad_s; }},
    VehicleKey{"gyro_drift_c2_rad_s", KeyRange::kAny, KeyNeed::kRequired,
               [](Vehicle& v) -> double& { return v.gyro_drift->c2_rad_s; }},
    VehicleKey{"gyro_drift_time_s", KeyRange::kPositive, KeyNeed::kRequired,
               [](Vehicle& v) -> double& { return v.gyro_drift->time_s; }},
};
constexpr std::array kMagnetometerKeys = {
    VehicleKey{"mag_centre_x", KeyRange::kAny, KeyNeed::kRequired,
               [](Vehicle& v) -> double& { return v.magnetometer->centre_x; }},
    VehicleKey{"mag_centre_y", KeyRange::kAny, KeyNeed::kRequired,
               [](Vehicle& v) -> double& { return v.magnetometer->centre_y; }},
    VehicleKey{"mag_range_x", KeyRange::kNotZero, KeyNeed::kRequired,
               [](Vehicle& v) -> double& { return v.magnetometer->range_x; }},
    VehicleKey{"mag_range_y", KeyRange::kNotZero, KeyNeed::kRequired,
               [](Vehicle& v) -> double& { return v.magnetometer->range_y; }},
    VehicleKey{"mag_correlation", KeyRange::kCorrelation, KeyNeed::kOptional,
               [](Vehicle& v) -> double& { return v.magnetometer->correlation; }},
};
constexpr std::array kBiasKeys = {
    VehicleKey{"gyro_bias_rad_s", KeyRange::kAny, KeyNeed::kRequired,
               [](Vehicle& v) -> double& { return *v.gyro_bias_rad_s; }},
};
constexpr std::array kKeyGroups = {
    VehicleKeyGroup{kGyroDriftKeys, [](const Vehicle& v) { return v.gyro_drift.has_value(); },
                    [](Vehicle& v) { v.gyro_drift.emplace(); }},
    VehicleKeyGroup{kMagnetometerKeys, [](const Vehicle& v) { return v.magnetometer.has_value(); },
                    [](Vehicle& v) { v.magnetometer.emplace(); }},
    VehicleKeyGroup{kBiasKeys, [](const Vehicle& v) { return v.gyro_bias_rad_s.has_value(); },
                    [](Vehicle& v) { v.gyro_bias_rad_s.emplace(); }},
};

std::string beyond(double largest) {
    if (largest == VehicleKey::kLargest) return ", nothing is so large in SI units";
    std::string reason = ", no gyro has more than ";
    appendNumber(reason, largest);
    return reason;
}

bool inRange(KeyRange range, double value) {
    switch (range) {
        case KeyRange::kAny:
            return true;
        case KeyRange::kNotNegative:
            return value >= 0.0;
        case KeyRange::kPositive:
            return value > 0.0;
        case KeyRange::kNotZero:
            return value != 0.0;
        case KeyRange::kCorrelation:
            return std::abs(value) < 1.0;
    }
    return false;
}

std::string wantedOf(KeyRange range) {
    switch (range) {
        case KeyRange::kAny:
            break;
        case KeyRange::kNotNegative:
            return ", must not be negative";
        case KeyRange::kPositive:
            return ", must be positive";
        case KeyRange::kNotZero:
            return ", must not be zero";
        case KeyRange::kCorrelation:
            return ", must be between -1 and 1";
    }
    return ", must be a finite number";
}

bool mayBeZero(KeyRange range) {
    return range == KeyRange::kAny || range == KeyRange::kNotNegative ||
           range == KeyRange::kCorrelation;
}

const VehicleKey* keyNamed(std::span<const VehicleKey> keys, std::string_view name) {
    const auto found = std::find_if(keys.begin(), keys.end(),
                                    [&](const VehicleKey& key) { return key.name == name; });
    return found == keys.end() ? nullptr : &*found;
}

}  // namespace

std::span<const VehicleKey> vehicleKeys() { return kNumberKeys; }
std::span<const VehicleKeyGroup> vehicleKeyGroups() { return kKeyGroups; }

std::string complaintAbout(const VehicleKey& key, double value) {
    const double size = std::abs(value);
    const bool in_range = std::isfinite(value) && inRange(key.range, value);
    if (in_range && size <= key.largest && (size >= kSmallest || mayBeZero(key.range))) return {};
    std::string complaint = std::string(key.name) + " is ";
    appendNumber(complaint, value);
    complaint += !std::isfinite(value) ? wantedOf(KeyRange::kAny)
                 : !in_range           ? wantedOf(key.range)
                 : size > key.largest  ? beyond(key.largest)
                                       : ", nothing is so small in SI units";
    return complaint;
}

std::optional<double> vehicleNumber(const Vehicle& vehicle, std::string_view key) {
    Vehicle copy = vehicle;
    if (const VehicleKey* found = keyNamed(kNumberKeys, key)) return found->field(copy);
    for (const VehicleKeyGroup& group : kKeyGroups) {
        const VehicleKey* found = group.given(vehicle) ? keyNamed(group.keys, key) : nullptr;
        if (found) return found->field(copy);
    }
    return std::nullopt;
}

Result<void> setVehicleNumber(Vehicle& vehicle, std::string_view key, double value) {
    Vehicle changed = vehicle;
    const VehicleKey* found = keyNamed(kNumberKeys, key);
    for (const VehicleKeyGroup& group : kKeyGroups) {
        const VehicleKey* member = keyNamed(group.keys, key);
        if (member && !group.given(changed)) group.create(changed);
        if (member) found = member;
    }
    if (!found)
        return fail(ErrorCode::kUnknownName, std::string(key), "no number of a vehicle file");
    const std::string complaint = complaintAbout(*found, value);
    if (!complaint.empty()) return fail(ErrorCode::kBadValue, vehicle.name, complaint);
    found->field(changed) = value;
    vehicle = changed;
    return {};
}

}  // namespace hedr
