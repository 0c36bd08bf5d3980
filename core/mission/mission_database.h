#pragma once

// Private to core/mission: what its writer and reader share about SQLite.

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>
#include <type_traits>

#include "core/result.h"

namespace hedr {

inline constexpr int kMissionApplicationId = 0x48454452;  // "HEDR"
inline constexpr int kMissionSchema = 3;
inline constexpr int kFirstSchemaWithSite = 2;
inline constexpr int kFirstSchemaWithLink = 3;
inline constexpr int kBusyTimeout_ms = 2000;

enum class MissionAccess { kReading, kWriting };

Error missionError(const SQLite::Exception& exception, const std::filesystem::path& file,
                   MissionAccess access);

// Tables of an empty database, in one step.
void createMissionSchema(SQLite::Database& database);

// Gives an older mission that is to go on the tables that came later; false where it has them.
bool upgradeMissionSchema(SQLite::Database& database);

int missionSchema(SQLite::Database& database);

// Whether the database is a mission that this version understands.
Result<void> checkMission(SQLite::Database& database, const std::filesystem::path& file);

// Bytes of the database and of the write-ahead log beside it.
std::uint64_t missionBytes(const std::filesystem::path& file);
std::filesystem::path missionLogFile(const std::filesystem::path& file);

// Runs `work` (which returns a Result) and makes an Error of what SQLite throws.
template <class Work>
std::invoke_result_t<Work> guarded(const std::filesystem::path& file, MissionAccess access,
                                   Work work) {
    try {
        return work();
    } catch (const SQLite::Exception& exception) {
        return tl::make_unexpected(missionError(exception, file, access));
    }
}

}  // namespace hedr
