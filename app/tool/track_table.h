#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/fusion/lost_times.h"
#include "core/result.h"
#include "core/track/track.h"

namespace hedr::tool {

struct NamedTrack {
    std::string name;
    std::vector<TrackPoint> points;
    LostTimes lost{};
};

using Truth = std::optional<std::vector<TrackPoint>>;

// One row per track, each of which has points: where it ends, and how uncertain that is where the
// method says so; what that means is said below. With a truth also how far it was from it
// (alignment: start), in the words of `hedr evaluate`. Errors: those of compare().
Result<std::string> trackTable(const std::vector<NamedTrack>& tracks, const Truth& truth);

// Each of them as NAME.csv in the folder, which is made. Errors: kFileUnwritable, kDiskFull.
Result<void> saveTracks(const std::filesystem::path& folder, const std::vector<NamedTrack>& tracks);

// The columns below each other: the first one to the left, numbers to the right.
std::string aligned(const std::vector<std::vector<std::string>>& rows);

}  // namespace hedr::tool
