#include "core/track/detail_levels.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

namespace hedr {
namespace {

// Squared distance of p from the segment a..b (not from the line: a trail may turn back).
double squaredDistance(Point<World> p, Point<World> a, Vector<World> ab, double inverse_length2) {
    const Vector<World> ap = p - a;
    const double along = std::clamp((ap.x * ab.x + ap.y * ab.y) * inverse_length2, 0.0, 1.0);
    const double dx = ap.x - along * ab.x;
    const double dy = ap.y - along * ab.y;
    return dx * dx + dy * dy;
}

struct Farthest {
    std::size_t index;
    double squared_distance;
};

Farthest farthestBetween(std::span<const Point<World>> points, std::size_t first,
                         std::size_t last) {
    const Vector<World> ab = points[last] - points[first];
    const double length2 = ab.x * ab.x + ab.y * ab.y;
    const double inverse = length2 > 0.0 ? 1.0 / length2 : 0.0;
    Farthest farthest{first + 1, -1.0};
    for (std::size_t i = first + 1; i < last; ++i) {
        const double d2 = squaredDistance(points[i], points[first], ab, inverse);
        if (d2 > farthest.squared_distance) farthest = {i, d2};
    }
    return farthest;
}

// The tolerance (squared) from which on Douglas-Peucker drops each point. A point never outlives
// the one that its part was split at, which makes one pass good for all tolerances.
std::vector<double> squaredSignificances(std::span<const Point<World>> points) {
    struct Part {
        std::size_t first;
        std::size_t last;
        double squared_limit;
    };
    std::vector<double> significances(points.size(), std::numeric_limits<double>::infinity());
    std::vector<Part> parts = {{0, points.size() - 1, std::numeric_limits<double>::infinity()}};
    while (!parts.empty()) {
        const auto [first, last, limit] = parts.back();
        parts.pop_back();
        if (last - first < 2) continue;
        const Farthest farthest = farthestBetween(points, first, last);
        const double significance = std::min(limit, farthest.squared_distance);
        significances[farthest.index] = significance;
        parts.push_back({first, farthest.index, significance});
        parts.push_back({farthest.index, last, significance});
    }
    return significances;
}

double toleranceOf(int level) { return std::ldexp(DetailLevels::kFinest_m, level); }

}  // namespace

DetailLevels::DetailLevels(std::span<const Point<World>> points) {
    assert(!points.empty() && points.size() <= kPoints);
    const std::vector<double> significances = squaredSignificances(points);
    for (std::size_t level = 0; level < kLevels; ++level) {
        const double tolerance = toleranceOf(static_cast<int>(level));
        for (std::size_t i = 0; i < points.size(); ++i)
            if (significances[i] > tolerance * tolerance)
                kept_[level][i / 64] |= std::uint64_t{1} << (i % 64);
    }
}

int DetailLevels::levelWithin(double tolerance_m) {
    int level = kEveryPoint;
    while (level + 1 < static_cast<int>(kLevels) && toleranceOf(level + 1) <= tolerance_m) ++level;
    return level;
}

}  // namespace hedr
