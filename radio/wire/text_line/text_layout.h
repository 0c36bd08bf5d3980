#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/robot/text_column.h"

namespace hedr {

// What the columns of a line hold. Of two columns of one kind the first counts; of two times the
// one with a unit.
struct TextLayout {
    std::array<std::optional<TextColumn>, kMaxTextColumns> columns{};
    std::size_t size = 0;

    const TextColumn* find(TextQuantity quantity) const;
    bool has(TextQuantity quantity) const { return find(quantity) != nullptr; }
    bool hasGyro() const;
    bool hasPose() const;
    bool hasMagnetometer() const;
    // Something that tells how the robot moves.
    bool hasMotion() const;
    friend bool operator==(const TextLayout&, const TextLayout&) = default;
};

// Names that are not known are columns that are not read.
TextLayout layoutOf(std::span<const std::string_view> names);
TextLayout layoutOf(std::span<const std::string> names);

// One line's values in SI units. A time without a unit is as printed.
struct TextSample {
    std::array<std::optional<double>, kTextQuantities> values{};
    bool time_has_point = false;
    std::optional<double> operator[](TextQuantity quantity) const {
        return values[static_cast<std::size_t>(quantity)];
    }
};

// None where a column that is read is no number: a word, NaN, hexadecimal, too large, a count that
// is not whole. PLX-DAQ's words for the clock of the PC are no time of the robot's, and no error.
std::optional<TextSample> readSample(const TextLayout& layout,
                                     std::span<const std::string_view> fields);

// For the operator: what is read, and how it is turned into SI. `bare_time_s` is what one of a time
// without a unit is.
std::string describe(const TextLayout& layout, double bare_time_s);

}  // namespace hedr
