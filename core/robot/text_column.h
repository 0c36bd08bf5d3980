#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace hedr {

// What a column of a robot's text lines holds. Units are those of report.h.
enum class TextQuantity : unsigned char {
    kTime,
    kLeftTicks,
    kRightTicks,
    kLeftTravel,
    kRightTravel,
    kDistance,
    kYawRate,
    kHeading,
    kX,
    kY,
    kMagX,
    kMagY,
    kMagZ,
    kTemperature,
    kBattery,
};
inline constexpr std::size_t kTextQuantities = 15;

// No robot prints more; what comes after them is not read.
inline constexpr std::size_t kMaxTextColumns = 32;

// A column that is there but not read, in a vehicle file.
inline constexpr std::string_view kSkippedColumn = "-";

struct TextColumn {
    TextQuantity quantity = TextQuantity::kTime;
    double scale = 1.0;     // SI value per printed value; negative where clockwise is positive
    bool has_unit = false;  // in the name; a name without one means SI, counts for a wheel
    friend bool operator==(const TextColumn&, const TextColumn&) = default;
};

// What a name such as "left_ticks", "encL", "gz [deg/s]", "t_ms" or "heading_cw_deg" means; letter
// case and separators do not matter. None for a name that is not known. docs/text_robots.md has
// the table.
std::optional<TextColumn> textColumn(std::string_view name);

// The name that this quantity has in a sensors.csv, with its unit.
std::string_view textQuantityName(TextQuantity quantity);

}  // namespace hedr
