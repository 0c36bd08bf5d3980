#pragma once

#include <filesystem>
#include <optional>

#include "core/mission/mission.h"
#include "core/result.h"

namespace hedr {

struct InterruptedMission {
    std::filesystem::path file;
    MissionInfo info{};
};

// The mission in that file, if whoever recorded it did not close it and nobody records it now.
// None, too, where it cannot be read: its own error comes when it is opened.
std::optional<InterruptedMission> interruptedIn(const std::filesystem::path& file);

// The same of the newest mission in the folder.
std::optional<InterruptedMission> findInterrupted(const std::filesystem::path& folder);

// Closes a mission that was interrupted and shall not go on. Errors: those of MissionWriter.
Result<void> closeInterrupted(const std::filesystem::path& file);

}  // namespace hedr
