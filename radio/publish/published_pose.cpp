#include "radio/publish/published_pose.h"

#include <QDateTime>
#include <algorithm>
#include <cmath>

#include "core/geometry/angle.h"
#include "radio/link/link_age.h"

namespace hedr {

namespace {

constexpr double kBackwards_m_s = -0.02;  // a standing robot's noise does not turn its course round

double degrees0To360(double deg) {
    const double wrapped = deg - 360.0 * std::floor(deg / 360.0);
    return wrapped < 360.0 ? wrapped : 0.0;  // of a tiny negative angle rounding makes 360
}

}  // namespace

bool isFinite(const PublishedPose& pose) {
    return std::isfinite(pose.pose.position.x) && std::isfinite(pose.pose.position.y) &&
           std::isfinite(pose.pose.heading_rad) && std::isfinite(pose.speed_m_s);
}

double ageOf(const PublishedPose& pose, const PublishTime& time) {
    // It may have been heard a moment after the clock was read.
    return std::max(0.0, std::chrono::duration<double>(time.now - pose.heard).count());
}

bool isStale(const PublishedPose& pose, const PublishTime& time) {
    return ageOf(pose, time) >= kStaleAfter_s;
}

std::chrono::system_clock::time_point momentOf(const PublishedPose& pose, const PublishTime& time) {
    const auto age = std::max(ReceiveClock::duration::zero(), time.now - pose.heard);
    return time.utc - std::chrono::duration_cast<std::chrono::system_clock::duration>(age);
}

Result<GlobePose> onGlobe(const PublishedPose& pose) {
    if (!pose.tie) return fail(ErrorCode::kNotOnGlobe, pose.call_sign);
    const auto at = latLonOf(pose.pose.position, *pose.tie);
    if (!at) return tl::make_unexpected(at.error());
    // Meridians converge: at 48 degrees a kilometre from the tie by 0.01 degrees, which is let be.
    const double bearing_deg =
        degFromRad(pose.tie->bearing_of_y_rad + kPi / 2.0 - pose.pose.heading_rad);
    const bool backwards = pose.speed_m_s < kBackwards_m_s;
    return GlobePose{*at, degrees0To360(bearing_deg),
                     degrees0To360(backwards ? bearing_deg + 180.0 : bearing_deg)};
}

std::optional<double> sigmaOf(const PublishedPose& pose) {
    const PoseVariance& v = pose.variance;
    if (!v.known()) return std::nullopt;
    const double x = static_cast<double>(v.var_x_m2);
    const double y = static_cast<double>(v.var_y_m2);
    const double half_difference = 0.5 * (x - y);
    const double largest =
        0.5 * (x + y) + std::hypot(half_difference, static_cast<double>(v.cov_xy_m2));
    if (!std::isfinite(largest)) return std::nullopt;
    return std::sqrt(std::max(0.0, largest));
}

const char* trustWord(PublishedTrust trust) {
    switch (trust) {
        case PublishedTrust::kGood:
            return "good";
        case PublishedTrust::kCoasting:
            return "coasting";
        case PublishedTrust::kLostLock:
            return "lost lock";
        case PublishedTrust::kOff:
            break;
    }
    return "off";
}

QString utcText(std::chrono::system_clock::time_point moment) {
    const auto since_1970 =
        std::chrono::floor<std::chrono::milliseconds>(moment.time_since_epoch());
    return QDateTime::fromMSecsSinceEpoch(since_1970.count(), Qt::UTC).toString(Qt::ISODateWithMs);
}

}  // namespace hedr
