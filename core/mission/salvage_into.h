#pragma once

// Private to core/mission: salvage into a database that is open.

#include <SQLiteCpp/SQLiteCpp.h>

#include "core/mission/mission_salvage.h"

namespace hedr {

// `out` is empty, and a mission afterwards. Errors: those of salvageMission that are about the
// damaged file. Throws what SQLite throws about `out`.
Result<SalvageReport> salvageInto(SQLite::Database& out, const std::filesystem::path& damaged);

}  // namespace hedr
