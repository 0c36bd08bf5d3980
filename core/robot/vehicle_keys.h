#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/robot/vehicle.h"

namespace hedr {

// A number of the vehicle file.
struct VehicleKey {
    enum class Range { kAny, kNotNegative, kPositive, kNotZero, kCorrelation };
    enum class Need { kRequired, kOptional };
    // No robot has a larger number; squares of it must stay finite.
    static constexpr double kLargest = 1e9;

    std::string_view name;
    Range range;
    Need need;
    double& (*field)(Vehicle&);
    double largest = kLargest;
};

// Numbers that make sense together only; absent until one of them is given.
struct VehicleKeyGroup {
    std::span<const VehicleKey> keys;
    bool (*given)(const Vehicle&);
    void (*create)(Vehicle&);
};

// The one table of numbers: reading, writing and changing go by it.
std::span<const VehicleKey> vehicleKeys();
std::span<const VehicleKeyGroup> vehicleKeyGroups();

// Why the number cannot be that, "wheelbase_m is -0.4, must be positive"; empty where it can.
std::string complaintAbout(const VehicleKey& key, double value);

}  // namespace hedr
