#include "core/text/csv.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

#include "core/text/number.h"
#include "core/text/text_file.h"
#include "core/text/trimmed.h"

namespace hedr {
namespace {

void split(std::string_view line, std::vector<std::string_view>& fields) {
    fields.clear();
    for (std::size_t begin = 0;;) {
        const std::size_t comma = line.find(',', begin);
        fields.push_back(trimmed(line.substr(begin, comma - begin)));
        if (comma == std::string_view::npos) return;
        begin = comma + 1;
    }
}

bool isPrintable(std::string_view line) {
    return std::none_of(line.begin(), line.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return (byte < 0x20 && c != '\t') || byte == 0x7F;
    });
}

// Quotes a field for a message, cut to a length that a sentence bears.
std::string inQuotes(std::string_view field) {
    constexpr std::size_t kLongest = 40;
    if (!isPrintable(field)) return "unprintable bytes";
    if (field.size() <= kLongest) return '"' + std::string(field) + '"';
    return '"' + std::string(field.substr(0, kLongest)) + "...\"";
}

bool isAbsent(std::string_view field) {
    return field.empty() || field == "nan" || field == "NaN" || field == "NAN";
}

}  // namespace

Result<CsvReader> CsvReader::open(std::string_view text, std::string path) {
    text = withoutByteOrderMark(text);
    CsvReader reader(text, std::move(path));
    // Images, archives and databases all have zero bytes near their beginning.
    if (text.substr(0, 4096).find('\0') != std::string_view::npos)
        return fail(ErrorCode::kBadFormat, reader.path_, "this is not a text file");
    std::string_view header;
    if (!reader.nextLine(header)) return fail(ErrorCode::kFileEmpty, reader.path_);
    if (!isPrintable(header))
        return fail(ErrorCode::kBadFormat, reader.where(), "this is not a text file");
    split(header, reader.fields_);
    reader.columns_.assign(reader.fields_.begin(), reader.fields_.end());
    std::unordered_set<std::string_view> seen;
    for (const std::string& name : reader.columns_) {
        if (!name.empty() && !seen.insert(name).second)
            return fail(ErrorCode::kBadFormat, reader.where(),
                        "column " + inQuotes(name) + " twice");
    }
    return reader;
}

std::optional<std::size_t> CsvReader::find(std::string_view column) const {
    const auto it = std::find(columns_.begin(), columns_.end(), column);
    if (it == columns_.end()) return std::nullopt;
    return static_cast<std::size_t>(it - columns_.begin());
}

Result<std::size_t> CsvReader::require(std::string_view column) const {
    if (const auto index = find(column)) return *index;
    return fail(ErrorCode::kMissingColumn, path_, std::string(column));
}

bool CsvReader::nextLine(std::string_view& line) {
    while (!rest_.empty()) {
        const std::size_t end = rest_.find('\n');
        line = trimmed(rest_.substr(0, end));
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        ++line_number_;
        if (!line.empty() && line.front() != '#') return true;
    }
    return false;
}

Result<bool> CsvReader::next() {
    std::string_view line;
    if (!nextLine(line)) return false;
    split(line, fields_);
    if (fields_.size() == columns_.size()) return true;
    return fail(
        ErrorCode::kBadFormat, where(),
        "the row has " + std::to_string(fields_.size()) + " fields, the header has " +
            std::to_string(columns_.size()) +
            (fields_.size() < columns_.size() ? ", " + columns_[fields_.size()] + " is missing"
                                              : std::string()));
}

std::string CsvReader::where() const { return path_ + ':' + std::to_string(line_number_); }

tl::unexpected<Error> CsvReader::badField(std::size_t column, const char* wanted) const {
    const std::string_view field = fields_[column];
    return fail(ErrorCode::kBadFormat, where(),
                columns_[column] + " is " + (field.empty() ? "empty" : inQuotes(field)) +
                    ", must be " + wanted);
}

Result<double> CsvReader::number(std::size_t column) const {
    const auto value = parseNumber(fields_[column]);
    if (!value || !std::isfinite(*value)) return badField(column, "a number");
    return *value;
}

Result<double> CsvReader::numberOrNan(std::size_t column) const {
    if (isAbsent(fields_[column])) return std::numeric_limits<double>::quiet_NaN();
    return number(column);
}

Result<std::optional<std::int64_t>> CsvReader::integer(std::size_t column) const {
    constexpr double kExactWithin = 9007199254740992.0;  // 2^53
    const std::string_view field = fields_[column];
    if (isAbsent(field)) return std::optional<std::int64_t>();
    if (const auto value = parseInteger(field)) return value;
    // Spreadsheets write whole numbers as 12.0 or 1e3.
    const auto value = parseNumber(field);
    if (value && std::abs(*value) <= kExactWithin && *value == std::trunc(*value))
        return static_cast<std::int64_t>(*value);
    return badField(column, "a whole number");
}

}  // namespace hedr
