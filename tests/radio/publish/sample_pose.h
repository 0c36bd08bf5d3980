#pragma once

#include "core/geometry/angle.h"
#include "radio/publish/published_pose.h"

namespace hedr::test {

inline ReceiveClock::time_point receiveMoment(double seconds) {
    return ReceiveClock::time_point(std::chrono::duration_cast<ReceiveClock::duration>(
        std::chrono::duration<double>(10'000.0 + seconds)));
}

// 2026-05-04 09:08:07.250 UTC, and `seconds` of the receive clock.
inline PublishTime sampleTime(double seconds) {
    const auto utc = std::chrono::system_clock::time_point(std::chrono::seconds(1777885687)) +
                     std::chrono::milliseconds(250);
    return {receiveMoment(seconds), utc};
}

// In the point of the tie, at 48.1374 N 11.5755 E, along the x axis, which runs to 78 degrees;
// heard at 0 s.
inline PublishedPose samplePose() {
    PublishedPose pose;
    pose.chosen = true;
    pose.call_sign = "Robot 1";
    pose.heard = receiveMoment(0.0);
    pose.pose = {{12.5, -3.25}, 0.0};
    pose.speed_m_s = 0.62;
    pose.trust = PublishedTrust::kGood;
    pose.estimator = "hedr_bayes";
    pose.floor = "Ground";
    pose.variance = {0.25F, 0.0F, 0.04F, 0.0025F};
    pose.tie = GeoTie{{12.5, -3.25}, {48.1374, 11.5755}, radFromDeg(-12.0)};
    return pose;
}

}  // namespace hedr::test
