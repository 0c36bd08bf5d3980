#include "core/robot/text_column.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

enum class Dimension { kTime, kCount, kLength, kRate, kAngle, kField, kTemperature, kVoltage };

struct Unit {
    std::string_view name;  // letters only, "deg/s" as "degs"
    Dimension dimension;
    double si = 1.0;
};

// Longer names before those that they end with.
constexpr std::array kUnits = {
    Unit{"seconds", Dimension::kTime},
    Unit{"millis", Dimension::kTime, 1e-3},
    Unit{"micros", Dimension::kTime, 1e-6},
    Unit{"sec", Dimension::kTime},
    Unit{"ms", Dimension::kTime, 1e-3},
    Unit{"us", Dimension::kTime, 1e-6},
    Unit{"s", Dimension::kTime},
    Unit{"ticks", Dimension::kCount},
    Unit{"counts", Dimension::kCount},
    Unit{"count", Dimension::kCount},
    Unit{"pulses", Dimension::kCount},
    Unit{"mm", Dimension::kLength, 1e-3},
    Unit{"cm", Dimension::kLength, 1e-2},
    Unit{"m", Dimension::kLength},
    Unit{"mrads", Dimension::kRate, 1e-3},
    Unit{"rads", Dimension::kRate},
    Unit{"mdps", Dimension::kRate, 1e-3 * radFromDeg(1.0)},
    Unit{"dps", Dimension::kRate, radFromDeg(1.0)},
    Unit{"degs", Dimension::kRate, radFromDeg(1.0)},
    Unit{"mrad", Dimension::kAngle, 1e-3},
    Unit{"rad", Dimension::kAngle},
    Unit{"degrees", Dimension::kAngle, radFromDeg(1.0)},
    Unit{"deg", Dimension::kAngle, radFromDeg(1.0)},
    Unit{"degc", Dimension::kTemperature},
    Unit{"celsius", Dimension::kTemperature},
    Unit{"c", Dimension::kTemperature},
    Unit{"mv", Dimension::kVoltage, 1e-3},
    Unit{"volts", Dimension::kVoltage},
    Unit{"v", Dimension::kVoltage},
    Unit{"ut", Dimension::kField},
    Unit{"gauss", Dimension::kField},
};

struct Name {
    std::string_view name;  // letters only
    TextQuantity quantity;
    Dimension dimension;
    double scale = 1.0;
    bool has_unit = false;
};

using enum TextQuantity;

constexpr std::array kNames = {
    Name{"t", kTime, Dimension::kTime},
    Name{"time", kTime, Dimension::kTime},
    Name{"timer", kTime, Dimension::kTime},
    Name{"timestamp", kTime, Dimension::kTime},
    Name{"seconds", kTime, Dimension::kTime, 1.0, true},
    Name{"sec", kTime, Dimension::kTime, 1.0, true},
    Name{"millis", kTime, Dimension::kTime, 1e-3, true},
    Name{"ms", kTime, Dimension::kTime, 1e-3, true},
    Name{"micros", kTime, Dimension::kTime, 1e-6, true},
    Name{"us", kTime, Dimension::kTime, 1e-6, true},
    Name{"left", kLeftTicks, Dimension::kCount},
    Name{"l", kLeftTicks, Dimension::kCount},
    Name{"encl", kLeftTicks, Dimension::kCount},
    Name{"lenc", kLeftTicks, Dimension::kCount},
    Name{"encleft", kLeftTicks, Dimension::kCount},
    Name{"leftenc", kLeftTicks, Dimension::kCount},
    Name{"encoderleft", kLeftTicks, Dimension::kCount},
    Name{"leftencoder", kLeftTicks, Dimension::kCount},
    Name{"right", kRightTicks, Dimension::kCount},
    Name{"r", kRightTicks, Dimension::kCount},
    Name{"encr", kRightTicks, Dimension::kCount},
    Name{"renc", kRightTicks, Dimension::kCount},
    Name{"encright", kRightTicks, Dimension::kCount},
    Name{"rightenc", kRightTicks, Dimension::kCount},
    Name{"encoderright", kRightTicks, Dimension::kCount},
    Name{"rightencoder", kRightTicks, Dimension::kCount},
    Name{"left", kLeftTravel, Dimension::kLength},
    Name{"right", kRightTravel, Dimension::kLength},
    Name{"dist", kDistance, Dimension::kLength},
    Name{"distance", kDistance, Dimension::kLength},
    Name{"travel", kDistance, Dimension::kLength},
    Name{"gyro", kYawRate, Dimension::kRate},
    Name{"gyroz", kYawRate, Dimension::kRate},
    Name{"gz", kYawRate, Dimension::kRate},
    Name{"yawrate", kYawRate, Dimension::kRate},
    Name{"turnrate", kYawRate, Dimension::kRate},
    Name{"heading", kHeading, Dimension::kAngle},
    Name{"yaw", kHeading, Dimension::kAngle},
    Name{"theta", kHeading, Dimension::kAngle},
    Name{"odoheading", kHeading, Dimension::kAngle},
    Name{"compass", kHeading, Dimension::kAngle, -1.0},
    Name{"x", kX, Dimension::kLength},
    Name{"odox", kX, Dimension::kLength},
    Name{"posx", kX, Dimension::kLength},
    Name{"y", kY, Dimension::kLength},
    Name{"odoy", kY, Dimension::kLength},
    Name{"posy", kY, Dimension::kLength},
    Name{"magx", kMagX, Dimension::kField},
    Name{"mx", kMagX, Dimension::kField},
    Name{"magy", kMagY, Dimension::kField},
    Name{"my", kMagY, Dimension::kField},
    Name{"magz", kMagZ, Dimension::kField},
    Name{"mz", kMagZ, Dimension::kField},
    Name{"temp", kTemperature, Dimension::kTemperature},
    Name{"temperature", kTemperature, Dimension::kTemperature},
    Name{"battery", kBattery, Dimension::kVoltage},
    Name{"bat", kBattery, Dimension::kVoltage},
    Name{"vbat", kBattery, Dimension::kVoltage},
    Name{"vbatt", kBattery, Dimension::kVoltage},
    Name{"voltage", kBattery, Dimension::kVoltage},
};

// "gz [°/s]" as "gzdegs".
std::string lettersOf(std::string_view name) {
    constexpr std::string_view kDegree = "\u00B0";
    constexpr std::string_view kMicro = "\u00B5";
    constexpr std::string_view kGreekMu = "\u03BC";
    std::string letters;
    while (!name.empty()) {
        const char c = name.front();
        std::size_t size = 1;
        if (name.starts_with(kDegree)) {
            letters += "deg";
            size = kDegree.size();
        } else if (name.starts_with(kMicro) || name.starts_with(kGreekMu)) {
            letters += 'u';
            size = kMicro.size();
        } else if (c >= 'A' && c <= 'Z') {
            letters += static_cast<char>(c - 'A' + 'a');
        } else if (std::string_view(" _-./[]()").find(c) == std::string_view::npos) {
            letters += c;
        }
        name.remove_prefix(size);
    }
    return letters;
}

// Takes "cw" or "ccw" off the end; -1 where clockwise is positive.
double takeSense(std::string_view& name) {
    for (const auto& [suffix, sense] : {std::pair{std::string_view("ccw"), 1.0}, {"cw", -1.0}}) {
        if (!name.ends_with(suffix)) continue;
        name.remove_suffix(suffix.size());
        return sense;
    }
    return 1.0;
}

std::optional<TextColumn> named(std::string_view name, const Unit* unit) {
    std::string_view plain = name;
    const double sense = takeSense(plain);
    for (const Name& known : kNames) {
        const bool turns =
            known.dimension == Dimension::kRate || known.dimension == Dimension::kAngle;
        if (known.name != (turns ? plain : name)) continue;
        if (unit && (known.dimension != unit->dimension || known.has_unit)) continue;
        return TextColumn{.quantity = known.quantity,
                          .scale = known.scale * (unit ? unit->si : 1.0) * (turns ? sense : 1.0),
                          .has_unit = unit || known.has_unit};
    }
    return std::nullopt;
}

}  // namespace

std::optional<TextColumn> textColumn(std::string_view name) {
    constexpr std::size_t kLongestName = 48;
    if (name.size() > kLongestName) return std::nullopt;
    const std::string letters = lettersOf(name);
    if (const auto column = named(letters, nullptr)) return column;
    for (const Unit& unit : kUnits) {
        if (!letters.ends_with(unit.name)) continue;
        const auto rest = std::string_view(letters).substr(0, letters.size() - unit.name.size());
        if (const auto column = named(rest, &unit)) return column;
    }
    return std::nullopt;
}

std::string_view textQuantityName(TextQuantity quantity) {
    constexpr std::array<std::string_view, kTextQuantities> kOwnNames = {
        "t_s",    "left_ticks",   "right_ticks",     "left_m",        "right_m",
        "dist_m", "gyro_z_rad_s", "odo_heading_rad", "odo_x_m",       "odo_y_m",
        "mag_x",  "mag_y",        "mag_z",           "temperature_c", "battery_v"};
    return kOwnNames[static_cast<std::size_t>(quantity)];
}

}  // namespace hedr
