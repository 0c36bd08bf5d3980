#include "core/mission/mission_database.h"

#include <sqlite3.h>

namespace hedr {
namespace {

namespace fs = std::filesystem;

// Documented in README.md; a change needs a new kMissionSchema.
constexpr const char* kTables = R"sql(
CREATE TABLE meta (key TEXT PRIMARY KEY NOT NULL, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE stream (id INTEGER PRIMARY KEY, receive_time_s REAL NOT NULL, kind INTEGER NOT NULL,
                     data BLOB);
CREATE TABLE estimates (id INTEGER PRIMARY KEY, track TEXT NOT NULL, first_t_s REAL NOT NULL,
                        points INTEGER NOT NULL, data BLOB NOT NULL);
CREATE INDEX estimates_by_track ON estimates (track, id, points);
CREATE TABLE event (id INTEGER PRIMARY KEY, receive_time_s REAL NOT NULL, kind TEXT NOT NULL,
                    text TEXT NOT NULL);
CREATE TABLE plan (id INTEGER PRIMARY KEY, file TEXT NOT NULL, resolution_m REAL NOT NULL,
                   origin_x_m REAL NOT NULL, origin_y_m REAL NOT NULL,
                   origin_heading_rad REAL NOT NULL, sha256 TEXT);
CREATE TABLE vehicle (id INTEGER PRIMARY KEY, toml TEXT NOT NULL);
)sql";

constexpr const char* kSiteTable = R"sql(
CREATE TABLE site (id INTEGER PRIMARY KEY, receive_time_s REAL NOT NULL, toml TEXT NOT NULL);
)sql";

constexpr const char* kLinkTables = R"sql(
CREATE TABLE link (id INTEGER PRIMARY KEY, receive_time_s REAL NOT NULL, loss REAL NOT NULL,
                   frames_per_s REAL NOT NULL, bad_frames_per_s REAL NOT NULL,
                   longest_gap_s REAL NOT NULL, jitter_s REAL NOT NULL, round_trip_s REAL,
                   clock_offset_s REAL, radio_dbm INTEGER);
CREATE TABLE rejected (frame INTEGER PRIMARY KEY, reason INTEGER NOT NULL);
)sql";

void setSchema(SQLite::Database& database) {
    database.exec(std::string("PRAGMA user_version = ").append(std::to_string(kMissionSchema)));
}

bool diskIsFull(const fs::path& file) {
    std::error_code error;
    const auto space = fs::space(fs::absolute(file).parent_path(), error);
    return !error && space.available < 65536;
}

}  // namespace

Error missionError(const SQLite::Exception& exception, const fs::path& file, MissionAccess access) {
    const bool writing = access == MissionAccess::kWriting;
    const auto error = [&file](ErrorCode code, std::string detail) {
        return Error{code, file.string(), std::move(detail)};
    };
    const ErrorCode no_access = writing ? ErrorCode::kFileUnwritable : ErrorCode::kFileUnreadable;
    switch (exception.getErrorCode() & 0xFF) {
        case SQLITE_FULL:
            return error(ErrorCode::kDiskFull, exception.what());
        case SQLITE_NOTADB:
            return error(ErrorCode::kNotAMission, exception.what());
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return writing ? error(ErrorCode::kMissionBusy, "")
                           : error(no_access, "another program has locked this mission");
        case SQLITE_CANTOPEN:
        case SQLITE_PERM:
        case SQLITE_READONLY:
            return error(no_access, exception.what());
        case SQLITE_IOERR:
            // The index of the log gets an I/O error where it does not fit on the disk.
            if (writing && diskIsFull(file)) return error(ErrorCode::kDiskFull, exception.what());
            return error(no_access, exception.what());
        default:
            return error(writing ? ErrorCode::kFileUnwritable : ErrorCode::kMissionDamaged,
                         exception.what());
        case SQLITE_CORRUPT:
            return error(ErrorCode::kMissionDamaged, exception.what());
    }
}

void createMissionSchema(SQLite::Database& database) {
    database.exec(kTables);
    database.exec(kSiteTable);
    database.exec(kLinkTables);
    database.exec(
        std::string("PRAGMA application_id = ").append(std::to_string(kMissionApplicationId)));
    setSchema(database);
}

bool upgradeMissionSchema(SQLite::Database& database) {
    const int schema = missionSchema(database);
    if (schema >= kMissionSchema) return false;
    if (schema < kFirstSchemaWithSite) database.exec(kSiteTable);
    if (schema < kFirstSchemaWithLink) database.exec(kLinkTables);
    setSchema(database);
    return true;
}

int missionSchema(SQLite::Database& database) { return database.execAndGet("PRAGMA user_version"); }

Result<void> checkMission(SQLite::Database& database, const fs::path& file) {
    const int id = database.execAndGet("PRAGMA application_id");
    if (id != kMissionApplicationId)
        return fail(ErrorCode::kNotAMission, file.string(), "it is another program's database");
    const int schema = missionSchema(database);
    if (schema > kMissionSchema)
        return fail(ErrorCode::kMissionTooNew, file.string(),
                    "its schema is " + std::to_string(schema) + ", this version reads up to " +
                        std::to_string(kMissionSchema));
    return {};
}

fs::path missionLogFile(const fs::path& file) { return fs::path(file) += "-wal"; }

std::uint64_t missionBytes(const fs::path& file) {
    std::uint64_t bytes = 0;
    for (const fs::path& part : {file, missionLogFile(file)}) {
        std::error_code error;
        const auto size = fs::file_size(part, error);
        if (!error) bytes += size;
    }
    return bytes;
}

}  // namespace hedr
