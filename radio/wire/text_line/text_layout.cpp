#include "radio/wire/text_line/text_layout.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/text/number.h"
#include "radio/wire/text_line/text_fields.h"

namespace hedr {
namespace {

using enum TextQuantity;

constexpr double kLargest = 9007199254740992.0;  // 2^53: a double counts no further

bool isPcClock(std::string_view field) {
    return isWord(field, "DATE") || isWord(field, "TIME") || isWord(field, "TIMER");
}

// Takes out the columns that say again what another says.
void keepOnePerQuantity(TextLayout& layout) {
    std::array<std::optional<TextColumn>*, kTextQuantities> kept{};
    for (std::optional<TextColumn>& column : std::span(layout.columns).first(layout.size)) {
        if (!column) continue;
        auto*& first = kept[static_cast<std::size_t>(column->quantity)];
        const bool better =
            first && column->quantity == kTime && column->has_unit && !(*first)->has_unit;
        if (better) first->reset();
        if (!first || better) {
            first = &column;
        } else {
            column.reset();
        }
    }
}

template <class Names>
TextLayout makeLayout(const Names& names) {
    assert(names.size() <= kMaxTextColumns);
    TextLayout layout;
    for (const std::string_view name : names) layout.columns[layout.size++] = textColumn(name);
    keepOnePerQuantity(layout);
    return layout;
}

std::optional<double> readValue(const TextColumn& column, std::string_view field) {
    const auto number = parseNumber(field);
    if (!number || !(std::abs(*number) <= kLargest)) return std::nullopt;
    const bool counts = column.quantity == kLeftTicks || column.quantity == kRightTicks;
    if (counts && *number != std::floor(*number)) return std::nullopt;
    return *number * column.scale;
}

}  // namespace

const TextColumn* TextLayout::find(TextQuantity quantity) const {
    for (const auto& column : std::span(columns).first(size)) {
        if (column && column->quantity == quantity) return &*column;
    }
    return nullptr;
}

bool TextLayout::hasPose() const { return has(kX) && has(kY) && has(kHeading); }

bool TextLayout::hasGyro() const { return has(kYawRate) || (has(kHeading) && !hasPose()); }

bool TextLayout::hasMagnetometer() const { return has(kMagX) && has(kMagY) && has(kMagZ); }

bool TextLayout::hasMotion() const {
    return (has(kLeftTicks) && has(kRightTicks)) || (has(kLeftTravel) && has(kRightTravel)) ||
           has(kDistance) || hasPose() || hasGyro();
}

TextLayout layoutOf(std::span<const std::string_view> names) { return makeLayout(names); }
TextLayout layoutOf(std::span<const std::string> names) { return makeLayout(names); }

std::optional<TextSample> readSample(const TextLayout& layout,
                                     std::span<const std::string_view> fields) {
    if (fields.size() != layout.size) return std::nullopt;
    TextSample sample;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const auto& column = layout.columns[i];
        if (!column || (column->quantity == kTime && isPcClock(fields[i]))) continue;
        const auto value = readValue(*column, fields[i]);
        if (!value) return std::nullopt;
        sample.values[static_cast<std::size_t>(column->quantity)] = value;
        if (column->quantity == kTime) {
            sample.time_has_point = fields[i].find('.') != std::string_view::npos;
        }
    }
    return sample;
}

std::string describe(const TextLayout& layout, double bare_time_s) {
    std::string text = "text lines, read as";
    for (const auto& column : std::span(layout.columns).first(layout.size)) {
        if (!column) continue;
        text.append(text.ends_with("as") ? " " : ", ").append(textQuantityName(column->quantity));
        const bool bare_time = column->quantity == kTime && !column->has_unit;
        const double scale = bare_time ? bare_time_s : column->scale;
        if (scale == 1.0) continue;
        text += " x ";
        appendNumber(text, std::round(scale * 1e6) / 1e6);
    }
    return text;
}

}  // namespace hedr
