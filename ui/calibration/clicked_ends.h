#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/calibration/squares/umbmark_ends.h"
#include "core/geometry/frames.h"

namespace hedr {

// Where square drives began and ended, clicked on a map one after the other: the mark of the start,
// a place straight ahead of it along the first side, then the end of each run.
class ClickedEnds {
  public:
    enum class Next : unsigned char { kStart, kAhead, kEnd };
    // A line any shorter does not tell the direction of the first side.
    static constexpr double kLeastAhead_m = 1.0;
    static constexpr std::size_t kFirstEnd = 2;

    ClickedEnds() = default;
    // The ends of the runs before are known otherwise.
    explicit ClickedEnds(std::size_t first_run) : first_run_(first_run) {}

    Next next() const;
    std::size_t nextRun() const;   // whose end comes next, once the axes are known
    bool add(Point<World> place);  // as what comes next; false: too near to the start
    void skipRun();                // its end is not known
    bool move(std::size_t mark, Point<World> place);  // in the order of marks(); false: as for add

    // Start, ahead, then from kFirstEnd on the ends; none where a run was skipped.
    const std::vector<std::optional<Point<World>>>& marks() const { return marks_; }
    std::size_t runOf(std::size_t mark) const { return first_run_ + mark - kFirstEnd; }
    // In the axes of the start; none before they are known.
    std::optional<Vector<Robot>> wayTo(Point<World> place) const;
    std::vector<UmbmarkEnd> ends() const;

    friend bool operator==(const ClickedEnds&, const ClickedEnds&) = default;

  private:
    bool fits(std::size_t mark, Point<World> place) const;

    std::size_t first_run_ = 1;
    std::vector<std::optional<Point<World>>> marks_{};
};

}  // namespace hedr
