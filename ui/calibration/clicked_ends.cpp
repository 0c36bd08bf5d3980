#include "ui/calibration/clicked_ends.h"

#include <algorithm>

namespace hedr {

ClickedEnds::Next ClickedEnds::next() const {
    if (marks_.empty()) return Next::kStart;
    return marks_.size() < kFirstEnd ? Next::kAhead : Next::kEnd;
}

std::size_t ClickedEnds::nextRun() const { return runOf(std::max(marks_.size(), kFirstEnd)); }

// Start and ahead are never skipped.
bool ClickedEnds::fits(std::size_t mark, Point<World> place) const {
    if (mark >= kFirstEnd || marks_.size() + (mark == 1 ? 1 : 0) < kFirstEnd) return true;
    const Point<World> other = *marks_[mark == 0 ? 1 : 0];
    return (place - other).length() >= kLeastAhead_m;
}

bool ClickedEnds::add(Point<World> place) {
    if (!fits(marks_.size(), place)) return false;
    marks_.emplace_back(place);
    return true;
}

void ClickedEnds::skipRun() {
    if (next() == Next::kEnd) marks_.emplace_back();
}

bool ClickedEnds::move(std::size_t mark, Point<World> place) {
    if (mark >= marks_.size() || !fits(mark, place)) return false;
    marks_[mark] = place;
    return true;
}

std::optional<Vector<Robot>> ClickedEnds::wayTo(Point<World> place) const {
    if (next() != Next::kEnd) return std::nullopt;
    const Vector<World> side = *marks_[1] - *marks_[0];
    const Vector<World> way = place - *marks_[0];
    const double length_m = side.length();
    return Vector<Robot>{(way.x * side.x + way.y * side.y) / length_m,
                         (side.x * way.y - side.y * way.x) / length_m};
}

std::vector<UmbmarkEnd> ClickedEnds::ends() const {
    std::vector<UmbmarkEnd> ends;
    for (std::size_t i = kFirstEnd; i < marks_.size(); ++i) {
        if (marks_[i]) ends.push_back({runOf(i), *wayTo(*marks_[i])});
    }
    return ends;
}

}  // namespace hedr
