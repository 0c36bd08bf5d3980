#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "core/site/control_points.h"

namespace hedr::test {

using Points = std::vector<ControlPoint>;
using RandomBits = std::mt19937_64;

inline constexpr int kHeight_px = 1500;
inline constexpr double kWidth_px = 2000.0;

inline Point<World> placed(Point<Plan> p, const PlanPlacement& placement) {
    PlanImage image;
    image.levels = {{static_cast<int>(kWidth_px), kHeight_px, 1, {}}};
    image.placement = placement;
    return image.worldFromPlan() * p;
}

inline double uniform(RandomBits& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

inline PlanPlacement randomPlacement(RandomBits& random, double farthest_m = 1000.0) {
    return {std::exp(uniform(random, std::log(0.005), std::log(2.0))),
            {{uniform(random, -farthest_m, farthest_m), uniform(random, -farthest_m, farthest_m)},
             uniform(random, -3.1, 3.1)}};
}

inline Points randomPoints(RandomBits& random, std::size_t count, const PlanPlacement& placement,
                           double noise_m) {
    std::normal_distribution<double> noise(0.0, 1.0);
    Points points(count);
    for (ControlPoint& p : points) {
        p.plan = {uniform(random, 0.0, kWidth_px), uniform(random, 0.0, kHeight_px)};
        p.world = placed(p.plan, placement) +
                  Vector<World>{noise_m * noise(random), noise_m * noise(random)};
    }
    return points;
}

}  // namespace hedr::test
