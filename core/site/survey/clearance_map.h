#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/frames.h"
#include "core/site/free_space.h"

namespace hedr {

struct PlanGround {};  // metres from a plan's upper left corner, x right, y up: the plan has y < 0

// A plan as a robot feels it: how far it is to the next wall.
class ClearanceMap {
  public:
    // `resolution_m` of a plan pixel. Cells are 0.05 m; larger where the plan's own are, or where
    // there would be more than four million. A cell with some wall in it is a wall.
    ClearanceMap(const FreeSpace& space, double resolution_m);

    double width_m() const { return width_ * cell_m_; }
    double height_m() const { return height_ * cell_m_; }

    // 0 in a wall; kFar_m where there is none, and beside the plan.
    double toWall_m(Point<PlanGround> p) const {
        return static_cast<double>(to_wall_m_[indexOf(p)]);
    }
    // To where it is not known to be free; 0 there, and beside the plan.
    double toUnfree_m(Point<PlanGround> p) const {
        return static_cast<double>(to_unfree_m_[indexOf(p)]);
    }
    // To the first wall in the direction of a unit vector, at most `longest_m`.
    double clearance_m(Point<PlanGround> p, Vector<PlanGround> direction, double longest_m) const;

    static constexpr float kFar_m = 1000.0F;

  private:
    std::size_t indexOf(Point<PlanGround> p) const;

    int width_ = 0;
    int height_ = 0;
    double cell_m_ = 0.05;
    // Row by row, and one more cell for all that is beside the plan.
    std::vector<float> to_wall_m_;
    std::vector<float> to_unfree_m_;
};

}  // namespace hedr
