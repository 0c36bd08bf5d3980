#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/result.h"

namespace hedr {

// What came out of a damaged mission.
struct SalvageReport {
    std::uint64_t stream_rows = 0;
    std::uint64_t stream_rows_missing = 0;  // between those that were found
    std::uint64_t other_rows = 0;           // vehicle, plan, site, events, link, estimates
    double recovered_s = 0.0;               // of the stream, without its holes
    double duration_s = 0.0;                // as far as anything in the file tells
    std::uint64_t pages_missing = 0;        // cut off at the file's end
    std::uint64_t pages = 0;                // that the file had
    bool start_known = false;               // the wall clock's time at the start
    bool rejected_missing = false;          // which frames were not believed
};

// Writes what is still in a mission file that cannot be read any more, and in its log where that is
// left, into a new one. The damaged file stays as it is. Errors: kFileMissing, kFileUnreadable,
// kNotAMission, kFileUnwritable, kFileExists, kDiskFull.
Result<SalvageReport> salvageMission(const std::filesystem::path& damaged,
                                     const std::filesystem::path& out);

// Where it goes if nobody says otherwise: DAMAGED.recovered.hedr, from number 2 on
// DAMAGED.recovered-2.hedr.
std::filesystem::path recoveredFile(const std::filesystem::path& damaged, int number = 1);

// One or two sentences: "recovered 61.2 of at least 62.0 s; missing: …".
std::string describe(const SalvageReport& report);

}  // namespace hedr
