#include "core/mission/mission_opening.h"

#include <sqlite3.h>

#include <array>
#include <utility>

#include "core/mission/mission_database.h"

namespace hedr {

namespace {

namespace fs = std::filesystem;

// SQLite reads some characters of a file URI as its grammar.
std::string immutableUri(const fs::path& file) {
    std::string uri = "file:";
    for (const char c : fs::absolute(file).string()) {
        if (c == '%') {
            uri += "%25";
        } else if (c == '?') {
            uri += "%3f";
        } else if (c == '#') {
            uri += "%23";
        } else {
            uri += c;
        }
    }
    return uri + "?immutable=1";
}

std::unique_ptr<SQLite::Database> openAs(const std::string& name, int flags) {
    auto database = std::make_unique<SQLite::Database>(name, flags, kBusyTimeout_ms);
    database->execAndGet("SELECT count(*) FROM sqlite_master");  // opens the file in earnest
    return database;
}

bool needsAccess(const SQLite::Exception& exception) {
    const int code = exception.getErrorCode() & 0xFF;
    return code == SQLITE_CANTOPEN || code == SQLITE_READONLY || code == SQLITE_IOERR ||
           code == SQLITE_PERM;
}

bool hasLog(const fs::path& file) {
    std::error_code error;
    const auto size = fs::file_size(missionLogFile(file), error);
    return !error && size > 0;
}

// A mission that a crash left behind may have to be put in order, which needs a folder that can be
// written; a closed one can be read from anywhere. Nothing is written into either, but only who may
// write takes the log and its index away again that SQLite puts beside a closed one.
Result<std::unique_ptr<SQLite::Database>> openDatabase(const fs::path& file) {
    std::array ways{SQLite::OPEN_READONLY, SQLite::OPEN_READWRITE};
    if (!hasLog(file)) std::swap(ways[0], ways[1]);
    for (const int flags : ways) {
        try {
            return openAs(file.string(), flags);
        } catch (const SQLite::Exception& exception) {
            if (!needsAccess(exception)) throw;
        }
    }
    if (hasLog(file))
        return fail(ErrorCode::kFileUnreadable, file.string(),
                    "it was not closed and its folder cannot be written; copy it with its -wal "
                    "file to another folder");
    return openAs(immutableUri(file), SQLite::OPEN_READONLY | SQLite::OPEN_URI);
}

// SQLite takes the part of a page that is cut off at the end for zeros, and finds a damaged page
// only when it comes to it.
Result<void> checkPages(SQLite::Database& database, const fs::path& file) {
    const auto page_bytes =
        static_cast<std::uintmax_t>(database.execAndGet("PRAGMA page_size").getInt());
    std::error_code error;
    const std::uintmax_t bytes = fs::file_size(file, error);
    if (!error && !hasLog(file) && bytes % page_bytes != 0)
        return fail(ErrorCode::kMissionDamaged, file.string(), "it is cut within a page");
    const std::string verdict = database.execAndGet("PRAGMA quick_check(1)").getString();
    if (verdict != "ok") return fail(ErrorCode::kMissionDamaged, file.string(), verdict);
    return {};
}

}  // namespace

Result<std::unique_ptr<SQLite::Database>> openWhole(const fs::path& file) {
    auto sqlite = openDatabase(file);
    if (!sqlite) return sqlite;
    if (auto checked = checkMission(**sqlite, file); !checked)
        return tl::make_unexpected(checked.error());
    if (auto sound = checkPages(**sqlite, file); !sound) return tl::make_unexpected(sound.error());
    return sqlite;
}

}  // namespace hedr
