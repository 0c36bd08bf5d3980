#include "core/site/survey/trail_pose.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>

#include "core/geometry/angle.h"

namespace hedr {

Transform<Ground, World> TrailPose::groundFromTrail() const {
    return {scale * Eigen::Rotation2Dd(rotation_rad).toRotationMatrix(), {middle.x, middle.y}};
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
