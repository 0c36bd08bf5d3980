#include "tests/core/site/survey/picked_walls.h"

#include <cmath>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

// The wall's own angle: the straight line by least squares through the wall cells
// within a few pixels of the picked line, narrowed in steps.
struct WallLine {
    double angle_rad = 0.0;
    double length_px = 0.0;
    double scatter_px = 0.0;
};

int greyAt(const PlanLevel& map, int column, int row) {
    return (*map.pixels)[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.width_px) +
                         static_cast<std::size_t>(column)];
}

// Dark cells beside free ones.
std::vector<Point<Plan>> rimOf(const PlanLevel& map) {
    const auto isFree = [&](int column, int row) { return greyAt(map, column, row) >= 206; };
    std::vector<Point<Plan>> rim;
    for (int row = 1; row + 1 < map.height_px; ++row) {
        for (int column = 1; column + 1 < map.width_px; ++column) {
            const bool beside = isFree(column - 1, row) || isFree(column + 1, row) ||
                                isFree(column, row - 1) || isFree(column, row + 1);
            if (beside && greyAt(map, column, row) < 130) rim.push_back({column + 0.5, row + 0.5});
        }
    }
    return rim;
}

WallLine lineAt(const std::vector<Point<Plan>>& rim, const PickedWall& wall) {
    const Vector<Plan> way = wall.to - wall.from;
    const double length_px = way.length();
    const Vector<Plan> along = (1.0 / length_px) * way;
    double offset = 0.0;
    double slope = 0.0;
    double scatter = 0.0;
    for (double reach = 6.0; reach > 2.5; reach *= 0.85) {
        Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
        Eigen::Vector2d right = Eigen::Vector2d::Zero();
        double squares = 0.0;
        for (const Point<Plan>& p : rim) {
            const Vector<Plan> d = p - wall.from;
            const double t = along.x * d.x + along.y * d.y;
            const double aside = along.x * d.y - along.y * d.x;
            const double rest = aside - (offset + slope * t);
            if (t < 0.0 || t > length_px || std::abs(rest) > reach) continue;
            const Eigen::Vector2d row(1.0, t);
            normal += row * row.transpose();
            right += aside * row;
            squares += rest * rest;
        }
        if (normal(0, 0) < 0.3 * length_px) return {};
        scatter = std::sqrt(squares / normal(0, 0));
        const Eigen::Vector2d line = normal.inverse() * right;
        offset = line(0);
        slope = line(1);
    }
    return {-std::atan2(along.y + slope * along.x, along.x - slope * along.y), length_px, scatter};
}

}  // namespace

double pickedDirection_rad(const PlanLevel& map, const std::vector<PickedWall>& walls) {
    const std::vector<Point<Plan>> rim = rimOf(map);
    double reference = std::nan("");
    double sum = 0.0;
    double moment = 0.0;
    for (const PickedWall& wall : walls) {
        const WallLine line = lineAt(rim, wall);
        if (line.length_px == 0.0 || line.scatter_px > 1.2) continue;
        if (std::isnan(reference)) reference = line.angle_rad;
        const double weight = line.length_px * line.length_px;
        sum += weight;
        moment += weight * deviationFromGrid(line.angle_rad - reference, kPi / 2);
    }
    return reference + moment / sum;
}

}  // namespace hedr
