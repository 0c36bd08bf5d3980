#include "core/robot/sensor_csv.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text/csv.h"
#include "core/text/text_file.h"

namespace hedr {
namespace {

using Column = std::size_t;

enum class OdometryKind { kNone, kTicks, kTravel, kPose, kPath };

struct OdometryColumns {
    OdometryKind kind = OdometryKind::kNone;
    std::array<Column, 3> columns{};
};

struct Layout {
    Column time = 0;
    OdometryColumns odometry{};
    std::optional<Column> gyro{};
    std::optional<Column> temperature{};
    std::optional<std::array<Column, 3>> magnetic_field{};
};

struct OdometryNames {
    OdometryKind kind;
    std::vector<std::string_view> names;
};

// The kind that says most comes first. A pose goes before plain distance because it has a heading.
const std::vector<OdometryNames>& odometryKinds() {
    static const std::vector<OdometryNames> kinds = {
        {OdometryKind::kTicks, {"left_ticks", "right_ticks"}},
        {OdometryKind::kTravel, {"left_m", "right_m"}},
        {OdometryKind::kPose, {"odo_x_m", "odo_y_m", "odo_heading_rad"}},
        {OdometryKind::kPath, {"dist_m"}},
    };
    return kinds;
}

// All of the columns `names`, where at least one of them is there; half a group is an error.
Result<std::optional<std::array<Column, 3>>> findGroup(const CsvReader& csv,
                                                       const std::vector<std::string_view>& names) {
    std::array<Column, 3> columns{};
    const auto present = [&csv](std::string_view name) { return csv.find(name).has_value(); };
    if (std::none_of(names.begin(), names.end(), present))
        return std::optional<std::array<Column, 3>>();
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto column = csv.require(names[i]);
        if (!column) return tl::make_unexpected(column.error());
        columns[i] = *column;
    }
    return columns;
}

Result<OdometryColumns> findOdometry(const CsvReader& csv) {
    for (const auto& [kind, names] : odometryKinds()) {
        const auto columns = findGroup(csv, names);
        if (!columns) return tl::make_unexpected(columns.error());
        if (*columns) return OdometryColumns{kind, **columns};
    }
    return OdometryColumns{};
}

Result<Layout> findLayout(const CsvReader& csv, const std::string& path,
                          const std::string& gyro_column) {
    Layout layout;
    const auto time = csv.require("t_s");
    if (!time) return tl::make_unexpected(time.error());
    layout.time = *time;
    const auto odometry = findOdometry(csv);
    if (!odometry) return tl::make_unexpected(odometry.error());
    layout.odometry = *odometry;
    layout.gyro = csv.find(gyro_column);
    layout.temperature = csv.find("temperature_c");
    const auto field = findGroup(csv, {"mag_x", "mag_y", "mag_z"});
    if (!field) return tl::make_unexpected(field.error());
    layout.magnetic_field = *field;
    if (layout.odometry.kind == OdometryKind::kNone && !layout.gyro && !layout.magnetic_field)
        return fail(ErrorCode::kMissingColumn, path,
                    gyro_column +
                        ", or odometry: left_ticks and right_ticks, left_m and right_m, odo_x_m, "
                        "odo_y_m and odo_heading_rad, or dist_m");
    return layout;
}

bool isKnown(const std::string& column, const std::string& gyro_column) {
    static constexpr std::array<std::string_view, 5> kKnown = {"t_s", "temperature_c", "mag_x",
                                                               "mag_y", "mag_z"};
    if (column == gyro_column) return true;
    if (std::find(kKnown.begin(), kKnown.end(), column) != kKnown.end()) return true;
    return std::any_of(odometryKinds().begin(), odometryKinds().end(), [&](const auto& kind) {
        return std::find(kind.names.begin(), kind.names.end(), column) != kind.names.end();
    });
}

// Up to three numbers; nothing where one of them is absent in this row.
Result<std::optional<std::array<double, 3>>> readNumbers(const CsvReader& csv,
                                                         const std::array<Column, 3>& columns,
                                                         std::size_t count) {
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < count; ++i) {
        const auto value = csv.numberOrNan(columns[i]);
        if (!value) return tl::make_unexpected(value.error());
        if (std::isnan(*value)) return std::optional<std::array<double, 3>>();
        values[i] = *value;
    }
    return values;
}

Result<Odometry> readTicks(const CsvReader& csv, const std::array<Column, 3>& columns) {
    const auto left = csv.integer(columns[0]);
    if (!left) return tl::make_unexpected(left.error());
    const auto right = csv.integer(columns[1]);
    if (!right) return tl::make_unexpected(right.error());
    if (!*left || !*right) return Odometry{};
    return Odometry{WheelTicks{**left, **right}};
}

Result<Odometry> readOdometry(const CsvReader& csv, const OdometryColumns& odometry) {
    if (odometry.kind == OdometryKind::kNone) return Odometry{};
    if (odometry.kind == OdometryKind::kTicks) return readTicks(csv, odometry.columns);
    const std::size_t count = odometry.kind == OdometryKind::kPose     ? 3
                              : odometry.kind == OdometryKind::kTravel ? 2
                                                                       : 1;
    return readNumbers(csv, odometry.columns, count).map([&odometry](const auto& v) -> Odometry {
        if (!v) return {};
        if (odometry.kind == OdometryKind::kPose) return OdometryPose{(*v)[0], (*v)[1], (*v)[2]};
        if (odometry.kind == OdometryKind::kTravel) return WheelTravel{(*v)[0], (*v)[1]};
        return PathTravel{(*v)[0]};
    });
}

Result<SensorReport> readReport(const CsvReader& csv, const Layout& layout) {
    SensorReport report;
    const auto time = csv.number(layout.time);
    if (!time) return tl::make_unexpected(time.error());
    report.robot_time_s = *time;
    auto odometry = readOdometry(csv, layout.odometry);
    if (!odometry) return tl::make_unexpected(odometry.error());
    report.odometry = *odometry;
    if (layout.gyro) {
        const auto rate = csv.numberOrNan(*layout.gyro);
        if (!rate) return tl::make_unexpected(rate.error());
        if (!std::isnan(*rate)) report.gyro = GyroRate{*rate};
    }
    if (layout.temperature) {
        const auto celsius = csv.numberOrNan(*layout.temperature);
        if (!celsius) return tl::make_unexpected(celsius.error());
        if (!std::isnan(*celsius)) report.temperature_c = *celsius;
    }
    if (layout.magnetic_field) {
        const auto field = readNumbers(csv, *layout.magnetic_field, 3);
        if (!field) return tl::make_unexpected(field.error());
        if (*field) report.magnetic_field = MagneticField{(**field)[0], (**field)[1], (**field)[2]};
    }
    return report;
}

}  // namespace

Result<SensorLog> loadSensorLog(const std::filesystem::path& file, const std::string& gyro_column) {
    const auto text = readTextFile(file);
    if (!text) return tl::make_unexpected(text.error());
    auto csv = CsvReader::open(*text, file.string());
    if (!csv) return tl::make_unexpected(csv.error());
    const auto layout = findLayout(*csv, file.string(), gyro_column);
    if (!layout) return tl::make_unexpected(layout.error());

    SensorLog log;
    for (const std::string& column : csv->columns())
        if (!isKnown(column, gyro_column)) log.ignored_columns.push_back(column);
    log.reports.reserve(static_cast<std::size_t>(std::count(text->begin(), text->end(), '\n')) + 1);
    for (;;) {
        const auto more = csv->next();
        if (!more) return tl::make_unexpected(more.error());
        if (!*more) break;
        auto report = readReport(*csv, *layout);
        if (!report) return tl::make_unexpected(report.error());
        log.reports.push_back(*report);
    }
    if (log.reports.empty())
        return fail(ErrorCode::kFileEmpty, file.string(), "it has a header but no rows");
    return log;
}

}  // namespace hedr
