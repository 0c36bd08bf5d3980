#include "core/mission/mission_reader.h"

#include <array>
#include <ctime>

#include "core/mission/mission_database.h"
#include "core/mission/mission_opening.h"
#include "core/mission/packed_points.h"
#include "core/mission/salvage_into.h"
#include "core/site/site_file.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

std::string isoUtc(std::int64_t unix_ms) {
    const std::time_t seconds = static_cast<std::time_t>(unix_ms / 1000);
    std::tm utc{};
    ::gmtime_r(&seconds, &utc);
    std::array<char, 32> text{};
    const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
    return {text.data(), length};
}

std::span<const std::uint8_t> bytesOf(const SQLite::Column& column) {
    return {static_cast<const std::uint8_t*>(column.getBlob()),
            static_cast<std::size_t>(column.getBytes())};
}

std::optional<std::string> metaValue(SQLite::Database& database, const char* key) {
    SQLite::Statement query(database, "SELECT value FROM meta WHERE key = ?");
    query.bind(1, key);
    if (!query.executeStep()) return std::nullopt;
    return query.getColumn(0).getString();
}

std::uint64_t count(SQLite::Database& database, const char* sql) {
    return static_cast<std::uint64_t>(database.execAndGet(sql).getInt64());
}

}  // namespace

struct MissionReader::Database {
    fs::path file;
    std::unique_ptr<SQLite::Database> sqlite;
    std::optional<SalvageReport> salvaged{};

    template <class Value, class Work>
    Result<Value> read(Work work) const {
        return guarded(file, MissionAccess::kReading,
                       [&]() -> Result<Value> { return work(*sqlite); });
    }
};

Result<MissionReader> MissionReader::open(const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (!fs::exists(status)) return fail(ErrorCode::kFileMissing, file.string());
    if (fs::is_directory(status))
        return fail(ErrorCode::kFileUnreadable, file.string(), "it is a folder");
    auto opened = guarded(file, MissionAccess::kReading, [&file]() -> Result<MissionReader> {
        auto sqlite = openWhole(file);
        if (!sqlite) return tl::make_unexpected(sqlite.error());
        return MissionReader(std::make_unique<Database>(Database{file, std::move(*sqlite)}));
    });
    const bool damaged = !opened && opened.error().code == ErrorCode::kMissionDamaged;
    return damaged ? openWhatIsLeft(file) : std::move(opened);
}

// In a database of its own, on disk where it is large, which goes with the reader.
Result<MissionReader> MissionReader::openWhatIsLeft(const fs::path& file) {
    return guarded(file, MissionAccess::kReading, [&file]() -> Result<MissionReader> {
        constexpr const char* kTemporary = "";
        auto sqlite = std::make_unique<SQLite::Database>(
            kTemporary, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
        auto report = salvageInto(*sqlite, file);
        if (!report) return tl::make_unexpected(report.error());
        return MissionReader(
            std::make_unique<Database>(Database{file, std::move(sqlite), *report}));
    });
}

const std::optional<SalvageReport>& MissionReader::salvaged() const { return database_->salvaged; }

MissionReader::MissionReader(std::unique_ptr<Database> database) : database_(std::move(database)) {}
MissionReader::MissionReader(MissionReader&&) noexcept = default;
MissionReader& MissionReader::operator=(MissionReader&&) noexcept = default;
MissionReader::~MissionReader() = default;

Result<MissionInfo> MissionReader::info() const {
    return database_->read<MissionInfo>([this](SQLite::Database& sqlite) {
        MissionInfo info;
        const std::int64_t start_unix_ms =
            sqlite.execAndGet("SELECT CAST(value AS INTEGER) FROM meta WHERE key = 'start_unix_ms'")
                .getInt64();
        info.start =
            std::chrono::system_clock::time_point(std::chrono::milliseconds(start_unix_ms));
        info.start_utc = isoUtc(start_unix_ms);
        info.program_version = metaValue(sqlite, "program_version").value_or("");
        info.schema = missionSchema(sqlite);
        info.bytes = missionBytes(database_->file);
        // Rows are never deleted, so the last id is their number; counting would read them all.
        info.stream_rows = count(sqlite, "SELECT coalesce(max(id), 0) FROM stream");
        info.events = count(sqlite, "SELECT coalesce(max(id), 0) FROM event");
        info.duration_s = sqlite.execAndGet(
            "SELECT max(coalesce((SELECT receive_time_s FROM stream ORDER BY id "
            "DESC LIMIT 1), 0.0), coalesce((SELECT max(receive_time_s) FROM "
            "event), 0.0))");
        SQLite::Statement tracks(sqlite, "SELECT track, sum(points) FROM estimates GROUP BY track");
        while (tracks.executeStep())
            info.tracks.emplace_back(tracks.getColumn(0).getString(),
                                     static_cast<std::uint64_t>(tracks.getColumn(1).getInt64()));
        return info;
    });
}

Result<void> MissionReader::forEachStreamRow(const std::function<bool(const StreamRow&)>& visit,
                                             std::int64_t after) const {
    return database_->read<void>([&visit, after](SQLite::Database& sqlite) -> Result<void> {
        SQLite::Statement rows(
            sqlite, "SELECT receive_time_s, kind, data, id FROM stream WHERE id > ? ORDER BY id");
        rows.bind(1, after);
        while (rows.executeStep()) {
            const SQLite::Column data = rows.getColumn(2);
            if (!visit({rows.getColumn(0).getDouble(),
                        static_cast<StreamKind>(rows.getColumn(1).getInt()), bytesOf(data),
                        rows.getColumn(3).getInt64()}))
                break;
        }
        return {};
    });
}

Result<std::vector<std::string>> MissionReader::tracks() const {
    return database_->read<std::vector<std::string>>([](SQLite::Database& sqlite) {
        std::vector<std::string> names;
        SQLite::Statement rows(sqlite, "SELECT DISTINCT track FROM estimates ORDER BY track");
        while (rows.executeStep()) names.push_back(rows.getColumn(0).getString());
        return names;
    });
}

Result<std::vector<TrackPoint>> MissionReader::estimates(const std::string& track) const {
    using Points = std::vector<TrackPoint>;
    return database_->read<Points>([&](SQLite::Database& sqlite) -> Result<Points> {
        Points points;
        SQLite::Statement rows(sqlite, "SELECT data FROM estimates WHERE track = ? ORDER BY id");
        rows.bind(1, track);
        while (rows.executeStep()) {
            const SQLite::Column data = rows.getColumn(0);
            const auto bytes = bytesOf(data);
            if (bytes.size() % kPackedPointBytes != 0)
                return fail(ErrorCode::kMissionDamaged, database_->file.string(),
                            "a row of track " + track + " is cut");
            unpackPoints(bytes, points);
        }
        return points;
    });
}

Result<std::vector<MissionEvent>> MissionReader::events() const {
    return database_->read<std::vector<MissionEvent>>([](SQLite::Database& sqlite) {
        std::vector<MissionEvent> events;
        SQLite::Statement rows(sqlite, "SELECT receive_time_s, kind, text FROM event ORDER BY id");
        while (rows.executeStep())
            events.push_back({rows.getColumn(0).getDouble(), rows.getColumn(1).getString(),
                              rows.getColumn(2).getString()});
        return events;
    });
}

Result<std::vector<LinkSample>> MissionReader::linkSamples() const {
    return database_->read<std::vector<LinkSample>>([](SQLite::Database& sqlite) {
        std::vector<LinkSample> samples;
        if (missionSchema(sqlite) < kFirstSchemaWithLink) return samples;
        SQLite::Statement rows(sqlite,
                               "SELECT receive_time_s, loss, frames_per_s, bad_frames_per_s, "
                               "longest_gap_s, jitter_s, round_trip_s, clock_offset_s, radio_dbm "
                               "FROM link ORDER BY id");
        const auto maybe = [&rows](int column) {
            const SQLite::Column value = rows.getColumn(column);
            return value.isNull() ? std::nullopt : std::optional(value.getDouble());
        };
        while (rows.executeStep()) {
            LinkSample sample{.receive_time_s = rows.getColumn(0).getDouble(),
                              .loss = rows.getColumn(1).getDouble(),
                              .frames_per_s = rows.getColumn(2).getDouble(),
                              .bad_frames_per_s = rows.getColumn(3).getDouble(),
                              .longest_gap_s = rows.getColumn(4).getDouble(),
                              .jitter_s = rows.getColumn(5).getDouble(),
                              .round_trip_s = maybe(6),
                              .clock_offset_s = maybe(7)};
            if (!rows.getColumn(8).isNull()) sample.radio_dbm = rows.getColumn(8).getInt();
            samples.push_back(sample);
        }
        return samples;
    });
}

Result<std::vector<RejectedRow>> MissionReader::rejected() const {
    return database_->read<std::vector<RejectedRow>>([](SQLite::Database& sqlite) {
        std::vector<RejectedRow> rejected;
        if (missionSchema(sqlite) < kFirstSchemaWithLink) return rejected;
        SQLite::Statement rows(sqlite, "SELECT frame, reason FROM rejected ORDER BY frame");
        while (rows.executeStep())
            rejected.push_back({static_cast<std::uint64_t>(rows.getColumn(0).getInt64()),
                                rows.getColumn(1).getInt()});
        return rejected;
    });
}

Result<std::optional<Vehicle>> MissionReader::vehicle() const {
    using Maybe = std::optional<Vehicle>;
    return database_->read<Maybe>([this](SQLite::Database& sqlite) -> Result<Maybe> {
        SQLite::Statement row(sqlite, "SELECT toml FROM vehicle ORDER BY id DESC LIMIT 1");
        if (!row.executeStep()) return Maybe();
        const auto vehicle =
            parseVehicle(row.getColumn(0).getString(), database_->file.string() + " (vehicle)");
        if (!vehicle) return tl::make_unexpected(vehicle.error());
        return Maybe(*vehicle);
    });
}

Result<std::optional<MissionPlan>> MissionReader::plan() const {
    using Maybe = std::optional<MissionPlan>;
    return database_->read<Maybe>([](SQLite::Database& sqlite) -> Result<Maybe> {
        SQLite::Statement row(sqlite,
                              "SELECT file, resolution_m, origin_x_m, origin_y_m, "
                              "origin_heading_rad, sha256 FROM plan ORDER BY id DESC LIMIT 1");
        if (!row.executeStep()) return Maybe();
        MissionPlan plan;
        plan.file = row.getColumn(0).getString();
        plan.placement.resolution_m = row.getColumn(1).getDouble();
        plan.placement.origin = {{row.getColumn(2).getDouble(), row.getColumn(3).getDouble()},
                                 row.getColumn(4).getDouble()};
        if (!row.getColumn(5).isNull()) plan.sha256 = row.getColumn(5).getString();
        return Maybe(plan);
    });
}

Result<std::optional<Site>> MissionReader::site() const {
    using Maybe = std::optional<Site>;
    return database_->read<Maybe>([this](SQLite::Database& sqlite) -> Result<Maybe> {
        if (missionSchema(sqlite) < kFirstSchemaWithSite) return Maybe();
        SQLite::Statement row(sqlite, "SELECT toml FROM site ORDER BY id DESC LIMIT 1");
        if (!row.executeStep()) return Maybe();
        const fs::path& file = database_->file;
        auto site = parseSite(row.getColumn(0).getString(), file.string() + " (site)",
                              fs::absolute(file).parent_path());
        if (site) return Maybe(std::move(*site));
        return fail(ErrorCode::kMissionDamaged, file.string(),
                    site.error().subject + ": " + site.error().detail);
    });
}

}  // namespace hedr
