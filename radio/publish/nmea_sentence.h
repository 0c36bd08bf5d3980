#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "radio/publish/published_pose.h"

namespace hedr {

// What a satellite receiver would say, three sentences: RMC (place, speed, course), GGA (place) and
// HDT (heading), each with its checksum and CR LF. Mode "E" and quality 6 say that it is dead
// reckoning. A pose that is stale, not finite, not on the globe, or none: status V, quality 0, and
// no place. docs/publishing.md has every field.
std::string nmeaSentences(const std::optional<PublishedPose>& pose, const PublishTime& time);

// "$" + body + "*" + checksum + CR LF.
std::string nmeaSentence(std::string_view body);

// "4807.03800,N" and "01131.00000,E": degrees and minutes, to 1.9 cm.
std::string nmeaLatitude(double latitude_deg);
std::string nmeaLongitude(double longitude_deg);

}  // namespace hedr
