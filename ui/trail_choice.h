#pragma once

#include <map>
#include <string>

namespace hedr {

// Which trails the operator wants to see, and which of them carries the robot. Wishes about trails
// that this robot does not give are kept for the next one that does.
struct TrailChoice {
    std::string primary{};                // empty, or not there: the first of trailStyles()
    std::map<std::string, bool> shown{};  // the others: as trailStyles() says
    friend bool operator==(const TrailChoice&, const TrailChoice&) = default;
};

bool isShown(const TrailChoice& choice, const std::string& trail);

}  // namespace hedr
