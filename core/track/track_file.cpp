#include "core/track/track_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "core/geometry/angle.h"
#include "core/text/csv.h"
#include "core/text/number.h"
#include "core/text/text_file.h"

namespace hedr {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Adds full turns so that the heading never jumps by more than half a turn. A heading that does
// not jump keeps its bits.
void unwrapHeadings(std::vector<TrackPoint>& track) {
    double turns = 0.0;
    double last = kNan;
    for (TrackPoint& point : track) {
        double& heading = point.pose.heading_rad;
        if (std::isnan(heading)) continue;
        const double step = heading - last;
        if (std::abs(step) > kPi) turns -= std::round(step / (2.0 * kPi));
        last = heading;
        if (turns != 0.0) heading += 2.0 * kPi * turns;
    }
}

constexpr std::array kVarianceColumns = {"var_x_m2", "cov_xy_m2", "var_y_m2", "var_heading_rad2"};
using VarianceColumns = std::array<std::size_t, kVarianceColumns.size()>;

// None unless all of them are there.
std::optional<VarianceColumns> findVariance(const CsvReader& csv) {
    VarianceColumns columns{};
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const auto column = csv.find(kVarianceColumns[i]);
        if (!column) return std::nullopt;
        columns[i] = *column;
    }
    return columns;
}

// Not known where a field is empty.
Result<PoseVariance> readVariance(const CsvReader& csv, const VarianceColumns& columns) {
    std::array<float, kVarianceColumns.size()> values{};
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const auto value = csv.numberOrNan(columns[i]);
        if (!value) return tl::make_unexpected(value.error());
        if (std::isnan(*value)) return PoseVariance{};
        values[i] = static_cast<float>(*value);
    }
    return PoseVariance{values[0], values[1], values[2], values[3]};
}

Result<std::vector<TrackPoint>> parseCsv(std::string_view text, const std::string& path) {
    auto csv = CsvReader::open(text, path);
    if (!csv) return tl::make_unexpected(csv.error());
    std::array<std::size_t, 3> columns{};
    constexpr std::array kNeeded = {"t_s", "x_m", "y_m"};
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const auto column = csv->require(kNeeded[i]);
        if (!column) return tl::make_unexpected(column.error());
        columns[i] = *column;
    }
    const auto heading_column = csv->find("heading_rad");
    const auto bias_column = csv->find("gyro_bias_rad_s");
    const auto variance_columns = findVariance(*csv);

    std::vector<TrackPoint> track;
    track.reserve(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1);
    for (;;) {
        const auto more = csv->next();
        if (!more) return tl::make_unexpected(more.error());
        if (!*more) return track;
        const std::array<Result<double>, 5> values = {
            csv->number(columns[0]), csv->number(columns[1]), csv->number(columns[2]),
            heading_column ? csv->numberOrNan(*heading_column) : kNan,
            bias_column ? csv->numberOrNan(*bias_column) : 0.0};
        for (const auto& value : values)
            if (!value) return tl::make_unexpected(value.error());
        const double bias = std::isnan(*values[4]) ? 0.0 : *values[4];
        track.push_back({*values[0], {{*values[1], *values[2]}, *values[3]}, bias});
        if (!variance_columns) continue;
        const auto variance = readVariance(*csv, *variance_columns);
        if (!variance) return tl::make_unexpected(variance.error());
        track.back().variance = *variance;
    }
}

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

void skipBlanks(std::string_view& text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
}

// Up to the next blank.
std::string_view takeWord(std::string_view& text) {
    const auto end = std::find_if(text.begin(), text.end(), isBlank);
    const auto word = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(word.size());
    return word;
}

std::string_view takeLine(std::string_view& text) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    skipBlanks(line);
    while (!line.empty() && isBlank(line.back())) line.remove_suffix(1);
    return line;
}

bool isCommentOrBlank(std::string_view line) { return line.empty() || line.front() == '#'; }

// t x y z qx qy qz qw, parted by blanks.
std::optional<std::array<double, 8>> parseTumLine(std::string_view line) {
    std::array<double, 8> values{};
    for (double& value : values) {
        const auto number = parseNumber(takeWord(line));
        if (!number || !std::isfinite(*number)) return std::nullopt;
        value = *number;
        skipBlanks(line);
    }
    return line.empty() ? std::make_optional(values) : std::nullopt;
}

// Yaw; NaN where the quaternion is zero, which stands for "no heading".
double headingOfQuaternion(double x, double y, double z, double w) {
    if (x == 0.0 && y == 0.0 && z == 0.0 && w == 0.0) return kNan;
    return std::atan2(2.0 * (w * z + x * y), w * w + x * x - y * y - z * z);
}

Result<std::vector<TrackPoint>> parseTum(std::string_view text, const std::string& path) {
    std::vector<TrackPoint> track;
    track.reserve(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1);
    for (std::size_t line_number = 1; !text.empty(); ++line_number) {
        const std::string_view line = takeLine(text);
        if (isCommentOrBlank(line)) continue;
        const auto v = parseTumLine(line);
        if (!v)
            return fail(ErrorCode::kBadFormat, path + ':' + std::to_string(line_number),
                        "a TUM line has eight numbers: t x y z qx qy qz qw");
        const double heading = headingOfQuaternion((*v)[4], (*v)[5], (*v)[6], (*v)[7]);
        track.push_back({(*v)[0], {{(*v)[1], (*v)[2]}, heading}, 0.0});
    }
    return track;
}

// A CSV has a comma in its first line, a TUM file has none.
bool isCsv(std::string_view text) {
    while (!text.empty()) {
        const std::string_view line = takeLine(text);
        if (!isCommentOrBlank(line)) return line.find(',') != std::string_view::npos;
    }
    return true;
}

void appendRow(std::string& text, char separator, std::initializer_list<double> values) {
    for (const double value : values) {
        appendNumber(text, value);
        text += separator;
    }
    text.back() = '\n';
}

void appendVariance(std::string& text, const PoseVariance& variance) {
    if (variance.known()) {
        appendRow(text, ',',
                  {static_cast<double>(variance.var_x_m2), static_cast<double>(variance.cov_xy_m2),
                   static_cast<double>(variance.var_y_m2),
                   static_cast<double>(variance.var_heading_rad2)});
    } else {
        text += ",,,\n";
    }
}

std::string formatCsv(const std::vector<TrackPoint>& track) {
    const bool with_variance = std::any_of(track.begin(), track.end(),
                                           [](const TrackPoint& p) { return p.variance.known(); });
    const bool with_bias = std::any_of(
        track.begin(), track.end(), [](const TrackPoint& p) { return p.gyro_bias_rad_s != 0.0; });
    std::string text = "t_s,x_m,y_m,heading_rad";
    if (with_variance)
        for (const char* name : kVarianceColumns) text.append(",").append(name);
    text += with_bias ? ",gyro_bias_rad_s\n" : "\n";
    for (const TrackPoint& point : track) {
        const auto& [position, heading_rad] = point.pose;
        appendRow(text, ',', {point.t_s, position.x, position.y, heading_rad});
        if (with_variance) {
            text.back() = ',';
            appendVariance(text, point.variance);
        }
        if (!with_bias) continue;
        text.back() = ',';
        appendRow(text, ',', {point.gyro_bias_rad_s});
    }
    return text;
}

std::string formatTum(const std::vector<TrackPoint>& track) {
    std::string text;
    for (const TrackPoint& point : track) {
        const auto& [position, heading_rad] = point.pose;
        const bool known = !std::isnan(heading_rad);
        appendRow(
            text, ' ',
            {point.t_s, position.x, position.y, 0.0, 0.0, 0.0,
             known ? std::sin(heading_rad / 2.0) : 0.0, known ? std::cos(heading_rad / 2.0) : 0.0});
    }
    return text;
}

}  // namespace

Result<std::vector<TrackPoint>> loadTrack(const std::filesystem::path& file) {
    const auto text = readTextFile(file);
    if (!text) return tl::make_unexpected(text.error());
    const std::string_view rows = withoutByteOrderMark(*text);
    auto track = isCsv(rows) ? parseCsv(rows, file.string()) : parseTum(rows, file.string());
    if (!track) return track;
    if (track->empty()) return fail(ErrorCode::kFileEmpty, file.string(), "it has no poses");
    unwrapHeadings(*track);
    return track;
}

Result<void> saveTrack(const std::filesystem::path& file, const std::vector<TrackPoint>& track) {
    const auto extension = file.extension();
    const bool tum = extension == ".tum" || extension == ".txt";
    return writeTextFile(file, tum ? formatTum(track) : formatCsv(track));
}

}  // namespace hedr
