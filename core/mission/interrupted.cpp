#include "core/mission/interrupted.h"

#include "core/mission/mission_database.h"
#include "core/mission/mission_reader.h"
#include "core/mission/mission_writer.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> newestMission(const fs::path& folder) {
    std::optional<fs::path> newest;
    fs::file_time_type newest_time{};
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        std::error_code ignored;
        if (entry.path().extension() != ".hedr" || !entry.is_regular_file(ignored)) continue;
        // The log is what was written last.
        const fs::path log = missionLogFile(entry.path());
        const auto time = fs::exists(log, ignored) ? fs::last_write_time(log, ignored)
                                                   : entry.last_write_time(ignored);
        if (newest && time <= newest_time) continue;
        newest = entry.path();
        newest_time = time;
    }
    return newest;
}

bool wasClosed(const fs::path& file) {
    std::error_code error;
    const auto size = fs::file_size(missionLogFile(file), error);
    return error || size == 0;
}

// A recorder keeps a write transaction open all the time.
bool isRecorded(const fs::path& file) {
    try {
        SQLite::Database database(file.string(), SQLite::OPEN_READWRITE);
        const SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
        return false;
    } catch (const SQLite::Exception&) {
        return true;
    }
}

}  // namespace

std::optional<InterruptedMission> interruptedIn(const fs::path& file) {
    if (wasClosed(file)) return std::nullopt;
    const auto reader = MissionReader::open(file);
    if (!reader || (!reader->salvaged() && isRecorded(file))) return std::nullopt;
    const auto info = reader->info();
    if (!info) return std::nullopt;
    return InterruptedMission{file, *info};
}

std::optional<InterruptedMission> findInterrupted(const fs::path& folder) {
    const std::optional<fs::path> newest = newestMission(folder);
    return newest ? interruptedIn(*newest) : std::nullopt;
}

Result<void> closeInterrupted(const fs::path& file) {
    // The reader goes first: only the last one who closes a database moves its log into it.
    bool damaged = false;
    const auto info = MissionReader::open(file).and_then([&](const MissionReader& mission) {
        damaged = mission.salvaged().has_value();
        return mission.info();
    });
    if (!info) return tl::make_unexpected(info.error());
    if (damaged) return {};  // its log is part of what is left of it
    return MissionWriter::create(file, {.start = info->start,
                                        .program_version = info->program_version,
                                        .first_time_s = info->duration_s})
        .map([](const MissionWriter&) {});
}

}  // namespace hedr
