#include "core/mission/mission_salvage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string_view>

#include "core/mission/mission_database.h"
#include "core/mission/salvage_into.h"
#include "core/mission/sqlite_pages.h"

namespace hedr {

namespace {

namespace fs = std::filesystem;

// The columns of a table, a letter each: i INTEGER PRIMARY KEY (stored as NULL), r REAL, n INTEGER,
// t TEXT, b BLOB; a capital letter where it may be NULL. No two tables look alike.
struct TableShape {
    const char* insert;
    std::string_view columns;
    int time_column;  // of receive_time_s; -1: none
};

constexpr std::size_t kStream = 0;
constexpr std::size_t kMeta = 1;
constexpr std::array kShapes{
    TableShape{"INSERT OR IGNORE INTO stream VALUES (?, ?, ?, ?)", "irnB", 1},
    TableShape{"INSERT OR IGNORE INTO meta VALUES (?, ?)", "tt", -1},
    TableShape{"INSERT OR IGNORE INTO estimates VALUES (?, ?, ?, ?, ?)", "itrnb", -1},
    TableShape{"INSERT OR IGNORE INTO event VALUES (?, ?, ?, ?)", "irtt", 1},
    TableShape{"INSERT OR IGNORE INTO plan VALUES (?, ?, ?, ?, ?, ?, ?)", "itrrrrT", -1},
    TableShape{"INSERT OR IGNORE INTO vehicle VALUES (?, ?)", "it", -1},
    TableShape{"INSERT OR IGNORE INTO site VALUES (?, ?, ?)", "irt", 1},
    TableShape{"INSERT OR IGNORE INTO rejected VALUES (?, ?)", "in", -1},
    TableShape{"INSERT OR IGNORE INTO link VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", "irrrrrrRRN", 1},
};

bool isNumber(const SqlValue& value) {
    const auto* real = std::get_if<double>(&value);
    return real ? std::isfinite(*real) : std::holds_alternative<std::int64_t>(value);
}

bool fits(const SqlValue& value, char column) {
    const bool null = std::holds_alternative<std::monostate>(value);
    switch (column) {
        case 'i':
            return null;
        case 'r':
            return isNumber(value);  // SQLite stores 2.0 as 2
        case 'n':
            return std::holds_alternative<std::int64_t>(value);
        case 't':
            return std::holds_alternative<std::string>(value);
        case 'b':
            return std::holds_alternative<SqlBlob>(value);
        case 'R':
            return null || isNumber(value);
        case 'N':
            return null || std::holds_alternative<std::int64_t>(value);
        case 'T':
            return null || std::holds_alternative<std::string>(value);
        default:
            return null || std::holds_alternative<SqlBlob>(value);
    }
}

bool fits(const FoundRow& row, const TableShape& shape) {
    if (row.values.size() != shape.columns.size()) return false;
    for (std::size_t i = 0; i < row.values.size(); ++i) {
        if (!fits(row.values[i], shape.columns[i])) return false;
    }
    return shape.columns.front() != 'i' || row.id > 0;
}

double numberOf(const SqlValue& value) {
    const auto* whole = std::get_if<std::int64_t>(&value);
    return whole ? static_cast<double>(*whole) : std::get<double>(value);
}

void bind(SQLite::Statement& statement, int place, const SqlValue& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) statement.bind(place, *whole);
    if (const auto* real = std::get_if<double>(&value)) statement.bind(place, *real);
    if (const auto* text = std::get_if<std::string>(&value)) statement.bind(place, *text);
    if (const auto* blob = std::get_if<SqlBlob>(&value))
        statement.bind(place, blob->data(), static_cast<int>(blob->size()));
}

class Salvage {
  public:
    explicit Salvage(SQLite::Database& database) : database_(database) {
        for (const TableShape& shape : kShapes) inserts_.emplace_back(database_, shape.insert);
    }

    void take(const FoundRow& row) {
        for (std::size_t i = 0; i < kShapes.size(); ++i) {
            if (!fits(row, kShapes[i])) continue;
            insert(row, i);
            const int time = kShapes[i].time_column;
            if (time >= 0) {
                const double t_s = numberOf(row.values[static_cast<std::size_t>(time)]);
                report_.duration_s = std::max(report_.duration_s, t_s);
            }
            return;
        }
    }

    SalvageReport finished() {
        report_.start_known =
            database_.execAndGet("SELECT count(*) FROM meta WHERE key = 'start_unix_ms'")
                .getInt() == 1;
        if (!report_.start_known) database_.exec("INSERT INTO meta VALUES ('start_unix_ms', '0')");
        measureStream();
        // They are counted among all frames: after a hole they would be about others.
        if (report_.stream_rows_missing > 0)
            report_.rejected_missing = database_.exec("DELETE FROM rejected") > 0;
        return report_;
    }

  private:
    void insert(const FoundRow& row, std::size_t table) {
        SQLite::Statement& statement = inserts_[table];
        const bool has_id = kShapes[table].columns.front() == 'i';
        statement.clearBindings();
        if (has_id) statement.bind(1, row.id);
        for (std::size_t i = has_id ? 1 : 0; i < row.values.size(); ++i) {
            bind(statement, static_cast<int>(i) + 1, row.values[i]);
        }
        const int added = statement.exec();
        statement.reset();
        if (table != kStream && table != kMeta)
            report_.other_rows += static_cast<std::uint64_t>(added);
    }

    // Rows are never deleted: a number that is missing was a row.
    void measureStream() {
        SQLite::Statement rows(database_, "SELECT id, receive_time_s FROM stream ORDER BY id");
        std::int64_t last_id = 0;
        double last_t_s = 0.0;
        while (rows.executeStep()) {
            const std::int64_t id = rows.getColumn(0).getInt64();
            const double t_s = rows.getColumn(1).getDouble();
            report_.stream_rows_missing += static_cast<std::uint64_t>(id - last_id - 1);
            if (id == last_id + 1) report_.recovered_s += std::max(0.0, t_s - last_t_s);
            last_id = id;
            last_t_s = t_s;
            ++report_.stream_rows;
        }
    }

    SQLite::Database& database_;
    std::vector<SQLite::Statement> inserts_;
    SalvageReport report_{};
};

}  // namespace

Result<SalvageReport> salvageInto(SQLite::Database& out, const fs::path& damaged) {
    std::error_code error;
    if (!fs::exists(damaged, error)) return fail(ErrorCode::kFileMissing, damaged.string());
    auto pages = SqlitePages::open(damaged);
    if (!pages) return tl::make_unexpected(pages.error());
    if (pages->applicationId() != static_cast<std::uint32_t>(kMissionApplicationId))
        return fail(ErrorCode::kNotAMission, damaged.string(), "it is another program's database");
    SQLite::Transaction transaction(out);
    createMissionSchema(out);
    SalvageReport report;
    {
        Salvage salvage(out);
        pages->forEachRow([&](const FoundRow& row) { salvage.take(row); });
        report = salvage.finished();
    }
    transaction.commit();
    report.pages = std::max<std::uint64_t>(pages->pagesPromised(), pages->pagesPresent());
    report.pages_missing = report.pages - pages->pagesPresent();
    return report;
}

Result<SalvageReport> salvageMission(const fs::path& damaged, const fs::path& out) {
    std::error_code error;
    if (fs::exists(out, error)) return fail(ErrorCode::kFileExists, out.string());
    auto report = guarded(out, MissionAccess::kWriting, [&]() -> Result<SalvageReport> {
        SQLite::Database database(out.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
        return salvageInto(database, damaged);
    });
    if (!report) fs::remove(out, error);
    return report;
}

fs::path recoveredFile(const fs::path& damaged, int number) {
    std::string ending = ".recovered";
    if (number > 1) ending.append("-").append(std::to_string(number));
    return fs::path(damaged).replace_extension(ending.append(".hedr"));
}

std::string describe(const SalvageReport& report) {
    std::array<char, 160> line{};
    const int size = std::snprintf(line.data(), line.size(),
                                   "recovered %.1f of at least %.1f s: %llu pieces of the stream, "
                                   "%llu other rows; missing: ",
                                   report.recovered_s, report.duration_s,
                                   static_cast<unsigned long long>(report.stream_rows),
                                   static_cast<unsigned long long>(report.other_rows));
    std::string text(line.data(), static_cast<std::size_t>(std::clamp(size, 0, 159)));
    std::string missing;
    const auto add = [&missing](const std::string& what) {
        missing += (missing.empty() ? "" : ", ") + what;
    };
    if (report.pages_missing > 0)
        add(std::to_string(report.pages_missing) + " of the file's " +
            std::to_string(report.pages) + " pages at its end");
    if (report.stream_rows_missing > 0)
        add(std::to_string(report.stream_rows_missing) + " pieces in between");
    if (report.rejected_missing) add("which frames were not believed");
    if (!report.start_known) add("the date of its start");
    return text + (missing.empty() ? "nothing that shows" : missing);
}

}  // namespace hedr
