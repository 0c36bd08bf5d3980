#pragma once

// Private to core/mission: a mission's database as its reader needs it.

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>
#include <memory>

#include "core/result.h"

namespace hedr {

// For reading, all of it: the pages are looked through, which takes a fifth of a second for eight
// hours. Errors: kNotAMission, kMissionTooNew, kMissionDamaged, kFileUnreadable. Throws what SQLite
// throws.
Result<std::unique_ptr<SQLite::Database>> openWhole(const std::filesystem::path& file);

}  // namespace hedr
