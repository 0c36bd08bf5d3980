#pragma once

#include <map>
#include <string>
#include <vector>

#include "radio/live_batch.h"

namespace hedr {

using GatheredTracks = std::map<std::string, std::vector<TrackPoint>>;

// What each batch brings anew, at the end of what came before.
inline void gather(GatheredTracks& tracks, const LiveBatch& batch) {
    for (const NamedPoints& part : batch.tracks) {
        auto& track = tracks[part.name];
        track.insert(track.end(), part.points.begin(), part.points.end());
    }
}

}  // namespace hedr
