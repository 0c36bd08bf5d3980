#include "core/robot/vehicle_text.h"

#include <algorithm>

#include "core/robot/text_column.h"
#include "core/text/number.h"
#include "core/text/plain_toml.h"

namespace hedr {
namespace {

constexpr double kSlowest_hz = 0.1;
constexpr double kFastest_hz = 10000.0;

tl::unexpected<Error> failAt(const toml::node& node, const std::string& path, std::string detail) {
    return fail(ErrorCode::kBadValue, path + ':' + std::to_string(node.source().begin.line),
                std::move(detail));
}

std::string knownColumns() {
    std::string names;
    for (std::size_t i = 0; i < kTextQuantities; ++i) {
        names.append(textQuantityName(static_cast<TextQuantity>(i))).append(", ");
    }
    return names + "the same in other units (t_ms, gyro_dps, heading_deg), or " +
           std::string(kSkippedColumn) + " for a column to skip";
}

Result<std::vector<std::string>> readColumns(const toml::node& node, const std::string& path) {
    const toml::array* array = node.as_array();
    if (!array || array->empty() || array->size() > kMaxTextColumns) {
        return failAt(
            node, path,
            "columns must be a list of 1 to " + std::to_string(kMaxTextColumns) + " names");
    }
    std::vector<std::string> columns;
    for (const toml::node& each : *array) {
        const auto name = each.value_exact<std::string>();
        if (!name) return failAt(each, path, "a column must be a text");
        if (*name != kSkippedColumn && !textColumn(*name)) {
            return failAt(each, path, "unknown column " + *name + "; known are " + knownColumns());
        }
        columns.push_back(*name);
    }
    return columns;
}

Result<double> readRate(const toml::node& node, const std::string& path) {
    const auto rate = node.is_number() ? node.value<double>() : std::nullopt;
    if (rate && *rate >= kSlowest_hz && *rate <= kFastest_hz) return *rate;
    return failAt(node, path, "rate_hz must be a number from 0.1 to 10000, lines per second");
}

bool holdsTime(const std::vector<std::string>& columns) {
    return std::any_of(columns.begin(), columns.end(), [](const std::string& name) {
        const auto column = textColumn(name);
        return column && column->quantity == TextQuantity::kTime;
    });
}

}  // namespace

Result<TextLineFormat> readTextSection(const toml::node& section, const std::string& path) {
    const toml::table* table = section.as_table();
    if (!table) return failAt(section, path, "text must be a section, [text]");
    TextLineFormat format;
    for (const auto& [key, node] : *table) {
        if (key.str() == "columns") {
            auto columns = readColumns(node, path);
            if (!columns) return tl::make_unexpected(columns.error());
            format.columns = *std::move(columns);
        } else if (key.str() == "rate_hz") {
            const auto rate = readRate(node, path);
            if (!rate) return tl::make_unexpected(rate.error());
            format.rate_hz = *rate;
        } else {
            return failAt(node, path,
                          "unknown key " + std::string(key.str()) +
                              " in [text], which has columns and rate_hz");
        }
    }
    if (!format.columns.empty() && !format.rate_hz && !holdsTime(format.columns)) {
        return failAt(section, path,
                      "no column of [text] is a time: add one such as t_ms, or rate_hz, the lines "
                      "per second");
    }
    return format;
}

std::string formatTextSection(const TextLineFormat& format) {
    std::string text = "[text]\n";
    if (!format.columns.empty()) {
        text += "columns = [";
        for (const std::string& column : format.columns) {
            text += (text.back() == '[' ? "" : ", ") + quotedToml(column);
        }
        text += "]\n";
    }
    if (format.rate_hz) {
        text += "rate_hz = ";
        appendNumber(text, *format.rate_hz);
        text += '\n';
    }
    return text;
}

}  // namespace hedr
