#include "core/calibration/compass/magnetometer_readings.h"

#include <algorithm>
#include <cmath>

#include "core/calibration/short_number.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr std::size_t kFewestFields = 50;
constexpr double kMostBrokenFieldShare = 0.1;
// At the end of a circle's reach the outermost step of a coarse sensor holds up to 2.4 times as
// many readings as the next one: acos(1 - q) over acos(1 - 2 q) - acos(1 - q) for small q.
constexpr double kSaturatedTimes = 5.0;
constexpr double kFewestSaturated = 10.0;
constexpr double kSaturatedShare = 0.02;

bool allAreEqual(std::span<const MagneticLog> logs) {
    const Eigen::Vector3d* first = nullptr;
    for (const MagneticLog& log : logs) {
        for (const MagneticSample& sample : log.samples) {
            if (!first) first = &sample.field;
            if (sample.field.head<2>() != first->head<2>()) return false;
        }
    }
    return true;
}

// How often the largest of them is there, and the one before it.
struct LargestTwo {
    double largest = 0.0;
    double next = 0.0;
};

LargestTwo largestTwoOf(std::vector<double> values) {
    std::sort(values.begin(), values.end(), std::greater<>());
    LargestTwo counts;
    const auto second = std::find_if(values.begin(), values.end(),
                                     [&](double value) { return value != values.front(); });
    counts.largest = static_cast<double>(second - values.begin());
    if (second != values.end())
        counts.next = static_cast<double>(std::count(second, values.end(), *second));
    return counts;
}

bool isSaturated(const MagneticTurns& turns, Eigen::Index axis, double sign) {
    std::vector<double> values;
    values.reserve(turns.samples.size());
    for (const MagneticSample& sample : turns.samples) values.push_back(sign * sample.field(axis));
    const double fewest =
        std::max(kFewestSaturated, kSaturatedShare * static_cast<double>(values.size()));
    const LargestTwo counts = largestTwoOf(std::move(values));
    return counts.largest >= fewest && counts.largest > kSaturatedTimes * counts.next;
}

}  // namespace

std::string complaintAboutReadings(std::span<const MagneticLog> logs) {
    std::size_t good = 0;
    std::size_t broken = 0;
    for (const MagneticLog& log : logs) {
        good += log.samples.size();
        broken += log.broken;
    }
    const auto all = static_cast<double>(good + broken);
    if (good + broken == 0)
        return "No magnetometer readings came. Check that the robot sends them.";
    if (static_cast<double>(broken) > kMostBrokenFieldShare * all) {
        return std::to_string(broken) + " of " + std::to_string(good + broken) +
               " magnetometer readings are no numbers or have no time. Check the magnetometer and "
               "its wiring.";
    }
    if (good < kFewestFields) {
        return "There are " + std::to_string(good) +
               " magnetometer readings only. Turn the robot on the spot while it reports.";
    }
    if (allAreEqual(logs)) {
        return "All magnetometer readings are equal. Check the magnetometer and its wiring.";
    }
    const bool disagree = std::any_of(logs.begin(), logs.end(),
                                      [](const MagneticLog& log) { return log.judges_disagree; });
    if (disagree) {
        return "Gyro and encoders turn opposite ways. Check the encoders and the sign of the gyro "
               "first.";
    }
    return {};
}

std::string complaintAboutSaturation(const MagneticTurns& turns) {
    constexpr const char* kComplaints[] = {
        "The magnetometer's x is at the end of its range. Move it away from iron and magnets of "
        "the robot, or give it a wider range.",
        "The magnetometer's y is at the end of its range. Move it away from iron and magnets of "
        "the robot, or give it a wider range."};
    for (const Eigen::Index axis : {0, 1}) {
        if (isSaturated(turns, axis, 1.0) || isSaturated(turns, axis, -1.0))
            return kComplaints[axis];
    }
    return {};
}

std::vector<Eigen::Vector3d> allFieldsOf(std::span<const MagneticLog> logs) {
    std::vector<Eigen::Vector3d> fields;
    for (const MagneticLog& log : logs) {
        for (const MagneticSample& sample : log.samples) fields.push_back(sample.field);
    }
    return fields;
}

std::string wholeDegreesText(double angle_rad) {
    const double degrees = degFromRad(angle_rad);
    return shortNumber(degrees, degrees < 10.0 ? 2 : 3) + "°";
}

}  // namespace hedr
