#include "ui/trail_choice.h"

#include "ui/trail_style.h"

namespace hedr {

bool isShown(const TrailChoice& choice, const std::string& trail) {
    const auto wish = choice.shown.find(trail);
    return wish == choice.shown.end() ? trailStyle(trail).shown_at_first : wish->second;
}

}  // namespace hedr
