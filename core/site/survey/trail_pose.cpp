#include "core/site/survey/trail_pose.h"

#include <algorithm>
#include <functional>

#include "core/geometry/angle.h"

namespace hedr {

Transform<PlanGround, World> TrailPose::groundFromTrail() const {
    return rigidTransform<PlanGround, World>({middle, rotation_rad});
}

void sortByScore(std::vector<TrailPose>& poses) {
    std::ranges::stable_sort(poses, std::greater{}, &TrailPose::score);
}

std::vector<TrailPose> distinct(const std::vector<TrailPose>& sorted, double distance_m,
                                double angle_rad, std::size_t most) {
    std::vector<TrailPose> kept;
    for (const TrailPose& pose : sorted) {
        const auto is_near = [&](const TrailPose& better) {
            return (better.middle - pose.middle).length() < distance_m &&
                   std::abs(wrapAngle(better.rotation_rad - pose.rotation_rad)) < angle_rad;
        };
        if (kept.size() < most && std::ranges::none_of(kept, is_near)) kept.push_back(pose);
    }
    return kept;
}

}  // namespace hedr
