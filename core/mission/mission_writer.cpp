#include "core/mission/mission_writer.h"

#include <SQLiteCpp/VariadicBind.h>

#include <algorithm>
#include <map>
#include <optional>

#include "core/mission/mission_database.h"
#include "core/mission/packed_points.h"
#include "core/site/site_file.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

// Long enough for a reader that is just recovering the log, too short to slip into the moment
// between two transactions of a running recording.
constexpr int kFirstLockTimeout_ms = 100;

std::int64_t unixMilliseconds(std::chrono::system_clock::time_point time) {
    return std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
}

int blobSize(std::size_t size) { return static_cast<int>(size); }

// A new file, or one whose creator died before its first commit.
bool isEmpty(SQLite::Database& database) {
    return database.execAndGet("SELECT count(*) FROM sqlite_master").getInt() == 0 &&
           database.execAndGet("PRAGMA application_id").getInt() == 0;
}

void beginMission(SQLite::Database& database, const MissionHeader& header) {
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    createMissionSchema(database);
    SQLite::Statement insert(database, "INSERT INTO meta VALUES (?, ?)");
    const std::pair<const char*, std::string> rows[] = {
        {"start_unix_ms", std::to_string(unixMilliseconds(header.start))},
        {"program_version", header.program_version}};
    for (const auto& [key, value] : rows) {
        insert.bind(1, key);
        insert.bind(2, value);
        insert.exec();
        insert.reset();
    }
    transaction.commit();
}

// A file that nobody has ever seen without its tables, not even after a crash: it is made under
// another name. False where there is one already.
bool makeMission(const fs::path& file, const MissionHeader& header) {
    std::error_code error;
    if (fs::exists(file, error) || error) return false;
    fs::path draft = file;
    do {
        draft += ".new";
    } while (fs::exists(draft, error));
    try {
        SQLite::Database database(draft.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
        beginMission(database, header);
    } catch (const SQLite::Exception&) {
        fs::remove(draft, error);
        throw;
    }
    fs::rename(draft, file, error);
    return !error;
}

// Seconds from the mission's start to that of this recording; never back into what is recorded.
double timeOffset(SQLite::Database& database, const MissionHeader& header) {
    SQLite::Statement start(database,
                            "SELECT CAST(value AS INTEGER) FROM meta WHERE key = "
                            "'start_unix_ms'");
    if (!start.executeStep()) return 0.0;
    const double apart_s =
        static_cast<double>(unixMilliseconds(header.start) - start.getColumn(0).getInt64()) /
        1000.0;
    SQLite::Statement last(database,
                           "SELECT coalesce(max(t), 0.0) FROM ("
                           "SELECT receive_time_s AS t FROM (SELECT * FROM stream ORDER BY id DESC "
                           "LIMIT 1) UNION ALL SELECT max(receive_time_s) FROM event)");
    last.executeStep();
    return std::max(apart_s, last.getColumn(0).getDouble() - header.first_time_s);
}

}  // namespace

class MissionWriter::Database {
  public:
    Database(const fs::path& file, const MissionHeader& header)
        : is_new_(makeMission(file, header)),
          file_(file),
          database_(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE,
                    kFirstLockTimeout_ms) {
        if (!isEmpty(database_)) return;
        beginMission(database_, header);
        is_new_ = true;
    }
    ~Database() { close(); }

    Result<void> start(const MissionHeader& header) {
        if (auto checked = checkMission(database_, file_); !checked) return checked;
        database_.exec("PRAGMA journal_mode = WAL");
        database_.exec("PRAGMA synchronous = FULL");
        // About once a minute: whoever loses the log loses no more than that.
        database_.exec("PRAGMA wal_autocheckpoint = 64");
        // An open transaction is what keeps a second writer out.
        begin();
        database_.setBusyTimeout(kBusyTimeout_ms);
        dirty_ = upgradeMissionSchema(database_);
        offset_s_ = is_new_ ? 0.0 : timeOffset(database_, header);
        insert_stream_.emplace(database_,
                               "INSERT INTO stream (receive_time_s, kind, data) VALUES (?, ?, ?)");
        return {};
    }

    // Runs `work` unless an earlier call failed; keeps the first failure.
    template <class Work>
    Result<void> perform(Work work) {
        if (failure_) return tl::make_unexpected(*failure_);
        auto done = guarded(file_, MissionAccess::kWriting, [&]() -> Result<void> {
            work();
            return {};
        });
        if (!done) failure_ = done.error();
        return done;
    }

    void insertStream(double time_s, StreamKind kind, std::span<const std::uint8_t> bytes) {
        insert_stream_->bind(1, time_s + offset_s_);
        insert_stream_->bind(2, static_cast<int>(kind));
        insert_stream_->bindNoCopy(3, bytes.data(), blobSize(bytes.size()));
        insert_stream_->exec();
        insert_stream_->reset();
        dirty_ = true;
    }

    template <class... Values>
    void insert(const char* sql, const Values&... values) {
        SQLite::Statement statement(database_, sql);
        SQLite::bind(statement, values...);
        statement.exec();
        dirty_ = true;
    }

    void insertPlan(const MissionPlan& plan) {
        const Pose<World>& origin = plan.placement.origin;
        SQLite::Statement statement(database_, "INSERT INTO plan VALUES (NULL, ?, ?, ?, ?, ?, ?)");
        statement.bind(1, plan.file.string());
        statement.bind(2, plan.placement.resolution_m);
        statement.bind(3, origin.position.x);
        statement.bind(4, origin.position.y);
        statement.bind(5, origin.heading_rad);
        if (plan.sha256) statement.bind(6, *plan.sha256);
        statement.exec();
        dirty_ = true;
    }

    void insertLinkSample(const LinkSample& sample) {
        SQLite::Statement statement(database_,
                                    "INSERT INTO link VALUES (NULL, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
        statement.bind(1, sample.receive_time_s + offset_s_);
        statement.bind(2, sample.loss);
        statement.bind(3, sample.frames_per_s);
        statement.bind(4, sample.bad_frames_per_s);
        statement.bind(5, sample.longest_gap_s);
        statement.bind(6, sample.jitter_s);
        if (sample.round_trip_s) statement.bind(7, *sample.round_trip_s);
        if (sample.clock_offset_s) statement.bind(8, *sample.clock_offset_s);
        if (sample.radio_dbm) statement.bind(9, *sample.radio_dbm);
        statement.exec();
        dirty_ = true;
    }

    void insertSite(double time_s, const Site& site) {
        const std::string toml = siteText(site, fs::absolute(file_).parent_path());
        SQLite::Statement last(database_, "SELECT toml FROM site ORDER BY id DESC LIMIT 1");
        if (last.executeStep() && last.getColumn(0).getString() == toml) return;
        insert("INSERT INTO site (receive_time_s, toml) VALUES (?, ?)", time_s + offset_s_, toml);
    }

    void gather(const std::string& track, std::span<const TrackPoint> points) {
        auto& waiting = waiting_[track];
        waiting.insert(waiting.end(), points.begin(), points.end());
        dirty_ = dirty_ || !points.empty();
    }

    void commit() {
        if (!dirty_) return;
        storeEstimates();
        database_.exec("COMMIT");
        dirty_ = false;
        begin();
    }

    void commitIfDue(double time_s) {
        const double since_s = time_s - last_commit_s_;
        if (since_s >= 0.0 && since_s < kCommitPeriod_s) return;
        commit();
        last_commit_s_ = time_s;
    }

    double offset_s() const { return offset_s_; }
    const fs::path& file() const { return file_; }

  private:
    void begin() { database_.exec("BEGIN IMMEDIATE"); }

    void storeEstimates() {
        SQLite::Statement statement(
            database_,
            "INSERT INTO estimates (track, first_t_s, points, data) VALUES (?, ?, ?, ?)");
        for (auto& [track, points] : waiting_) {
            if (points.empty()) continue;
            const auto bytes = packPoints(points);
            statement.bind(1, track);
            statement.bind(2, points.front().t_s);
            statement.bind(3, static_cast<std::int64_t>(points.size()));
            statement.bindNoCopy(4, bytes.data(), blobSize(bytes.size()));
            statement.exec();
            statement.reset();
            points.clear();
        }
    }

    void close() {
        const auto committed = perform([this] { commit(); });
        // Without its statements and its transaction the database moves the log into itself.
        insert_stream_.reset();
        if (committed) perform([this] { database_.exec("ROLLBACK"); });
    }

    bool is_new_;  // made before it is opened
    fs::path file_;
    SQLite::Database database_;
    std::optional<SQLite::Statement> insert_stream_;
    std::map<std::string, std::vector<TrackPoint>> waiting_;
    std::optional<Error> failure_;
    double offset_s_ = 0.0;
    double last_commit_s_ = 0.0;
    bool dirty_ = false;
};

Result<MissionWriter> MissionWriter::create(const fs::path& file, const MissionHeader& header) {
    std::error_code ignored;
    if (fs::is_directory(file, ignored))
        return fail(ErrorCode::kFileUnwritable, file.string(), "it is a folder");
    return guarded(file, MissionAccess::kWriting, [&]() -> Result<MissionWriter> {
        auto database = std::make_unique<Database>(file, header);
        if (auto started = database->start(header); !started)
            return tl::make_unexpected(started.error());
        return MissionWriter(std::move(database));
    });
}

MissionWriter::MissionWriter(std::unique_ptr<Database> database) : database_(std::move(database)) {}
MissionWriter::MissionWriter(MissionWriter&&) noexcept = default;
MissionWriter& MissionWriter::operator=(MissionWriter&&) noexcept = default;
MissionWriter::~MissionWriter() = default;

Result<void> MissionWriter::writeBytes(double receive_time_s, std::span<const std::uint8_t> bytes) {
    return database_->perform(
        [&] { database_->insertStream(receive_time_s, StreamKind::kBytes, bytes); });
}

Result<void> MissionWriter::writeStreamMark(double receive_time_s, StreamKind mark,
                                            std::span<const std::uint8_t> data) {
    return database_->perform([&] { database_->insertStream(receive_time_s, mark, data); });
}

Result<void> MissionWriter::writeEstimates(const std::string& track,
                                           std::span<const TrackPoint> points) {
    return database_->perform([&] { database_->gather(track, points); });
}

Result<void> MissionWriter::writeEvent(double receive_time_s, std::string_view kind,
                                       std::string_view text) {
    return database_->perform([&] {
        database_->insert("INSERT INTO event (receive_time_s, kind, text) VALUES (?, ?, ?)",
                          receive_time_s + database_->offset_s(), std::string(kind),
                          std::string(text));
    });
}

Result<void> MissionWriter::writeRejected(const RejectedRow& rejected) {
    return database_->perform([&] {
        database_->insert("INSERT INTO rejected VALUES (?, ?)",
                          static_cast<std::int64_t>(rejected.frame), rejected.reason);
    });
}

Result<void> MissionWriter::writeLinkSample(const LinkSample& sample) {
    return database_->perform([&] { database_->insertLinkSample(sample); });
}

Result<void> MissionWriter::writeVehicle(const Vehicle& vehicle) {
    return database_->perform([&] {
        database_->insert("INSERT INTO vehicle (toml) VALUES (?)", formatVehicle(vehicle));
    });
}

Result<void> MissionWriter::writePlan(const MissionPlan& plan) {
    return database_->perform([&] { database_->insertPlan(plan); });
}

Result<void> MissionWriter::writeSite(double receive_time_s, const Site& site) {
    return database_->perform([&] { database_->insertSite(receive_time_s, site); });
}

Result<void> MissionWriter::commitIfDue(double receive_time_s) {
    return database_->perform([&] { database_->commitIfDue(receive_time_s); });
}

Result<void> MissionWriter::commit() {
    return database_->perform([&] { database_->commit(); });
}

std::uint64_t MissionWriter::bytesOnDisk() const { return missionBytes(database_->file()); }

}  // namespace hedr
