#include "core/site/survey/perspective.h"

namespace hedr {

// The corners' equations solved by hand, as in P. Heckbert, Fundamentals of Texture Mapping and
// Image Warping (1989), section 2.2.3.
Perspective<Plan, UnitSquare> photoFromUnitSquare(const Quad& quad) {
    const auto& [p0, p1, p2, p3] = quad.corners;
    Eigen::Matrix2d sides;
    sides << p1.x - p2.x, p3.x - p2.x, p1.y - p2.y, p3.y - p2.y;
    const Eigen::Vector2d skew(p0.x - p1.x + p2.x - p3.x, p0.y - p1.y + p2.y - p3.y);
    const Eigen::Vector2d g = sides.inverse() * skew;
    Eigen::Matrix3d matrix;
    matrix << p1.x - p0.x + g.x() * p1.x, p3.x - p0.x + g.y() * p3.x, p0.x,  //
        p1.y - p0.y + g.x() * p1.y, p3.y - p0.y + g.y() * p3.y, p0.y,        //
        g.x(), g.y(), 1.0;
    return Perspective<Plan, UnitSquare>(matrix);
}

}  // namespace hedr
