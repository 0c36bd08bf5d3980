#include "core/site/survey/trail_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/site/survey/driving_score.h"

namespace hedr {
namespace {

double meanScore(const ClearanceMap& map, const std::vector<TrailSample>& samples,
                 const TrailPose& pose, double softness_m) {
    const Transform<PlanGround, World> to_ground = pose.groundFromTrail();
    double sum = 0.0;
    for (const TrailSample& sample : samples) {
        const Vector<PlanGround> way = to_ground * sample.direction;
        sum += drivingScore(map, pose.middle + to_ground * sample.from_middle, way, softness_m);
    }
    return sum / static_cast<double>(samples.size());
}

double meanRadius_m(const std::vector<TrailSample>& samples) {
    double sum_m = 0.0;
    for (const TrailSample& sample : samples) sum_m += sample.from_middle.length();
    return std::max(1.0, sum_m / static_cast<double>(samples.size()));
}

std::array<TrailPose, 6> neighboursOf(const TrailPose& pose, double step_m, double radius_m) {
    std::array<TrailPose, 6> next;
    next.fill(pose);
    for (const std::size_t side : {0U, 1U}) {
        const double signed_m = side == 0 ? step_m : -step_m;
        next[side].middle.x += signed_m;
        next[2 + side].middle.y += signed_m;
        next[4 + side].rotation_rad += signed_m / radius_m;
    }
    return next;
}

}  // namespace

TrailPose fitTrail(const ClearanceMap& map, const std::vector<TrailSample>& samples, TrailPose pose,
                   const TrailFit& fit) {
    const double radius_m = meanRadius_m(samples);
    pose.score = meanScore(map, samples, pose, fit.softness_m);
    for (double step_m = fit.first_step_m; step_m >= fit.last_step_m;) {
        const double before = pose.score;
        for (TrailPose next : neighboursOf(pose, step_m, radius_m)) {
            next.score = meanScore(map, samples, next, fit.softness_m);
            if (next.score > pose.score) pose = next;
        }
        if (pose.score <= before) step_m *= 0.5;
    }
    return pose;
}

}  // namespace hedr
